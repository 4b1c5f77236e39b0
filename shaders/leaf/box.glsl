// A ray and a box. Leaf functions: numbers in, numbers out, so that a test compiles them as C++ too
// (tests/viewport/leaf_test.cpp). Literals end in f for that.

// A box is met or not.
const float missed = 1e30f;

// 1 / 0 is not to be relied upon.
vec3 withoutZero(vec3 direction) {
  return mix(direction, vec3(1e-18f), lessThan(abs(direction), vec3(1e-18f)));
}

// Where a ray enters a box, from tMin to tMax; `missed` when it does not. `inverse`: 1 / its direction.
float enterBox(vec3 origin, vec3 inverse, vec3 low, vec3 high, float tMin, float tMax) {
  vec3 a = (low - origin) * inverse, b = (high - origin) * inverse;
  vec3 nearer = min(a, b), farther = max(a, b);
  float first = max(max(nearer.x, nearer.y), max(nearer.z, tMin));
  float last = min(min(farther.x, farther.y), min(farther.z, tMax));
  return first <= last ? first : missed;
}
