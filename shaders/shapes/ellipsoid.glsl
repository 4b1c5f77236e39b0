// An ellipsoid. What a shape answers is said at plane.glsl.
// data: 0: centre; 1..3: own axis, radius along it

// A vector in radii along the own axes: there it is the sphere of radius 1.
vec3 inRadii(vec3 v, vec4 data[shapeVectors]) {
  return vec3(dot(v, vec3(data[1])) / data[1].w, dot(v, vec3(data[2])) / data[2].w, dot(v, vec3(data[3])) / data[3].w);
}

// Counted from the ray's nearest point to the centre, where the numbers are small; there, the discriminant is taken as
// the sphere's is.
float intersectShape(vec3 origin, vec3 direction, vec4 data[shapeVectors], float tMin, float tMax) {
  vec3 toCentre = origin - vec3(data[0]);
  float shift = -dot(toCentre, direction) / dot(direction, direction);
  vec3 w = inRadii(toCentre + shift * direction, data), u = inRadii(direction, data);
  float a = dot(u, u), middle = -dot(u, w) / a;
  vec3 nearest = w + middle * u;
  float discriminant = 1.0f - dot(nearest, nearest);
  if (!(discriminant >= 0.0f)) return -1.0f;
  float root = sqrt(discriminant / a);
  float first = middle - root + shift, second = middle + root + shift;
  if (first > tMin && first < tMax) return first;
  return second > tMin && second < tMax ? second : -1.0f;
}

vec3 shapeNormal(vec3 point, vec4 data[shapeVectors]) {
  vec3 p = inRadii(point - vec3(data[0]), data);
  return normalize(p.x / data[1].w * vec3(data[1]) + p.y / data[2].w * vec3(data[2]) + p.z / data[3].w * vec3(data[3]));
}

float borderDistance(vec3 point, vec4 data[shapeVectors]) {
  return 1.0f;
}
