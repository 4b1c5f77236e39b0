// The side of a cone, open at both ends; one end may be a point. What a shape answers is said at plane.glsl.
// data: 0: centre of the lower end, its radius; 1: axis, height; 2: slope of the radius, the upper end's radius

bool betweenEnds(float along, vec4 data[shapeVectors]) {
  return along >= 0.0f && along <= data[1].w && data[0].w + data[2].x * along > 0.0f;
}

// Counted from the ray's nearest point to the middle, where the numbers are small and little cancels.
float intersectShape(vec3 origin, vec3 direction, vec4 data[shapeVectors], float tMin, float tMax) {
  vec3 axis = vec3(data[1]);
  float height = data[1].w, slope = data[2].x;
  vec3 toMiddle = origin - vec3(data[0]) - 0.5f * height * axis;
  float shift = -dot(toMiddle, direction) / dot(direction, direction);
  vec3 start = toMiddle + shift * direction;
  float startAlong = dot(start, axis), rise = dot(direction, axis);
  vec3 w = start - startAlong * axis, u = direction - rise * axis;
  startAlong += 0.5f * height;
  float radius = data[0].w + slope * startAlong, growth = slope * rise;
  float a = dot(u, u) - growth * growth, b = dot(u, w) - radius * growth, c = dot(w, w) - radius * radius;
  float discriminant = b * b - a * c;
  if (!(discriminant >= 0.0f)) return -1.0f;
  float root = sqrt(discriminant), q = -(b + (b < 0.0f ? -root : root));
  float one = a != 0.0f ? q / a : 1e30f, other = q != 0.0f ? c / q : 0.0f;  // a ray along a ruling meets it once
  float first = min(one, other), second = max(one, other);
  float t = first + shift;
  if (t > tMin && t < tMax && betweenEnds(startAlong + first * rise, data)) return t;
  t = second + shift;
  return t > tMin && t < tMax && betweenEnds(startAlong + second * rise, data) ? t : -1.0f;
}

vec3 shapeNormal(vec3 point, vec4 data[shapeVectors]) {
  vec3 axis = vec3(data[1]), p = point - vec3(data[0]), away = p - dot(p, axis) * axis;
  float distance = length(away);
  return distance > 0.0f ? normalize(away / distance - data[2].x * axis) : axis;
}

float borderDistance(vec3 point, vec4 data[shapeVectors]) {
  float along = dot(point - vec3(data[0]), vec3(data[1])), height = data[1].w;
  float toBottom = data[0].w > 0.0f ? along : 1e30f, toTop = data[2].y > 0.0f ? height - along : 1e30f;
  return min(toBottom, toTop) / max(height, 2.0f * max(data[0].w, data[2].y));
}
