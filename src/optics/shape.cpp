#include "optics/shape.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace anamorph {
namespace {

// A grid of (columns + 1) x (rows + 1) points, point(u, v) with u and v in 0..1.
template <typename PointAt>
Mesh makeGrid(int columns, int rows, const PointAt& pointAt) {
  Mesh mesh;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      mesh.positions.push_back(pointAt(double(i) / columns, double(j) / rows));
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
  return mesh;
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

bool Shape::operator==(const Shape& other) const {
  return any_ == other.any_ || any_->equals(*other.any_);
}

std::optional<SurfaceHit> intersect(const Shape& shape, const Ray& ray, double tMin) {
  return shape->intersect(ray, tMin);
}
std::optional<std::string> findShapeProblem(const Shape& shape) {
  return shape->findProblem();
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
  return shape->box();
}
Point middleOf(const Shape& shape) {
  return shape->middle();
}
Axes axesOf(const Shape& shape) {
  return shape->axes();
}
bool isRound(const Shape& shape) {
  return shape->isRound();
}

ShapeExtent extentOf(const Shape& shape) {
  if (!findShapeProblem(shape)) return shape->extent();
  ShapeExtent extent;
  const Point middle = middleOf(shape);
  if (isFinite(middle)) extent.middle = middle;
  return extent;
}

std::optional<double> circleFromAbove(const Shape& shape) {
  return shape->circleFromAbove();
}
double borderDistance(const Shape& shape, const Point& point) {
  return shape->borderDistance(point);
}
Point pointAt(const Shape& shape, double u, double v) {
  return shape->pointAt(u, v);
}

Mesh tessellate(const Shape& shape, int segments) {
  CHECK(segments >= 3);
  const auto [columns, rows] = shape->gridFor(segments);
  return makeGrid(columns, rows, [&](double u, double v) { return shape->pointAt(u, v); });
}

void visitFields(Shape& shape, ShapeFields& fields) {
  const auto copy = shape.any_->copy();
  copy->visitFields(fields);
  shape.any_ = copy;
}

Shape mapShape(const Shape& shape, const ShapeMap& map) {
  const auto copy = shape.any_->copy();
  copy->map(map);
  return Shape(copy);
}

Shape continued(const Shape& shape) {
  const auto copy = shape.any_->copy();
  copy->carryOn();
  return Shape(copy);
}

}  // namespace anamorph
