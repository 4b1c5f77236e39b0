// The picture, one sample a pixel: which triangle is seen was found by drawing them; mirror, ground, sky and light
// markers are met here. In front of that lie the ghost of the original and the RT camera's screen.
//
// Two programs are made of this. The short one draws all pixels that see no mesh, no mirror and no place where a mesh
// may cast a shadow, and discards the others; the other one, with TRACED, draws those. With GHOST there is a ghost,
// with WIRES the edges of triangles can be drawn; SHAPE is that of mirror.glsl. With BOXES_ONLY a mirror of triangles is
// met where its box is.
#ifndef TRACED
#define BOXES_ONLY
#endif
#include "shading.glsl"

uniform usampler2D seen;       // triangle_id.frag.glsl: solid things
uniform usampler2D seenGhost;  // and the ghost
uniform sampler2D screen;      // linear light, first row at the top

layout(location = 0) out vec4 color;   // linear light times alpha, alpha
layout(location = 1) out float depth;  // lineDepth()

// The plane of the seen triangle, met by the ray of this pixel.
MeshHit intersectSeen(uint id, Ray ray, out Corners corners) {
  MeshHit hit = noMeshHit;
  if (id == 0u) return hit;
  hit.triangle = int(id) - 1;
  for (int i = 0; i < meshCount; ++i) {
    int local = hit.triangle - surfaceOffsets[i].y;
    if (local >= 0 && local < surfaceSize[i].x) hit.surface = i;
  }
  if (hit.surface < 0) return hit;
  corners = cornersOf(hit.surface, hit.triangle);
  TriangleHit here = intersectTriangle(ray.origin, ray.direction, corners.a, corners.b, corners.c);
  hit.t = here.t;
  hit.uv = vec2(here.u, here.v);
  if (!here.met) hit.surface = -1;
  return hit;
}

// Light between a glass shell and a drawing: clear where one looks through; at the rim bright over what is dark, and dark
// over what is bright.
vec4 ghostColor(Hit hit, Ray ray, vec3 behind) {
  float facing = clamp(-dot(hit.normal, ray.direction), 0.0, 1.0);
  float rim = pow(1.0 - facing, 2.5);
  float sky = 0.5 + 0.5 * hit.normal.z;
  vec3 body = materials[2 * originalSurface].rgb * mix(0.6, 1.25, sky);
  float bright = smoothstep(0.45, 0.7, dot(behind, vec3(0.2126, 0.7152, 0.0722)));
  vec3 rimTint = mix(vec3(0.72, 0.84, 1.0), vec3(0.02, 0.1, 0.36), bright);
  vec3 tint = mix(body + 0.05, rimTint, 0.75 * rim);
  return vec4(tint, mix(0.5, 0.95, rim));
}

// Distance along the ray to the pixel grid, and its colour there.
vec4 screenColor(Ray ray, out float t) {
  t = 1e30;
  if (!(screenCorner.w > 0.0)) return vec4(0.0);
  vec3 normal = cross(screenRight.xyz, screenDown.xyz);
  t = dot(normal, screenCorner.xyz - ray.origin) / dot(normal, ray.direction);
  if (!(t > 0.0 && t < 1e30)) return vec4(0.0);
  vec3 q = ray.origin + t * ray.direction - screenCorner.xyz;
  vec2 place = vec2(dot(q, screenRight.xyz) / dot(screenRight.xyz, screenRight.xyz),
                    dot(q, screenDown.xyz) / dot(screenDown.xyz, screenDown.xyz));
  if (any(lessThan(place, vec2(0.0))) || any(greaterThanEqual(place, vec2(1.0)))) return vec4(0.0);
  ivec2 size = textureSize(screen, 0);
  ivec2 cell = min(ivec2(place * vec2(size)), size - 1);
  return vec4(texelFetch(screen, cell, 0).rgb, screenCorner.w);
}

vec4 over(vec4 layer, vec4 below) {
  return vec4(layer.rgb * layer.a, layer.a) + (1.0 - layer.a) * below;
}

float finiteLight(float x) {
  return x >= 0.0 ? min(x, 60000.0) : 0.0;  // half floats end at 65504; not a number compares false
}

void main() {
  Ray ray = pixelRay(gl_FragCoord.xy);
  Hit hit = noHit;
  uint solid = texelFetch(seen, ivec2(gl_FragCoord.xy), 0).x, clear = 0u;
#ifdef GHOST
  clear = texelFetch(seenGhost, ivec2(gl_FragCoord.xy), 0).x;
#endif
#ifdef TRACED
  Corners corners;
  MeshHit mesh = intersectSeen(solid, ray, corners);
  if (mesh.surface >= 0) hit = meshHit(mesh, corners, ray);
#else
  if (solid + clear > 0u) discard;
#endif
  findPlainHit(ray, hit);
  bool empty = hit.kind == hitNothing && backgroundTop.w > 0.5;
  vec4 result = empty ? vec4(0.0) : vec4(trace(ray, hit), 1.0);

  vec4 ghost = vec4(0.0);
  float ghostT = 1e30;
#if defined(GHOST) && defined(TRACED)
  MeshHit ghostMesh = intersectSeen(clear, ray, corners);
  if (ghostMesh.surface >= 0) {
    ghost = ghostColor(meshHit(ghostMesh, corners, ray), ray, result.rgb);
    ghostT = ghostMesh.t;
    // It is seen through the mirror, but neither over what the mirror shows of the sculpture nor over a sculpture in
    // the same place: their colours would mix to one that neither has.
    bool through = hit.kind == hitMirror && lastKind != hitMesh;
    if (ghostT > (1.0 - 1e-3) * hit.t) ghost.a *= through ? 0.35 : 0.0;
  }
#endif
  float screenT;
  vec4 shown = screenColor(ray, screenT);
  if (screenT > hit.t) shown.a = 0.0;
  bool screenFirst = screenT < ghostT;
  result = over(screenFirst ? ghost : shown, result);
  result = over(screenFirst ? shown : ghost, result);

  color = vec4(finiteLight(result.r), finiteLight(result.g), finiteLight(result.b), clamp(result.a, 0.0, 1.0));
  depth = hit.kind == hitNothing ? 1.0 : lineDepth(viewDepth(hit.point));
}
