#include "raytrace/shading.h"

#include <algorithm>
#include <cmath>

namespace anamorph {
namespace {

// A coarse mesh with smooth normals faces away from the light in whole triangles where its shading does not
// yet. This factor brings the shading to 0 in time (Chiang et al. 2019, "Taming the Shadow Terminator"); it
// is 1 for flat shading.
double terminatorFactor(const SceneHit& hit, const Direction& toLight, double cosine) {
  const double g = glm::dot(hit.faceNormal, toLight) / (cosine * glm::dot(hit.faceNormal, hit.normal));
  if (!(g > 0)) return 0;
  return g >= 1 ? 1 : g * (1 + g * (1 - g));
}

// How much of a pixel at x lies on lines at multiples of 1, `width` wide, when the pixel is `footprint` wide.
double lineCoverage(double x, double width, double footprint) {
  const double drawn = std::clamp(footprint, width, 0.5);
  const double fromLine = std::abs(x - std::round(x));
  const double soft = std::max(footprint, 0.25 * width);
  const double inside = std::clamp((0.5 * drawn - fromLine) / soft + 0.5, 0.0, 1.0);
  return inside * width / drawn;
}

}  // namespace

Color backgroundColor(const Background& background, const Direction& direction) {
  return glm::mix(background.bottom, background.top, std::clamp(0.5 + 0.5 * direction.z, 0.0, 1.0));
}

Color phongResponse(const Material& material, const SceneHit& hit, const Direction& toLight,
                    const Direction& toEye) {
  const double cosine = glm::dot(hit.normal, toLight);
  if (!(cosine > 0)) return Color(0);
  const double factor = terminatorFactor(hit, toLight, cosine);
  if (!(factor > 0)) return Color(0);
  const double highlight = std::max(0.0, glm::dot(2 * cosine * hit.normal - toLight, toEye));
  const double specular =
      material.specular > 0 ? material.specular * std::pow(highlight, material.shininess) : 0;
  return factor * (material.diffuse * cosine * material.color + Color(specular));
}

Material groundMaterial(const Ground& ground, const Point& point, double footprint) {
  Material material = ground.material;
  if (!(ground.gridSpacing > 0)) return material;
  constexpr double width = 0.018, darkening = 0.28;
  const Point cell = point / ground.gridSpacing;
  const double pixel = footprint / ground.gridSpacing;
  const double line = std::max(lineCoverage(cell.x, width, pixel), lineCoverage(cell.y, width, pixel));
  material.color *= 1 - darkening * line;
  return material;
}

double mirrorRim(const Shape& shape, const Point& point, double cosine) {
  constexpr double edgeOnCosine = 0.22, borderWidth = 0.006;
  const double edgeOn = 1 - cosine / edgeOnCosine;
  const double border = 2 - 2 * borderDistance(shape, point) / borderWidth;
  const double rim = std::clamp(std::max(edgeOn, border), 0.0, 1.0);
  return rim * rim * (3 - 2 * rim);
}

}  // namespace anamorph
