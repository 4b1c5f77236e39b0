// How surfaces answer light, as src/raytrace/shading.cpp. Leaf functions (box.glsl).

struct Material {
  vec3 color;
  float ambient, diffuse, specular, shininess;
};

// What is seen along a direction that meets nothing.
vec3 backgroundColor(vec3 bottom, vec3 top, vec3 direction) {
  return mix(bottom, top, clamp(0.5f + 0.5f * direction.z, 0.0f, 1.0f));
}

// Chiang et al. 2019, "Taming the Shadow Terminator"
float terminatorFactor(vec3 faceNormal, vec3 normal, vec3 toLight, float cosine) {
  float g = dot(faceNormal, toLight) / (cosine * dot(faceNormal, normal));
  if (!(g > 0.0f)) return 0.0f;
  return g >= 1.0f ? 1.0f : g * (1.0f + g * (1.0f - g));
}

// The share of a light's colour that the surface sends towards the eye, without shadow.
vec3 phongResponse(Material material, vec3 faceNormal, vec3 normal, vec3 toLight, vec3 toEye) {
  float cosine = dot(normal, toLight);
  if (!(cosine > 0.0f)) return vec3(0.0f);
  float factor = terminatorFactor(faceNormal, normal, toLight, cosine);
  if (!(factor > 0.0f)) return vec3(0.0f);
  float highlight = dot(2.0f * cosine * normal - toLight, toEye);
  float power = highlight > 0.0f ? pow(highlight, material.shininess) : material.shininess == 0.0f ? 1.0f : 0.0f;
  return factor * (material.diffuse * cosine * material.color + vec3(material.specular * power));
}

// How much of the mirror's bright edge is seen: where it is seen edge-on, and near its border.
float mirrorRim(float toBorder, float cosine) {
  float edgeOn = 1.0f - cosine / rimCosine;
  float border = 2.0f - 2.0f * toBorder / rimBorder;
  float rim = clamp(max(edgeOn, border), 0.0f, 1.0f);
  return rim * rim * (3.0f - 2.0f * rim);
}
