// A bowl rho^2 = 4 f h, from the vertex or a hole to its rim. What a shape answers is said at plane.glsl.
// data: 0: vertex, radius; 1: axis, focal length; 2: radius of the hole

vec3 acrossBowl(vec3 v, vec4 data[shapeVectors]) {
  return v - dot(v, vec3(data[1])) * vec3(data[1]);
}

bool isOnBowl(vec3 q, vec4 data[shapeVectors]) {
  float squared = dot(q, q);
  return squared >= data[2].x * data[2].x && squared <= data[0].w * data[0].w;
}

// Counted from the ray's nearest point to the vertex, where the numbers are small and little cancels.
float intersectShape(vec3 origin, vec3 direction, vec4 data[shapeVectors], float tMin, float tMax) {
  vec3 axis = vec3(data[1]), toVertex = origin - vec3(data[0]);
  float shift = -dot(toVertex, direction) / dot(direction, direction);
  vec3 start = toVertex + shift * direction;
  vec3 w = acrossBowl(start, data), u = acrossBowl(direction, data);
  float twiceFocal = 2.0f * data[1].w;
  float a = dot(u, u), b = dot(u, w) - twiceFocal * dot(direction, axis);
  float c = dot(w, w) - 2.0f * twiceFocal * dot(start, axis);
  float discriminant = b * b - a * c;
  if (!(discriminant >= 0.0f)) return -1.0f;
  float root = sqrt(discriminant), q = -(b + (b < 0.0f ? -root : root));
  float one = a != 0.0f ? q / a : 1e30f, other = q != 0.0f ? c / q : 0.0f;  // a ray along the axis meets it once
  float first = min(one, other), second = max(one, other);
  float t = first + shift;
  if (t > tMin && t < tMax && isOnBowl(w + first * u, data)) return t;
  t = second + shift;
  return t > tMin && t < tMax && isOnBowl(w + second * u, data) ? t : -1.0f;
}

vec3 shapeNormal(vec3 point, vec4 data[shapeVectors]) {
  return normalize(acrossBowl(point - vec3(data[0]), data) - 2.0f * data[1].w * vec3(data[1]));
}

float borderDistance(vec3 point, vec4 data[shapeVectors]) {
  float rho = length(acrossBowl(point - vec3(data[0]), data));
  float toHole = data[2].x > 0.0f ? rho - data[2].x : 1e30f;
  return min(data[0].w - rho, toHole) / (2.0f * data[0].w);
}
