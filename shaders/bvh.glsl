// Rays through the trees of src/geometry/bvh.h: the binary nodes, two texels each; links and counts are plain
// numbers. Triangles are met in float without gaps between neighbours (Woop, Benthin, Wald 2013), as on the CPU.
#include "camera.glsl"
#include "leaf/box.glsl"
#include "leaf/triangle.glsl"
#include "texel.glsl"

uniform sampler2D nodes;       // min, link; max, count. Links count from the surface's first node.
uniform sampler2D positions;   // xyz from the surface's centre; w: 1 usable, else minus the vertex' PathStatus
uniform usampler2D triangles;  // in the order of the leaves: three vertices, three normals, two texels
uniform sampler2D normals;     // unit; w, of a mirror: to its border, as a fraction of its size

const int maxVisits = 8192;  // no driver is kept busy for ever

struct MeshHit {
  float t;
  int surface;   // -1: nothing
  int triangle;  // index into `triangles`, of all surfaces
  vec2 uv;       // point = (1 - u - v) a + u b + v c
  float tMin;    // nothing nearer counts
};

const MeshHit noMeshHit = MeshHit(1e30, -1, 0, vec2(0.0), 0.0);

FloatRay toSurface(Ray ray, int surface) {
  return makeFloatRay(ray.origin, ray.direction, surfaceCentre[surface].xyz, surfaceCentre[surface].w);
}

// Whether the ray meets the triangle between hit.tMin and hit.t; then it is the hit.
bool meetsTriangle(FloatRay r, int triangle, int firstVertex, inout MeshHit hit) {
  uvec3 corner = texelFetch(triangles, texelCoord(2 * triangle), 0).xyz;
  vec4 p0 = texelFetch(positions, texelCoord(firstVertex + int(corner.x)), 0);
  vec4 p1 = texelFetch(positions, texelCoord(firstVertex + int(corner.y)), 0);
  vec4 p2 = texelFetch(positions, texelCoord(firstVertex + int(corner.z)), 0);
  TriangleHit here = passesThrough(r, p0.xyz, p1.xyz, p2.xyz);
  bool usable = min(p0.w, min(p1.w, p2.w)) > 0.5;
  bool met = here.met && usable && here.t > hit.tMin && here.t < hit.t;
  if (met) {
    hit.t = here.t;
    hit.triangle = triangle;
    hit.uv = vec2(here.u, here.v);
  }
  return met;
}

// Which of the meshes with this flag have a box that the ray meets before tMax; one bit each.
int surfacesAlong(Ray ray, int flag, float tMax) {
  vec3 inverse = 1.0 / withoutZero(ray.direction);
  int result = 0;
  for (int i = 0; i < meshCount; ++i) {
    bool wanted = (surfaceSize[i].y & flag) != 0;
    float t = enterBox(ray.origin, inverse, surfaceLow[i].xyz, surfaceHigh[i].xyz, 0.0, tMax);
    if (wanted && t < missed) result |= 1 << i;
  }
  return result;
}

// The nearest hit between hit.tMin and hit.t of the surfaces whose bits are set, or any hit when that is enough. One loop for all of
// them: processors that compute pixels in groups wait less for each other, and software that does not jump over what
// is not needed has less of it.
bool intersectSurfaces(Ray ray, int surfaces, bool anyIsEnough, inout MeshHit hit) {
  // A node is kept as its link times 8 plus its count: all that is needed of it once its box is met.
  int stack[stackSize];
  int waiting = 0, node = 0, surface = 0;
  ivec4 place = ivec4(0);
  FloatRay r = toSurface(ray, 0);
  bool walking = false, found = false;
  for (int visit = 0; visit < maxVisits; ++visit) {
    if (!walking) {
      if (surfaces == 0) break;
      surface = (surfaces & 1) != 0 ? 0 : (surfaces & 2) != 0 ? 1 : (surfaces & 4) != 0 ? 2 : 3;
      surfaces ^= 1 << surface;
      place = surfaceOffsets[surface];
      node = surfaceSize[surface].z;
      r = toSurface(ray, surface);
      walking = true;
    }
    int link = node >> 3, count = node & 7;
    bool goOn = false;
    if (count > 0) {
      for (int i = 0; i < count; ++i) {
        if (meetsTriangle(r, place.y + link + i, place.z, hit)) {
          hit.surface = surface;
          found = true;
        }
      }
      if (found && anyIsEnough) break;
    } else {
      int left = 2 * (place.x + link);
      vec4 low0 = texelFetch(nodes, texelCoord(left), 0), high0 = texelFetch(nodes, texelCoord(left + 1), 0);
      vec4 low1 = texelFetch(nodes, texelCoord(left + 2), 0), high1 = texelFetch(nodes, texelCoord(left + 3), 0);
      float tMin = hit.tMin - r.shift, tMax = hit.t - r.shift;
      float t0 = enterBox(r.origin, r.inverse, low0.xyz, high0.xyz, tMin, tMax);
      float t1 = enterBox(r.origin, r.inverse, low1.xyz, high1.xyz, tMin, tMax);
      int node0 = int(low0.w) * 8 + int(high0.w), node1 = int(low1.w) * 8 + int(high1.w);
      bool rightFirst = t1 < t0;
      node = rightFirst ? node1 : node0;
      goOn = min(t0, t1) < missed;
      if (max(t0, t1) < missed && waiting < stackSize) stack[waiting++] = rightFirst ? node0 : node1;
    }
    if (!goOn) {
      walking = waiting > 0;
      if (walking) node = stack[--waiting];
    }
  }
  return found;
}
