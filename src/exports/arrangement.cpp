#include "exports/arrangement.h"

#include <algorithm>

#include "exports/printable.h"

namespace anamorph {
namespace {

constexpr double levelTolerance = 1e-9;  // of the size: what stands on the ground to the last bits

Point2 flat(const Vector& v) {
  return {v.x, v.y};
}

// The direction on the table from the eye to what it looks at.
Point2 headingOf(const Point& eye, const Point& middle, const Point& target) {
  const double size = glm::length(middle - eye);
  for (const Point& aim : {middle, target}) {
    const Point2 way = flat(aim - eye);
    if (glm::length(way) > 1e-6 * size && glm::length(way) > 0) return glm::normalize(way);
  }
  return {0, 1};
}

bool standsInTheWay(const Bvh& thing, const std::vector<Point>& way) {
  for (std::size_t i = 1; i < way.size(); ++i) {
    if (thing.anyHit({way[i - 1], way[i] - way[i - 1]}, 0, 1)) return true;
  }
  return false;
}

}  // namespace

Shape scaleMirror(const Shape& shape, double factor) {
  return mapShape(shape, {[&](const Point& p) { return factor * p; }, Vector(factor)});
}

Point2 Arrangement::planOf(const Point& p) const {
  const Point2 way = flat(p - middle);
  return {glm::dot(way, right), glm::dot(way, away)};
}

Point2 Arrangement::sideOf(const Point& p) const {
  return {planOf(p).y, p.z - table};
}

Arrangement makeArrangement(const LevelResult& finished, double millimetresPerUnit,
                            const std::optional<BasePlateSettings>& plate) {
  const Level& level = finished.level;
  Arrangement arrangement;
  arrangement.title = level.text->title;
  arrangement.millimetresPerUnit = millimetresPerUnit;
  arrangement.hasMirror = isVisible(level.optic);
  arrangement.mirror = scaleMirror(level.optic.shape(), millimetresPerUnit);
  arrangement.mirrorSurface = tessellate(arrangement.mirror).mesh;
  arrangement.sculpture = makePrintable(finished.sculpture.sculpture->mesh, millimetresPerUnit);
  arrangement.eye = millimetresPerUnit * level.camera.eye;
  arrangement.middle = middleOf(arrangement.mirror);
  arrangement.away = headingOf(arrangement.eye, arrangement.middle, millimetresPerUnit * level.camera.target);
  arrangement.right = {arrangement.away.y, -arrangement.away.x};
  const Box mirrorBox = boundingBox(arrangement.mirrorSurface.positions);
  const Box sculptureBox = boundingBox(arrangement.sculpture.positions);
  arrangement.table = millimetresPerUnit * level.ground.height;
  const double lowest =
      arrangement.hasMirror ? std::min(mirrorBox.min.z, sculptureBox.min.z) : sculptureBox.min.z;
  if (lowest < arrangement.table - levelTolerance * (mirrorBox.diagonal() + sculptureBox.diagonal())) {
    arrangement.table = lowest;
    arrangement.onGround = false;
  }
  if (plate) {
    const Mesh obstacle = arrangement.hasMirror ? arrangement.mirrorSurface : Mesh();
    arrangement.plate = makeBasePlate(arrangement.sculpture, obstacle, arrangement.table, *plate);
  }
  return arrangement;
}

std::optional<Sight> findSight(const LevelResult& finished, const Ray& ray) {
  const Bvh& sculpture = *finished.sculpture.prepared.bvh;
  const LineOfSight sight = lineOfSight(finished.level.optic, ray);
  if (sight.ends) return std::nullopt;
  Sight found{{ray.origin}, sight.last, 0};
  for (int i = 0; i < sight.bendCount; ++i) {
    found.points.push_back(sight.bends[static_cast<std::size_t>(i)]);
  }
  if (standsInTheWay(sculpture, found.points)) return std::nullopt;
  BvhHit hit;
  if (!sculpture.closestHit(found.last, hit)) return std::nullopt;
  found.t = hit.t;
  found.points.push_back(found.last.at(hit.t));
  return found;
}

std::shared_ptr<const Bvh> plateInScene(const Arrangement& arrangement) {
  if (!arrangement.plate) return nullptr;
  const auto toScene = [&](const Point& p) { return p / arrangement.millimetresPerUnit; };
  return std::make_shared<const Bvh>(mapPoints(arrangement.plate->mesh.positions, toScene),
                                     arrangement.plate->mesh.triangles);
}

double fractionHiddenByPlate(const LevelResult& finished, const Arrangement& arrangement) {
  if (!arrangement.plate) return 0;
  constexpr int size = 160;  // pixels
  const auto plate = plateInScene(arrangement);
  const Level& level = finished.level;
  const auto [width, height] = pictureSize(level.grid, size);
  const Projection projection(level.camera, width, height);
  std::size_t seen = 0, hidden = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Ray ray = projection.rayThrough({x + 0.5, y + 0.5});
      const auto sight = findSight(finished, ray);
      if (!sight) continue;
      ++seen;
      if (standsInTheWay(*plate, sight->points)) ++hidden;
    }
  }
  return seen > 0 ? double(hidden) / double(seen) : 0;
}

}  // namespace anamorph
