// As mask.frag.glsl, for meshes that have more triangles than the picture has pixels (see traced_id.frag.glsl).
#include "bvh.glsl"

uniform int wanted;  // surfaces, one bit each

out vec4 mask;

void main() {
  MeshHit hit = noMeshHit;
  mask = vec4(intersectSurfaces(pixelRay(gl_FragCoord.xy), wanted, true, hit) ? 1.0 : 0.0);
}
