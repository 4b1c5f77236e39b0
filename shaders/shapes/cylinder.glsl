// The side of a cylinder, open at both ends. What a shape answers is said at plane.glsl.
// data: 0: centre of the lower end, radius; 1: axis, height

vec3 acrossAxis(vec3 v, vec3 axis) {
  return v - dot(v, axis) * axis;
}

bool betweenEnds(vec3 point, vec4 data[shapeVectors]) {
  float along = dot(point - vec3(data[0]), vec3(data[1]));
  return along >= 0.0f && along <= data[1].w;
}

// The discriminant is taken at the ray's nearest point to the axis, where nothing cancels (Haines et al. 2019,
// "Precision improvements for ray/sphere intersection").
float intersectShape(vec3 origin, vec3 direction, vec4 data[shapeVectors], float tMin, float tMax) {
  vec3 axis = vec3(data[1]);
  vec3 w = acrossAxis(origin - vec3(data[0]), axis), u = acrossAxis(direction, axis);
  float a = dot(u, u);
  if (!(a > 1e-12f)) return -1.0f;
  float b = dot(u, w);
  vec3 nearest = w - (b / a) * u;
  float discriminant = data[0].w * data[0].w - dot(nearest, nearest);
  if (!(discriminant >= 0.0f)) return -1.0f;
  float root = sqrt(discriminant / a);
  float first = -b / a - root, second = -b / a + root;
  if (first > tMin && first < tMax && betweenEnds(origin + first * direction, data)) return first;
  if (second > tMin && second < tMax && betweenEnds(origin + second * direction, data)) return second;
  return -1.0f;
}

vec3 shapeNormal(vec3 point, vec4 data[shapeVectors]) {
  return normalize(acrossAxis(point - vec3(data[0]), vec3(data[1])));
}

float borderDistance(vec3 point, vec4 data[shapeVectors]) {
  float along = dot(point - vec3(data[0]), vec3(data[1]));
  return min(along, data[1].w - along) / max(data[1].w, 2.0f * data[0].w);
}
