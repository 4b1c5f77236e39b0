// A round dot; faint where something is before it.
#include "camera.glsl"

uniform sampler2D depth;
uniform float radius;

flat in vec3 middle;
flat in vec3 ink;
out vec4 color;

void main() {
  float alpha = clamp(radius + 0.5 - length(gl_FragCoord.xy - middle.xy), 0.0, 1.0);
  if (lineDepth(0.9995 * middle.z) > texelFetch(depth, ivec2(gl_FragCoord.xy), 0).x) alpha *= 0.3;
  color = vec4(ink * alpha, alpha);
}
