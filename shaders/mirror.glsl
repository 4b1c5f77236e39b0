// The mirror of the scene. Its shape is one file of shapes/, chosen when the program is made; a program for one shape
// only is shorter, which counts where software draws. What is cut away of it lets light pass.
#include "camera.glsl"
#include SHAPE

// From the planes that cut the mirror off, as a fraction of its size; negative where it is cut away.
float cutDistance(vec3 point) {
  float nearest = 1e30;
  for (int i = 0; i < options.z; ++i) nearest = min(nearest, dot(mirrorClip[i].xyz, point) - mirrorClip[i].w);
  return nearest;
}

// The distance along the ray, before tMax; -1 for none.
float intersectMirror(Ray ray, float tMax) {
  float t = 0.0;
  for (int layer = 0; layer < layerLimit; ++layer) {
    t = intersectShape(ray.origin, ray.direction, mirrorShape, t, tMax);
    if (t < 0.0 || cutDistance(ray.origin + t * ray.direction) >= 0.0) return t;
  }
  return -1.0;
}

// Unit, towards where the ray comes from. This and the next are asked of the point that a ray has met last.
vec3 mirrorNormal(vec3 point, vec3 direction) {
  vec3 normal = shapeNormal(point, mirrorShape);
  return dot(normal, direction) > 0.0 ? -normal : normal;
}

// To its border, as a fraction of its size.
float mirrorBorder(vec3 point) {
  return min(borderDistance(point, mirrorShape), cutDistance(point));
}
