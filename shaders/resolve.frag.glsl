// The mean of all samples as a display wants it: the tone curve of src/raytrace/image.cpp, then what is drawn in
// display colours (lines, outline) on top. Straight alpha.

uniform sampler2D light;  // linear light times alpha, alpha
uniform sampler2D overlay;    // display colour times alpha, alpha
uniform int hasOverlay;

out vec4 color;

float toDisplay(float x) {
  if (!(x > 0.0)) return 0.0;
  if (x > 0.75) x = 0.75 + 0.25 * (1.0 - exp(-(x - 0.75) / 0.25));
  return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1.0 / 2.4) - 0.055;
}

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
