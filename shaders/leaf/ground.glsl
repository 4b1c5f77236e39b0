// The studio's floor, as src/raytrace/scene_hit.cpp and shading.cpp. Leaf functions (box.glsl).

struct GroundHit {
  bool met;
  float t;
  float fade;  // how much of it has become background
};

// The plane z = height, seen from above only; nothing where it has faded away. `radius`: of the scene, whose middle
// is the origin.
GroundHit intersectGround(vec3 origin, vec3 direction, float height, float radius, float tMax) {
  GroundHit hit;
  float above = origin.z - height;
  hit.t = above / -direction.z;
  hit.fade = 1.0f;
  hit.met = above > 0.0f && direction.z < 0.0f && hit.t < tMax;
  if (!hit.met) return hit;
  vec2 across = vec2(origin.x, origin.y) + hit.t * vec2(direction.x, direction.y);
  hit.fade = smoothstep(fadeStart, fadeEnd, length(across) / radius);
  hit.met = hit.fade < 1.0f;
  return hit;
}

// How much of a pixel at x lies on lines at multiples of 1, `width` wide, when the pixel is `footprint` wide.
float lineCoverage(float x, float width, float footprint) {
  float drawn = clamp(footprint, width, 0.5f);
  float fromLine = abs(x - floor(x + 0.5f));
  float soft = max(footprint, 0.25f * width);
  return clamp((0.5f * drawn - fromLine) / soft + 0.5f, 0.0f, 1.0f) * width / drawn;
}

// The ground's material where the point is (x, y) from a crossing of its grid.
Material groundMaterial(Material plain, float spacing, float x, float y, float footprint) {
  Material material = plain;
  if (!(spacing > 0.0f)) return material;
  float pixel = footprint / spacing;
  float line = max(lineCoverage(x / spacing, gridLineWidth, pixel), lineCoverage(y / spacing, gridLineWidth, pixel));
  material.color *= 1.0f - gridDarkening * line;
  return material;
}
