// As triangle_id.frag.glsl, for meshes that have more triangles than the picture has pixels: then asking for each pixel
// is quicker than drawing each triangle.
#include "bvh.glsl"

uniform int wanted;  // surfaces, one bit each

out uint id;

void main() {
  MeshHit hit = noMeshHit;
  bool met = intersectSurfaces(pixelRay(gl_FragCoord.xy), wanted, false, hit);
  id = met ? uint(hit.triangle + 1) : 0u;
}
