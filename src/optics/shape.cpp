#include "optics/shape.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/language.h"
#include "optics/cut_mesh.h"

namespace anamorph {
namespace {

constexpr int cutSegments = 96;

// A plane through three points stays one, whatever the map does with lengths; its side is told by a point of it.
HalfSpace mapHalfSpace(const HalfSpace& half, const ShapeMap& map) {
  const Direction n = glm::normalize(half.normal), x = perpendicular(n), y = glm::cross(n, x);
  const Point origin = map.point(half.point);
  const Vector normal = glm::cross(map.point(half.point + x) - origin, map.point(half.point + y) - origin);
  const Vector inside = map.point(half.point + n) - origin;
  if (!(glm::length(normal) > 0)) return {origin, half.normal};
  const Direction turned = glm::normalize(glm::dot(normal, inside) < 0 ? -normal : normal);
  return {origin, glm::length(turned - n) > ShapeMap::notTurned ? glm::length(half.normal) * turned : half.normal};
}

// A cut along a border leaves a line.
bool hasArea(const Mesh& mesh) {
  constexpr double nothing = 1e-9;  // of a triangle, as a share of the whole
  const double size = lengthSquared(boundingBox(mesh.positions).size());
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
    return glm::length(areaVector(mesh.positions, t)) > nothing * size;
  });
}

}  // namespace

double ShapeMap::size(double length, double factor) const {
  return factor == 1 ? length : std::clamp(length * factor, minSize, maxSize);
}

double ShapeMap::size(double length, std::initializer_list<double> candidates) const {
  return size(length, strongest(candidates));
}

double ShapeMap::strongest(std::initializer_list<double> factors) {
  return *std::max_element(factors.begin(), factors.end(),
                           [](double a, double b) { return std::abs(a - 1) < std::abs(b - 1); });
}

Shape::Shape(std::shared_ptr<const AnyShape> any, std::vector<HalfSpace> clip) : any_(std::move(any)) {
  clipBy(std::move(clip));
}

bool Shape::operator==(const Shape& other) const {
  return clip() == other.clip() && (any_ == other.any_ || any_->equals(*other.any_));
}

const std::vector<HalfSpace>& Shape::clip() const {
  static const std::vector<HalfSpace> none;
  return cut_ ? cut_->planes : none;
}

void Shape::clipBy(std::vector<HalfSpace> clip) {
  cut_ = clip.empty() ? nullptr : std::shared_ptr<const Cut>(new Cut{std::move(clip)});
}

const Shape::CutSurface& Shape::cutSurface() const {
  CHECK(cut_);
  return cut_->surface.get([this] {
    CutSurface cut{cutMesh(any_->tessellate(cutSegments), cut_->planes), {}};
    cut.box = boundingBox(cut.surface.mesh.positions);
    return cut;
  });
}

std::optional<SurfaceHit> intersect(const Shape& shape, const Ray& ray, double tMin) {
  const auto keeps = [&](const Point& p) {
    return std::all_of(shape.clip().begin(), shape.clip().end(),
                       [&](const HalfSpace& half) { return half.contains(p); });
  };
  auto hit = shape->intersect(ray, tMin);
  while (hit && !keeps(hit->point)) hit = shape->intersect(ray, hit->t);  // what is cut away lets it pass
  return hit;
}

bool meetsBetween(const Shape& shape, const Ray& ray, double tMin, double tMax) {
  if (shape.clip().empty()) return shape->meetsBetween(ray, tMin, tMax);
  const auto hit = intersect(shape, ray, tMin);
  return hit && hit->t < tMax;
}

bool seesConvexSide(const Shape& shape, const Point& eye) {
  return shape.clip().empty() && shape->seesConvexSide(eye);  // a cut shows the inner wall
}

std::optional<std::string> findShapeProblem(const Shape& shape) {
  if (auto problem = shape->findProblem()) return problem;
  for (const HalfSpace& half : shape.clip()) {
    if (!(glm::length(half.normal) > 0)) return tr("expected a normal of clip that is not 0");
  }
  if (!shape.clip().empty() && !hasArea(shape.cutSurface().surface.mesh)) {
    return tr("expected a clip that leaves some of the surface, got one that cuts all of it away");
  }
  return std::nullopt;
}
std::optional<std::string> findEyeProblem(const Shape& shape, const Point& eye) {
  return shape->findEyeProblem(eye);
}
Point eyeOutside(const Shape& shape, const Point& eye, const Point& original) {
  return shape->eyeOutside(eye, original);
}
const char* shapeName(const Shape& shape) {
  return shape->name();
}
Box boxOf(const Shape& shape) {
  return shape.clip().empty() ? shape->box() : shape.cutSurface().box;
}
Point middleOf(const Shape& shape) {
  return shape.clip().empty() || findShapeProblem(shape) ? shape->middle() : boxOf(shape).centre();
}
Axes axesOf(const Shape& shape) {
  return shape->axes();
}
bool isRound(const Shape& shape) {
  return shape->isRound() && shape.clip().empty();
}
bool hasOneSize(const Shape& shape) {
  return shape->isRound();
}
std::size_t bytesOf(const Shape& shape) {
  return shape->bytes() + shape.clip().size() * sizeof(HalfSpace);
}
const SurfaceFile* surfaceFileOf(const Shape& shape) {
  return shape->file();
}
Shape withoutCutSurface(const Shape& shape) {
  return shape.clip().empty() ? shape : Shape(shape.any_, shape.clip());
}

ShapeExtent extentOf(const Shape& shape) {
  if (findShapeProblem(shape)) {
    ShapeExtent extent;
    if (const Point middle = middleOf(shape); isFinite(middle)) extent.middle = middle;
    return extent;
  }
  if (shape.clip().empty()) return shape->extent();
  const Box box = boxOf(shape);
  return {box.centre(), {0, 0, 1}, std::max(box.size().x, box.size().y), box.size().z};
}

std::optional<double> circleFromAbove(const Shape& shape) {
  return shape.clip().empty() ? shape->circleFromAbove() : std::nullopt;
}

double borderDistance(const Shape& shape, const Point& point) {
  double nearest = shape->borderDistance(point);
  if (shape.clip().empty()) return nearest;
  const double size = boxOf(shape).diagonal();
  for (const HalfSpace& half : shape.clip()) {
    nearest = std::min(nearest, glm::dot(point - half.point, glm::normalize(half.normal)) / size);
  }
  return nearest;
}

Point pointAt(const Shape& shape, double u, double v) {
  return shape->pointAt(u, v);
}

SmoothMesh tessellate(const Shape& shape, int segments) {
  CHECK(segments >= 3);
  SmoothMesh whole = shape->tessellate(segments);
  return shape.clip().empty() ? whole : cutMesh(whole, shape.clip());
}

const char* shaderOf(const Shape& shape) {
  return shape->shader();
}

void visitFields(Shape& shape, ShapeFields& fields) {
  const auto copy = shape.any_->copy();
  copy->visitFields(fields);
  if (copy->equals(*shape.any_)) return;  // what was prepared of it stays
  shape = Shape(copy, shape.clip());
}

Shape mapShape(const Shape& shape, const ShapeMap& map) {
  const auto copy = shape.any_->copy();
  copy->map(map);
  std::vector<HalfSpace> clip = shape.clip();
  for (HalfSpace& half : clip) half = mapHalfSpace(half, map);
  return Shape(copy, std::move(clip));
}

std::vector<ControlPoint> controlPointsOf(const Shape& shape) {
  return shape->controlPoints();
}

Shape withControlPointMoved(const Shape& shape, std::size_t number, const Vector& motion) {
  const auto copy = shape.any_->copy();
  copy->moveControlPoint(number, motion);
  return Shape(copy, shape.clip());
}

Shape continued(const Shape& shape) {
  const auto copy = shape.any_->copy();
  copy->carryOn();
  return Shape(copy, {});
}

SmoothMesh tessellateGrid(int columns, int rows, const std::function<Point(double, double)>& pointAt,
                          const std::function<Direction(double, double)>& normalAt) {
  SmoothMesh surface;
  Mesh& mesh = surface.mesh;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const double u = double(i) / columns, v = double(j) / rows;
      mesh.positions.push_back(pointAt(u, v));
      if (normalAt) surface.normals.push_back(normalAt(u, v));
    }
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const auto a = static_cast<std::uint32_t>(j * (columns + 1) + i), b = a + 1;
      const auto c = a + static_cast<std::uint32_t>(columns) + 1, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  }
  return surface;
}

}  // namespace anamorph
