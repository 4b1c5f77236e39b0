// What a ray meets first, as src/raytrace/scene_hit.cpp.
#include "bvh.glsl"
#include "leaf/marker.glsl"
#include "leaf/shading.glsl"
#include "leaf/ground.glsl"
#include "mirror.glsl"

struct Hit {
  int kind;
  int index;        // of the surface or the light
  float t;
  vec3 point;
  vec3 faceNormal;  // towards the ray's origin
  vec3 normal;      // to shade with, on the same side
  float fade;       // how much of the ground has become background
  vec2 wire;        // as seen along the ray, scene units: distance from the triangle's edge, its least height
};

const Hit noHit = Hit(hitNothing, 0, 1e30, vec3(0.0), vec3(0.0), vec3(0.0), 0.0, vec2(1e30));

struct Corners {
  vec3 a, b, c;
};

Corners cornersOf(int surface, int triangle) {
  uvec3 corner = texelFetch(triangles, texelCoord(2 * triangle), 0).xyz;
  int first = surfaceOffsets[surface].z;
  vec3 centre = surfaceCentre[surface].xyz;
  return Corners(centre + texelFetch(positions, texelCoord(first + int(corner.x)), 0).xyz,
                 centre + texelFetch(positions, texelCoord(first + int(corner.y)), 0).xyz,
                 centre + texelFetch(positions, texelCoord(first + int(corner.z)), 0).xyz);
}

#ifdef WIRES
// How far the point is from the line through a along `edge`, as seen along the direction.
float seenDistance(vec3 point, vec3 a, vec3 edge, vec3 direction) {
  vec3 side = cross(edge, direction);
  return abs(dot(point - a, side)) / max(length(side), 1e-30);
}

vec2 seenWire(vec3 point, Corners p, vec3 direction) {
  vec3 ab = p.b - p.a, bc = p.c - p.b, ca = p.a - p.c;
  float nearest = min(seenDistance(point, p.a, ab, direction),
                      min(seenDistance(point, p.b, bc, direction), seenDistance(point, p.c, ca, direction)));
  float height = min(seenDistance(p.c, p.a, ab, direction),
                     min(seenDistance(p.a, p.b, bc, direction), seenDistance(p.b, p.c, ca, direction)));
  return vec2(nearest, height);
}
#endif

// The point is taken from the triangle and not from the ray: then it lies in the triangle's plane.
Hit meshHit(MeshHit m, Corners p, Ray ray) {
  float u = m.uv.x, v = m.uv.y, w = 1.0 - u - v;
  Hit hit = noHit;
  hit.kind = hitMesh;
  hit.index = m.surface;
  hit.t = m.t;
  hit.point = w * p.a + u * p.b + v * p.c;
  uvec3 corner = texelFetch(triangles, texelCoord(2 * m.triangle + 1), 0).xyz;
  int first = surfaceOffsets[m.surface].w;
  vec3 face = unitOr(cross(p.b - p.a, p.c - p.a), -ray.direction);
  vec3 normal = unitOr(w * texelFetch(normals, texelCoord(first + int(corner.x)), 0).xyz +
                           u * texelFetch(normals, texelCoord(first + int(corner.y)), 0).xyz +
                           v * texelFetch(normals, texelCoord(first + int(corner.z)), 0).xyz,
                       face);
  if (dot(face, ray.direction) > 0.0) face = -face;
  if (dot(normal, face) < 0.0) normal = -normal;
  hit.faceNormal = face;
  hit.normal = normal;
#ifdef WIRES
  if ((surfaceSize[m.surface].y & hasWires) != 0) hit.wire = seenWire(hit.point, p, ray.direction);
#endif
  return hit;
}

GroundHit groundHit(Ray ray, float tMax) {
  if (counts.w == 0) return GroundHit(false, 0.0, 1.0);
  return intersectGround(ray.origin, ray.direction, ground.x, sceneSize.x, tMax);
}

float markerHit(int light, Ray ray, float tMax) {
  return intersectMarker(ray.origin, ray.direction, lightPosition[light].xyz, sceneSize.z, tMax);
}

// Mirror, ground and light markers: what has a formula. `hit` stays when it is nearer.
void findPlainHit(Ray ray, inout Hit hit) {
  GroundHit floorHit = groundHit(ray, hit.t);
  if (floorHit.met) {
    hit = noHit;
    hit.kind = hitGround;
    hit.t = floorHit.t;
    hit.point = vec3(ray.origin.xy + hit.t * ray.direction.xy, ground.x);
    hit.faceNormal = hit.normal = vec3(0.0, 0.0, 1.0);
    hit.fade = floorHit.fade;
  }
  float t = intersectMirror(ray, hit.t);
  if (t > 0.0) {
    hit = noHit;
    hit.kind = hitMirror;
    hit.t = t;
    hit.point = ray.origin + t * ray.direction;
    hit.faceNormal = hit.normal = mirrorNormal(hit.point, ray.direction);
  }
  if (options.y == 0) return;
  for (int i = 0; i < counts.x; ++i) {
    t = markerHit(i, ray, hit.t);
    if (t < 0.0) continue;
    hit = noHit;
    hit.kind = hitMarker;
    hit.index = i;
    hit.t = t;
    hit.point = ray.origin + t * ray.direction;
    hit.faceNormal = hit.normal = normalize(hit.point - lightPosition[i].xyz);
  }
}

// What a ray meets after the mirror.
Hit findHit(Ray ray) {
  Hit hit = noHit;
  findPlainHit(ray, hit);
  MeshHit mesh = noMeshHit;
  mesh.t = hit.t;
  if (intersectSurfaces(ray, surfacesAlong(ray, inMirror, hit.t), false, mesh)) {
    hit = meshHit(mesh, cornersOf(mesh.surface, mesh.triangle), ray);
  }
  return hit;
}

// Whether mirror or ground stop a ray to a light.
bool isPlainlyBlocked(Ray ray, float tMax) {
  return intersectMirror(ray, tMax) > 0.0 || groundHit(ray, tMax).met;
}
