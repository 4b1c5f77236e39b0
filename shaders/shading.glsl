// Colours, as src/raytrace/shading.cpp and the recursion of tracer.cpp as a loop.
#include "hit.glsl"

vec3 backgroundAlong(vec3 direction) {
  return backgroundColor(backgroundBottom.rgb, backgroundTop.rgb, direction);
}

Material unpack(vec4 a, vec4 b) {
  return Material(a.rgb, a.a, b.x, b.y, b.z);
}

// Ambient light, and every light that reaches the point. `shadowFlag` says which surfaces can stop light.
vec3 shadeSurface(Material material, Hit hit, vec3 toEye, int shadowFlag) {
  vec3 color = material.ambient * material.color;
  for (int i = 0; i < counts.x; ++i) {
    vec3 towards = lightPosition[i].xyz - hit.point;
    float away = length(towards);
    if (!(away > 0.0)) continue;
    vec3 response = phongResponse(material, hit.faceNormal, hit.normal, towards / away, toEye);
    if (response == vec3(0.0)) continue;
    if (options.x != 0) {
      vec3 start = hit.point + sceneSize.y * hit.faceNormal;
      vec3 way = lightPosition[i].xyz - start;
      away = length(way);
      Ray toLight = Ray(start, away > 0.0 ? way / away : hit.faceNormal);
      if (isPlainlyBlocked(toLight, away)) continue;
      int surfaces = surfacesAlong(toLight, shadowFlag, away);
#ifdef TRACED
      MeshHit blocker = noMeshHit;
      blocker.t = away;
      if (intersectSurfaces(toLight, surfaces, true, blocker)) continue;
#else
      if (surfaces != 0) discard;  // the other program does this pixel
#endif
    }
    color += response * lightColor[i].rgb;
  }
  return color;
}

Material groundMaterialAt(vec3 point, float footprint) {
  vec2 cell = point.xy + ground.zw;
  return groundMaterial(unpack(groundLook[0], groundLook[1]), ground.y, cell.x, cell.y, footprint);
}

// Of anything but the mirror. `travelled` is the whole way from the eye.
vec3 shade(Hit hit, Ray ray, float travelled, int shadowFlag) {
  if (hit.kind == hitMarker) return markerColor(lightColor[hit.index].rgb, hit.normal, ray.direction);
  vec3 behind = backgroundAlong(ray.direction);
  if (hit.kind == hitNothing) return behind;
  Material made = groundMaterialAt(hit.point, footprintAt(travelled) / max(leastSlant, abs(ray.direction.z)));
#ifdef TRACED
  if (hit.kind == hitMesh) made = unpack(materials[2 * hit.index], materials[2 * hit.index + 1]);
#endif
  vec3 color = mix(shadeSurface(made, hit, -ray.direction, shadowFlag), behind, hit.fade);
#ifdef WIRES
  // Edges of triangles that are hardly larger than a pixel would only darken the whole.
  vec2 pixels = hit.wire / max(footprintAt(travelled), 1e-30);
  color *= 1.0 - 0.6 * clamp(1.1 - pixels.x, 0.0, 1.0) * clamp(0.3 * pixels.y - 0.2, 0.0, 1.0);
#endif
  return color;
}

int lastKind = hitNothing;  // what the ray of trace() has met last, behind all mirrors

// The colour along a ray whose first hit is known.
vec3 trace(Ray ray, Hit hit) {
#ifdef TRACED
  vec3 color = vec3(0.0), weight = vec3(1.0);
  float travelled = 0.0;
  for (int depth = 0; depth <= counts.y; ++depth) {
    if (depth > 0) hit = findHit(ray);
    lastKind = hit.kind;
    if (hit.kind != hitMirror) {
      return color + weight * shade(hit, ray, travelled + hit.t, depth == 0 ? castsShadow : castsInMirror);
    }
    float cosine = abs(dot(ray.direction, hit.normal));
    float rim = rimStrength * mirrorRim(mirrorBorder(hit.point), cosine);
    color += weight * rim * rimColor;
    weight *= (1.0 - rim) * mirrorTint.rgb;
    travelled += hit.t;
    vec3 outwards = normalize(reflect(ray.direction, hit.normal));
    ray = Ray(hit.point + sceneSize.y * hit.faceNormal, outwards);
  }
  return color + weight * backgroundAlong(ray.direction);
#else
  if (hit.kind == hitMirror) discard;
  return shade(hit, ray, hit.t, castsShadow);
#endif
}
