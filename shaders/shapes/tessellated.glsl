// A mirror whose shape has no formula here: its triangles are traced like those of the meshes, in textures, as one more
// surface that the loop over them does not visit (SurfaceStore of src/viewport). What a shape answers is said at
// plane.glsl. The answers about a point are about the one that the last ray met.
// data: unused
#include "bvh.glsl"

MeshHit mirrorHit = noMeshHit;

float intersectShape(vec3 origin, vec3 direction, vec4 data[shapeVectors], float tMin, float tMax) {
  if (surfaceSize[mirrorSurface].x == 0) return -1.0;
  float t = enterBox(origin, 1.0 / withoutZero(direction), surfaceLow[mirrorSurface].xyz,
                     surfaceHigh[mirrorSurface].xyz, tMin, tMax);
  if (t >= missed) return -1.0;
#ifdef BOXES_ONLY
  discard;  // the other program does this pixel
#endif
  MeshHit hit = noMeshHit;
  hit.tMin = tMin;
  hit.t = tMax;
  if (!intersectSurfaces(Ray(origin, direction), 1 << mirrorSurface, false, hit)) return -1.0;
  mirrorHit = hit;
  return hit.t;
}

// Of the normals at the triangle's corners the mean; w: that of their distances to the border.
vec4 meanOfCorners() {
  uvec3 corner = texelFetch(triangles, texelCoord(2 * mirrorHit.triangle + 1), 0).xyz;
  int first = surfaceOffsets[mirrorSurface].w;
  float u = mirrorHit.uv.x, v = mirrorHit.uv.y;
  return (1.0 - u - v) * texelFetch(normals, texelCoord(first + int(corner.x)), 0) +
         u * texelFetch(normals, texelCoord(first + int(corner.y)), 0) +
         v * texelFetch(normals, texelCoord(first + int(corner.z)), 0);
}

vec3 shapeNormal(vec3 point, vec4 data[shapeVectors]) {
  return unitOr(meanOfCorners().xyz, vec3(0.0, 0.0, 1.0));
}

float borderDistance(vec3 point, vec4 data[shapeVectors]) {
  return meanOfCorners().w;
}
