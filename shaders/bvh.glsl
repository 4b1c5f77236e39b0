// Rays through the trees of src/geometry/bvh.h: the binary nodes, two texels each; links and counts are plain
// numbers. Triangles are met in float without gaps between neighbours (Woop, Benthin, Wald 2013), as on the CPU.
#include "camera.glsl"
#include "texel.glsl"

uniform sampler2D nodes;       // min, link; max, count. Links count from the surface's first node.
uniform sampler2D positions;   // xyz from the surface's centre; w: 1 usable, else minus the vertex' PathStatus
uniform usampler2D triangles;  // in the order of the leaves: three vertices, three normals, two texels

const int maxVisits = 8192;  // no driver is kept busy for ever
const int stackSize = 64;    // as deep as a tree can be

struct MeshHit {
  float t;
  int surface;   // -1: nothing
  int triangle;  // index into `triangles`, of all surfaces
  vec2 uv;       // point = (1 - u - v) a + u b + v c
};

// A box is met or not.
const float missed = 1e30;

const MeshHit noMeshHit = MeshHit(1e30, -1, 0, vec2(0.0));

// A ray in a surface's coordinates. The axes are renamed so that z is the one that it runs along most; then x and y
// are sheared so that the ray becomes the z axis.
struct SurfaceRay {
  vec3 origin, inverse;
  int axis;
  vec3 shear;   // xy, and 1 / the direction's z
  float shift;  // its parameter is the world ray's minus this
};

vec3 renamed(vec3 v, int axis) {
  return axis == 2 ? v : axis == 0 ? v.yzx : v.zxy;
}

// 1 / 0 is not to be relied upon.
vec3 withoutZero(vec3 direction) {
  return mix(direction, vec3(1e-18), lessThan(abs(direction), vec3(1e-18)));
}

SurfaceRay toSurface(Ray ray, vec4 centre) {
  SurfaceRay r;
  r.origin = ray.origin - centre.xyz;
  // Far rays start where they are nearest to the centre, so that coordinates keep their digits.
  vec3 away = abs(r.origin);
  r.shift = max(away.x, max(away.y, away.z)) > 4.0 * centre.w ? -dot(r.origin, ray.direction) : 0.0;
  r.origin += r.shift * ray.direction;
  vec3 d = withoutZero(ray.direction), size = abs(d);
  r.inverse = 1.0 / d;
  r.axis = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0;
  vec3 along = renamed(d, r.axis);
  r.shear = vec3(along.xy / along.z, 1.0 / along.z);
  return r;
}

// Where a ray enters a box, from tMin to tMax; `missed` when it does not.
float enterBox(vec3 origin, vec3 inverse, vec3 low, vec3 high, float tMin, float tMax) {
  vec3 a = (low - origin) * inverse, b = (high - origin) * inverse;
  vec3 near = min(a, b), far = max(a, b);
  float first = max(max(near.x, near.y), max(near.z, tMin));
  float last = min(min(far.x, far.y), min(far.z, tMax));
  return first <= last ? first : missed;
}

// Whether the ray meets the triangle before hit.t; then it is the hit.
bool intersectTriangle(SurfaceRay r, int triangle, int firstVertex, inout MeshHit hit) {
  uvec3 corner = texelFetch(triangles, texelCoord(2 * triangle), 0).xyz;
  vec4 p0 = texelFetch(positions, texelCoord(firstVertex + int(corner.x)), 0);
  vec4 p1 = texelFetch(positions, texelCoord(firstVertex + int(corner.y)), 0);
  vec4 p2 = texelFetch(positions, texelCoord(firstVertex + int(corner.z)), 0);
  vec3 a = renamed(p0.xyz - r.origin, r.axis);
  vec3 b = renamed(p1.xyz - r.origin, r.axis);
  vec3 c = renamed(p2.xyz - r.origin, r.axis);
  a.xy -= r.shear.xy * a.z;
  b.xy -= r.shear.xy * b.z;
  c.xy -= r.shear.xy * c.z;
  // Twice the areas between origin and edges; neighbours have the same number with the other sign.
  float u = c.x * b.y - c.y * b.x, v = a.x * c.y - a.y * c.x, w = b.x * a.y - b.y * a.x;
  float least = min(min(u, v), w), most = max(max(u, v), w);
  bool inside = (least >= 0.0 && most > 0.0) || (most <= 0.0 && least < 0.0);
  float inverse = 1.0 / (u + v + w);
  float t = (u * a.z + v * b.z + w * c.z) * inverse * r.shear.z + r.shift;
  bool usable = min(p0.w, min(p1.w, p2.w)) > 0.5;
  bool met = inside && usable && t > 0.0 && t < hit.t;
  if (met) {
    hit.t = t;
    hit.triangle = triangle;
    hit.uv = vec2(v, w) * inverse;
  }
  return met;
}

// Which of the surfaces with this flag have a box that the ray meets before tMax; one bit each.
int surfacesAlong(Ray ray, int flag, float tMax) {
  vec3 inverse = 1.0 / withoutZero(ray.direction);
  int result = 0;
  for (int i = 0; i < surfaceCount; ++i) {
    bool wanted = (surfaceSize[i].y & flag) != 0;
    float t = enterBox(ray.origin, inverse, surfaceLow[i].xyz, surfaceHigh[i].xyz, 0.0, tMax);
    if (wanted && t < missed) result |= 1 << i;
  }
  return result;
}

// The nearest hit before hit.t of the surfaces whose bits are set, or any hit when that is enough. One loop for all of
// them: processors that compute pixels in groups wait less for each other, and software that does not jump over what
// is not needed has less of it.
bool intersectSurfaces(Ray ray, int surfaces, bool anyIsEnough, inout MeshHit hit) {
  // A node is kept as its link times 8 plus its count: all that is needed of it once its box is met.
  int stack[stackSize];
  int waiting = 0, node = 0, surface = 0;
  ivec4 place = ivec4(0);
  SurfaceRay r = toSurface(ray, vec4(0.0, 0.0, 0.0, 1.0));
  bool walking = false, found = false;
  for (int visit = 0; visit < maxVisits; ++visit) {
    if (!walking) {
      if (surfaces == 0) break;
      surface = (surfaces & 1) != 0 ? 0 : (surfaces & 2) != 0 ? 1 : 2;
      surfaces ^= 1 << surface;
      place = surfaceOffsets[surface];
      node = surfaceSize[surface].z;
      r = toSurface(ray, surfaceCentre[surface]);
      walking = true;
    }
    int link = node >> 3, count = node & 7;
    bool goOn = false;
    if (count > 0) {
      for (int i = 0; i < count; ++i) {
        if (intersectTriangle(r, place.y + link + i, place.z, hit)) {
          hit.surface = surface;
          found = true;
        }
      }
      if (found && anyIsEnough) break;
    } else {
      int left = 2 * (place.x + link);
      vec4 low0 = texelFetch(nodes, texelCoord(left), 0), high0 = texelFetch(nodes, texelCoord(left + 1), 0);
      vec4 low1 = texelFetch(nodes, texelCoord(left + 2), 0), high1 = texelFetch(nodes, texelCoord(left + 3), 0);
      float tMin = -r.shift, tMax = hit.t - r.shift;
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
