// A ray and a triangle, as src/geometry/bvh_ray.h. Leaf functions (box.glsl).

// A ray in a tree's coordinates. The axes are renamed so that z is the one that it runs along most; then x and y
// are sheared so that the ray becomes the z axis (Woop, Benthin, Wald 2013).
struct FloatRay {
  vec3 origin, inverse;
  int axis;
  vec3 shear;   // x, y, and 1 / the direction's z
  float shift;  // its parameter is the world ray's minus this
};

struct TriangleHit {
  bool met;
  float t;
  float u, v;  // point = (1 - u - v) a + u b + v c
};

vec3 renamed(vec3 v, int axis) {
  return axis == 2 ? v : axis == 0 ? vec3(v.y, v.z, v.x) : vec3(v.z, v.x, v.y);
}

// `radius`: of what is in the tree, about `centre`. Far rays start where they are nearest to the centre, so that
// coordinates keep their digits.
FloatRay makeFloatRay(vec3 origin, vec3 direction, vec3 centre, float radius) {
  FloatRay r;
  r.origin = origin - centre;
  vec3 away = abs(r.origin);
  r.shift = max(away.x, max(away.y, away.z)) > 4.0f * radius ? -dot(r.origin, direction) : 0.0f;
  r.origin += r.shift * direction;
  vec3 d = withoutZero(direction), size = abs(d);
  r.inverse = 1.0f / d;
  r.axis = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0;
  vec3 along = renamed(d, r.axis);
  r.shear = vec3(along.x / along.z, along.y / along.z, 1.0f / along.z);
  return r;
}

// A corner as the ray sees it.
vec3 sheared(FloatRay r, vec3 corner) {
  vec3 p = renamed(corner - r.origin, r.axis);
  return vec3(p.x - r.shear.x * p.z, p.y - r.shear.y * p.z, p.z);
}

// Where the ray passes through the triangle, before or behind its origin. Without gaps between neighbours.
TriangleHit passesThrough(FloatRay r, vec3 p0, vec3 p1, vec3 p2) {
  vec3 a = sheared(r, p0), b = sheared(r, p1), c = sheared(r, p2);
  // Twice the areas between origin and edges; neighbours have the same number with the other sign.
  float u = c.x * b.y - c.y * b.x, v = a.x * c.y - a.y * c.x, w = b.x * a.y - b.y * a.x;
  float least = min(min(u, v), w), most = max(max(u, v), w);
  float inverse = 1.0f / (u + v + w);
  TriangleHit hit;
  hit.met = (least >= 0.0f && most > 0.0f) || (most <= 0.0f && least < 0.0f);
  hit.t = (u * a.z + v * b.z + w * c.z) * inverse * r.shear.z + r.shift;
  hit.u = v * inverse;
  hit.v = w * inverse;
  return hit;
}

// Where the ray meets the triangle's plane, kept within the triangle: for one that is known to be seen, edge-on or
// by a hair perhaps.
TriangleHit intersectTriangle(vec3 origin, vec3 direction, vec3 a, vec3 b, vec3 c) {
  vec3 ab = b - a, ac = c - a, toA = a - origin;
  vec3 normal = cross(ab, ac), side = cross(toA, direction);
  float inverse = 1.0f / dot(normal, direction);
  TriangleHit hit;
  hit.t = dot(normal, toA) * inverse;
  hit.u = dot(side, ac) * inverse;
  hit.v = -dot(side, ab) * inverse;
  bool inside = hit.u >= 0.0f && hit.v >= 0.0f && hit.u + hit.v <= 1.0f;
  if (!inside) {
    hit.u = hit.u >= 0.0f ? min(hit.u, 1.0f) : 0.0f;
    hit.v = hit.v >= 0.0f ? min(hit.v, 1.0f - hit.u) : 0.0f;
    hit.t = dot(toA + hit.u * ab + hit.v * ac, direction);
  }
  hit.met = hit.t > 0.0f && hit.t < missed;
  return hit;
}

vec3 unitOr(vec3 v, vec3 otherwise) {
  float size = length(v);
  return size > 0.0f && size < 1e30f ? v / size : otherwise;
}
