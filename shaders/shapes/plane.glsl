// The plane mirror: a planar convex quad. Leaf functions (leaf/box.glsl). A program is made for one shape, so every
// file of this folder has the same three functions over the shape's numbers:
//
//   intersectShape   where a ray of unit direction meets it first, tMin < t < tMax; -1 when it does not. tMin is 0, or
//                    where the ray met it before: at a place that is cut away
//   shapeNormal      unit, on either side, at a point of it
//   borderDistance   from a point of it to its border, as a fraction of its size; 1 without a border
//
// data: 0: a corner; 1: normal, longest edge; 2..5, of each edge: inward, inward . q on it

float intersectShape(vec3 origin, vec3 direction, vec4 data[shapeVectors], float tMin, float tMax) {
  vec3 normal = vec3(data[1]);
  float t = dot(normal, vec3(data[0]) - origin) / dot(normal, direction);
  if (!(t > tMin && t < tMax)) return -1.0f;
  vec3 q = origin + t * direction;
  for (int i = 2; i < 6; ++i) {
    if (dot(vec3(data[i]), q) < data[i].w) return -1.0f;
  }
  return t;
}

vec3 shapeNormal(vec3 point, vec4 data[shapeVectors]) {
  return vec3(data[1]);
}

float borderDistance(vec3 point, vec4 data[shapeVectors]) {
  float nearest = 1e30f;
  for (int i = 2; i < 6; ++i) nearest = min(nearest, dot(vec3(data[i]), point) - data[i].w);
  return nearest / data[1].w;
}
