// Where a ray meets the mirror, as src/optics/mirror_shapes.cpp; and its bright rim, as src/raytrace/shading.cpp.
#include "camera.glsl"

const int noMirror = 0, planeMirror = 1, cylinderMirror = 2, sphereMirror = 3;
#ifdef MIRROR_KIND
const int mirrorKind = MIRROR_KIND;  // a program for this one only: shorter, which counts where software draws
#else
#define mirrorKind counts.z
#endif

// The distance along the ray, before tMax; -1 for none.
float intersectPlane(Ray ray, float tMax) {
  float t = dot(mirrorAxis.xyz, mirror.xyz - ray.origin) / dot(mirrorAxis.xyz, ray.direction);
  if (!(t > 0.0 && t < tMax)) return -1.0;
  vec3 q = ray.origin + t * ray.direction;
  for (int i = 0; i < 4; ++i) {
    if (dot(mirrorEdges[i].xyz, q) < mirrorEdges[i].w) return -1.0;
  }
  return t;
}

bool withinEnds(Ray ray, float t) {
  if (mirrorKind == sphereMirror) return true;
  float along = dot(ray.origin + t * ray.direction - mirror.xyz, mirrorAxis.xyz);
  return along >= 0.0 && along <= mirrorAxis.w;
}

// Sphere and cylinder. The discriminant is taken at the ray's nearest point to the middle, where nothing cancels
// (Haines et al. 2019, "Precision improvements for ray/sphere intersection").
float intersectRound(Ray ray, float tMax) {
  vec3 w = ray.origin - mirror.xyz, u = ray.direction;
  if (mirrorKind == cylinderMirror) {
    w -= dot(w, mirrorAxis.xyz) * mirrorAxis.xyz;
    u -= dot(u, mirrorAxis.xyz) * mirrorAxis.xyz;
  }
  float a = dot(u, u);
  if (!(a > 1e-12)) return -1.0;
  float b = dot(u, w);
  vec3 nearest = w - (b / a) * u;
  float discriminant = mirror.w * mirror.w - dot(nearest, nearest);
  if (!(discriminant >= 0.0)) return -1.0;
  float root = sqrt(discriminant / a);
  float first = -b / a - root, second = -b / a + root;
  if (first > 0.0 && first < tMax && withinEnds(ray, first)) return first;
  if (second > 0.0 && second < tMax && withinEnds(ray, second)) return second;
  return -1.0;
}

float intersectMirror(Ray ray, float tMax) {
  if (mirrorKind == noMirror) return -1.0;
  return mirrorKind == planeMirror ? intersectPlane(ray, tMax) : intersectRound(ray, tMax);
}

// Unit, towards where the ray comes from.
vec3 mirrorNormal(vec3 point, vec3 direction) {
  vec3 normal = mirrorAxis.xyz;
  if (mirrorKind != planeMirror) {
    normal = point - mirror.xyz;
    if (mirrorKind == cylinderMirror) normal -= dot(normal, mirrorAxis.xyz) * mirrorAxis.xyz;
    normal = normalize(normal);
  }
  return dot(normal, direction) > 0.0 ? -normal : normal;
}

// To the border, as a share of the mirror's size.
float borderDistance(vec3 point) {
  if (mirrorKind == planeMirror) {
    float nearest = 1e30;
    for (int i = 0; i < 4; ++i) nearest = min(nearest, dot(mirrorEdges[i].xyz, point) - mirrorEdges[i].w);
    return nearest / mirrorAxis.w;
  }
  if (mirrorKind == sphereMirror) return 1.0;
  float along = dot(point - mirror.xyz, mirrorAxis.xyz);
  return min(along, mirrorAxis.w - along) / max(mirrorAxis.w, 2.0 * mirror.w);
}

float mirrorRim(vec3 point, float cosine) {
  float edgeOn = 1.0 - cosine / 0.22;
  float border = 2.0 - 2.0 * borderDistance(point) / 0.006;
  float rim = clamp(max(edgeOn, border), 0.0, 1.0);
  return rim * rim * (3.0 - 2.0 * rim);
}
