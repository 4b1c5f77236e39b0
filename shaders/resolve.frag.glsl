// The mean of all samples as a display wants it: the tone curve of src/raytrace/image.cpp, then what is drawn in
// display colours (lines, outline) on top. Straight alpha.
#include "leaf/tone.glsl"

uniform sampler2D light;    // linear light times alpha, alpha
uniform sampler2D overlay;  // display colour times alpha, alpha
uniform int hasOverlay;

out vec4 color;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 below = texelFetch(light, pixel, 0);
  if (below.a > 0.0) below.rgb /= below.a;
  vec4 result = vec4(toDisplay(below.r), toDisplay(below.g), toDisplay(below.b), 1.0) * below.a;
  if (hasOverlay != 0) {
    vec4 above = texelFetch(overlay, pixel, 0);
    result = above + (1.0 - above.a) * result;
  }
  if (result.a > 0.0) result.rgb /= result.a;
  color = clamp(result, 0.0, 1.0);
}
