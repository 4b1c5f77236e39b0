// No mirror. What a shape answers is said at plane.glsl.

float intersectShape(vec3 origin, vec3 direction, vec4 data[shapeVectors], float tMin, float tMax) {
  return -1.0f;
}

vec3 shapeNormal(vec3 point, vec4 data[shapeVectors]) {
  return vec3(0.0f, 0.0f, 1.0f);
}

float borderDistance(vec3 point, vec4 data[shapeVectors]) {
  return 1.0f;
}
