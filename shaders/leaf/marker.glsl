// The ball that stands for a light. Leaf functions (box.glsl).

// The distance along the ray, before tMax; -1 for none. From inside there is none.
float intersectMarker(vec3 origin, vec3 direction, vec3 centre, float radius, float tMax) {
  vec3 w = centre - origin;
  float along = dot(w, direction);
  vec3 side = w - along * direction;
  float inside = radius * radius - dot(side, side);
  if (inside < 0.0f) return -1.0f;
  float t = along - sqrt(inside);
  return t > 0.0f && t < tMax ? t : -1.0f;
}

// A lamp: brightest where one looks straight at it.
vec3 markerColor(vec3 light, vec3 normal, vec3 direction) {
  float most = max(light.x, max(light.y, light.z));
  float facing = clamp(-dot(normal, direction), 0.0f, 1.0f);
  return (most > 0.0f ? light / most : vec3(0.25f)) * mix(0.45f, 1.6f, facing * facing);
}
