#include "exports/wall_thickness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/parallel_for.h"

namespace anamorph {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();
constexpr double liftFraction = 1e-7;  // of the size, to be off the surface one stands on
constexpr double leastCosine = 0.866;  // between the ray and the normal of the other side: 30 degrees
constexpr int maxEntries = 16;         // surfaces that a ray enters on its way, of shells inside each other
constexpr std::size_t mostPlaces = 5;  // that are named
constexpr double placesApart = 0.05;   // of the size

struct Wall {
  double thickness = none;
  Point from{0};
  Direction direction{0};
};

struct Sampler {
  const Mesh& mesh;
  const Bvh& bvh;
  double inward;
  double lift;
  std::vector<double> areas;  // up to and with each triangle
};

std::vector<double> sumAreas(const Mesh& mesh) {
  std::vector<double> areas;
  areas.reserve(mesh.triangles.size());
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    sum += glm::length(areaVector(mesh.positions, t));
    areas.push_back(sum);
  }
  return areas;
}

// Points of a low-discrepancy sequence (Roberts 2018, "R2"), folded into the triangle.
Point pointIn(const Mesh& mesh, const Triangle& t, std::size_t index) {
  const double n = static_cast<double>(index);
  double u = n * 0.7548776662466927, v = n * 0.5698402909980532;
  u -= std::floor(u);
  v -= std::floor(v);
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  const Point a = mesh.positions[t[0]];
  return a + u * (mesh.positions[t[1]] - a) + v * (mesh.positions[t[2]] - a);
}

// The way to the first surface that the ray leaves the solid through; none where that leans too much to be
// the other side of a wall.
double wayOut(const Sampler& sampler, const Ray& ray) {
  BvhHit hit;
  double from = sampler.lift;
  for (int i = 0; i < maxEntries && sampler.bvh.closestHit(ray, hit, from); ++i) {
    const Triangle& t = sampler.mesh.triangles[hit.triangle];
    const Vector area = areaVector(sampler.mesh.positions, t);
    const double facing = sampler.inward * glm::dot(area, ray.direction);
    if (facing > 0) return facing >= leastCosine * glm::length(area) ? hit.t : none;
    from = hit.t;
  }
  return none;
}

Wall measureAt(const Sampler& sampler, std::size_t index, std::size_t count) {
  const double place = sampler.areas.back() * (double(index) + 0.5) / double(count);
  const auto at = std::upper_bound(sampler.areas.begin(), sampler.areas.end(), place);
  if (at == sampler.areas.end()) return {};
  const Triangle& t = sampler.mesh.triangles[static_cast<std::size_t>(at - sampler.areas.begin())];
  const Vector area = areaVector(sampler.mesh.positions, t);
  const double length = glm::length(area);
  if (!(length > 0)) return {};
  Wall wall{none, pointIn(sampler.mesh, t, index), -sampler.inward * area / length};
  wall.thickness = wayOut(sampler, {wall.from, wall.direction});
  return wall;
}

ThinPlace middleOf(const Wall& wall) {
  return {wall.from + 0.5 * wall.thickness * wall.direction, wall.thickness};
}

// The first of `walls`, thinnest first, that are apart from those before.
std::vector<ThinPlace> placesOf(const std::vector<Wall>& walls, std::size_t count, double apart) {
  std::vector<ThinPlace> places;
  for (std::size_t i = 0; i < count && places.size() < mostPlaces; ++i) {
    const ThinPlace place = middleOf(walls[i]);
    const bool isNew = std::none_of(places.begin(), places.end(), [&](const ThinPlace& other) {
      return glm::length(other.at - place.at) < apart;
    });
    if (isNew) places.push_back(place);
  }
  return places;
}

// `area` is what each of the walls stands for.
WallThickness summarize(std::vector<Wall> walls, double thin, double area, double size) {
  walls.erase(
      std::remove_if(walls.begin(), walls.end(), [](const Wall& wall) { return wall.thickness == none; }),
      walls.end());
  WallThickness result;
  result.samples = walls.size();
  if (walls.empty()) return result;
  std::stable_sort(walls.begin(), walls.end(),
                   [](const Wall& a, const Wall& b) { return a.thickness < b.thickness; });
  result.least = middleOf(walls.front());
  result.firstPercentile = walls[walls.size() / 100].thickness;
  const auto thick = std::partition_point(walls.begin(), walls.end(),
                                          [&](const Wall& wall) { return wall.thickness < thin; });
  const auto count = static_cast<std::size_t>(thick - walls.begin());
  result.thinArea = area * static_cast<double>(count);
  result.places = placesOf(walls, count, placesApart * size);
  return result;
}

}  // namespace

std::optional<WallThickness> measureWalls(const Mesh& mesh, const Bvh& bvh, const WallQuestion& question,
                                          int threads, const Progress& progress) {
  if (bvh.empty() || question.samples <= 0) return WallThickness{};
  const double size = boundingBox(mesh.positions).diagonal();
  const Sampler sampler{mesh, bvh, question.inward, liftFraction * size, sumAreas(mesh)};
  const auto count = static_cast<std::size_t>(question.samples);
  constexpr std::size_t batch = 8192;
  std::vector<Wall> walls(count);
  for (std::size_t first = 0; first < count; first += batch) {
    if (!progress.update(double(first) / double(count))) return std::nullopt;
    parallelFor(std::min(batch, count - first), 256, threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = first + begin; i < first + end; ++i) walls[i] = measureAt(sampler, i, count);
    });
  }
  const double area = 0.5 * sampler.areas.back() / double(count);  // areas are those of parallelograms
  return summarize(std::move(walls), question.thin, area, size);
}

}  // namespace anamorph
