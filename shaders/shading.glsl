// Colours, as src/raytrace/shading.cpp and the recursion of tracer.cpp as a loop.
#include "hit.glsl"

vec3 backgroundColor(vec3 direction) {
  return mix(backgroundBottom.rgb, backgroundTop.rgb, clamp(0.5 + 0.5 * direction.z, 0.0, 1.0));
}

struct Material {
  vec3 color;
  float ambient, diffuse, specular, shininess;
};

Material unpack(vec4 a, vec4 b) {
  return Material(a.rgb, a.a, b.x, b.y, b.z);
}

// Chiang et al. 2019, "Taming the Shadow Terminator"
float terminatorFactor(Hit hit, vec3 toLight, float cosine) {
  float g = dot(hit.faceNormal, toLight) / (cosine * dot(hit.faceNormal, hit.normal));
  if (!(g > 0.0)) return 0.0;
  return g >= 1.0 ? 1.0 : g * (1.0 + g * (1.0 - g));
}

vec3 phongResponse(Material materials, Hit hit, vec3 toLight, vec3 toEye) {
  float cosine = dot(hit.normal, toLight);
  if (!(cosine > 0.0)) return vec3(0.0);
  float factor = terminatorFactor(hit, toLight, cosine);
  if (!(factor > 0.0)) return vec3(0.0);
  float highlight = dot(2.0 * cosine * hit.normal - toLight, toEye);
  float power = highlight > 0.0 ? pow(highlight, materials.shininess) : materials.shininess == 0.0 ? 1.0 : 0.0;
  return factor * (materials.diffuse * cosine * materials.color + vec3(materials.specular * power));
}

// Ambient light, and every light that reaches the point. `shadowFlag` says which surfaces can stop light.
vec3 lit(Material materials, Hit hit, vec3 toEye, int shadowFlag) {
  vec3 color = materials.ambient * materials.color;
  for (int i = 0; i < counts.x; ++i) {
    vec3 towards = lightPosition[i].xyz - hit.point;
    float away = length(towards);
    if (!(away > 0.0)) continue;
    vec3 response = phongResponse(materials, hit, towards / away, toEye);
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

// How much of a pixel at x lies on lines at multiples of 1, `width` wide, when the pixel is `footprint` wide.
float lineCoverage(float x, float width, float footprint) {
  float drawn = clamp(footprint, width, 0.5);
  float fromLine = abs(x - floor(x + 0.5));
  float soft = max(footprint, 0.25 * width);
  return clamp((0.5 * drawn - fromLine) / soft + 0.5, 0.0, 1.0) * width / drawn;
}

Material groundMaterialAt(vec3 point, float footprint) {
  Material materials = unpack(groundMaterial[0], groundMaterial[1]);
  if (!(ground.y > 0.0)) return materials;
  vec2 cell = (point.xy + ground.zw) / ground.y;
  float pixel = footprint / ground.y;
  float line = max(lineCoverage(cell.x, 0.018, pixel), lineCoverage(cell.y, 0.018, pixel));
  materials.color *= 1.0 - 0.28 * line;
  return materials;
}

// A lamp: brightest where one looks straight at it.
vec3 markerColor(Hit hit, vec3 direction) {
  vec3 color = lightColor[hit.index].rgb;
  float most = max(color.r, max(color.g, color.b));
  float facing = clamp(-dot(hit.normal, direction), 0.0, 1.0);
  return (most > 0.0 ? color / most : vec3(0.25)) * mix(0.45, 1.6, facing * facing);
}

// Of anything but the mirror. `travelled` is the whole way from the eye.
vec3 shade(Hit hit, Ray ray, float travelled, int shadowFlag) {
  if (hit.kind == hitMarker) return markerColor(hit, ray.direction);
  vec3 behind = backgroundColor(ray.direction);
  if (hit.kind == hitNothing) return behind;
  Material made = groundMaterialAt(hit.point, footprintAt(travelled) / max(0.02, abs(ray.direction.z)));
#ifdef TRACED
  if (hit.kind == hitMesh) made = unpack(materials[2 * hit.index], materials[2 * hit.index + 1]);
#endif
  vec3 color = mix(lit(made, hit, -ray.direction, shadowFlag), behind, hit.fade);
#ifdef WIRES
  // Edges of triangles that are hardly larger than a pixel would only darken the whole.
  vec2 pixels = hit.wire / max(footprintAt(travelled), 1e-30);
  color *= 1.0 - 0.6 * clamp(1.1 - pixels.x, 0.0, 1.0) * clamp(0.3 * pixels.y - 0.2, 0.0, 1.0);
#endif
  return color;
}

// The colour along a ray whose first hit is known.
vec3 follow(Ray ray, Hit hit) {
#ifdef TRACED
  vec3 color = vec3(0.0), weight = vec3(1.0);
  float travelled = 0.0;
  for (int depth = 0; depth <= counts.y; ++depth) {
    if (depth > 0) hit = findHit(ray);
    if (hit.kind != hitMirror) {
      return color + weight * shade(hit, ray, travelled + hit.t, depth == 0 ? castsShadow : castsInMirror);
    }
    float cosine = abs(dot(ray.direction, hit.normal));
    float rim = 0.7 * mirrorRim(hit.point, cosine);
    color += weight * rim * vec3(0.98, 0.99, 1.0);
    weight *= (1.0 - rim) * mirrorTint.rgb;
    travelled += hit.t;
    vec3 outwards = normalize(reflect(ray.direction, hit.normal));
    ray = Ray(hit.point + sceneSize.y * hit.faceNormal, outwards);
  }
  return color + weight * backgroundColor(ray.direction);
#else
  if (hit.kind == hitMirror) discard;
  return shade(hit, ray, hit.t, castsShadow);
#endif
}
