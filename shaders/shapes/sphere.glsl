// A sphere. What a shape answers is said at plane.glsl.
// data: 0: centre, radius

// The discriminant is taken at the ray's nearest point to the centre, where nothing cancels (Haines et al. 2019,
// "Precision improvements for ray/sphere intersection").
float intersectShape(vec3 origin, vec3 direction, vec4 data[shapeVectors], float tMin, float tMax) {
  vec3 w = origin - vec3(data[0]);
  float a = dot(direction, direction), b = dot(direction, w);
  vec3 nearest = w - (b / a) * direction;
  float discriminant = data[0].w * data[0].w - dot(nearest, nearest);
  if (!(discriminant >= 0.0f)) return -1.0f;
  float root = sqrt(discriminant / a);
  float first = -b / a - root, second = -b / a + root;
  if (first > tMin && first < tMax) return first;
  return second > tMin && second < tMax ? second : -1.0f;
}

vec3 shapeNormal(vec3 point, vec4 data[shapeVectors]) {
  return normalize(point - vec3(data[0]));
}

float borderDistance(vec3 point, vec4 data[shapeVectors]) {
  return 1.0f;
}
