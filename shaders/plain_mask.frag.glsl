// Where the selected thing is, for those that have a formula: the mirror, or the marker of light `light`.
#include "hit.glsl"

uniform int light;  // -1: the mirror
out vec4 mask;

void main() {
  Ray ray = pixelRay(gl_FragCoord.xy);
  float t = light < 0 ? intersectMirror(ray, 1e30) : markerHit(light, ray, 1e30);
  mask = vec4(t > 0.0 ? 1.0 : 0.0);
}
