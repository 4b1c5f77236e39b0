// The mirror of the scene. Its shape is one file of shapes/, chosen when the program is made; a program for one shape
// only is shorter, which counts where software draws.
#include "camera.glsl"
#include SHAPE

// The distance along the ray, before tMax; -1 for none.
float intersectMirror(Ray ray, float tMax) {
  return intersectShape(ray.origin, ray.direction, mirrorShape, 0.0, tMax);
}

// Unit, towards where the ray comes from.
vec3 mirrorNormal(vec3 point, vec3 direction) {
  vec3 normal = shapeNormal(point, mirrorShape);
  return dot(normal, direction) > 0.0 ? -normal : normal;
}
