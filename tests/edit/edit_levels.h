// Levels for the tests of editing: each kind of mirror with everything at a random place, and levels that no
// file could hold.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "edit/level_edits.h"
#include "random_scene.h"
#include "shapes.h"

namespace anamorph::testing {

inline Level makeRandomLevel(ShapeKind kind, Random& random) {
  const RandomScene scene = makeRandomScene(kind, random);
  Level level;
  level.optic = scene.optic;
  level.camera.eye = scene.eye;
  level.camera.target = scene.onMirror + random.point(1);
  level.original.placement.position = makeRandomOriginal(scene, random, 0.1);
  level.original.placement.rotationDegrees = random.point(180);
  level.original.placement.scale =
      Vector(random.uniform(0.1, 2), random.uniform(0.1, 2), random.uniform(0.1, 2));
  level.lights[1].position = random.point(10);
  return level;
}

inline std::vector<Level> makeAbsurdLevels() {
  Level flatSphere, flatCylinder, noQuad, eyeAtAim, zeroScale, farAway;
  flatSphere.optic.shape() = SphereMirror{{0, 0, 1}, 0};
  flatCylinder.optic.shape() = CylinderMirror{{0, 0, 1}, {0, 0, 1}, 0};
  noQuad.optic.shape() = PlaneMirror{{Point(1), Point(1), Point(1), Point(1)}};
  eyeAtAim.camera.eye = eyeAtAim.camera.target;
  eyeAtAim.camera.up = Vector(0);
  zeroScale.original.placement.scale = Vector(0);
  farAway.camera.eye = Point(1e6, -1e6, 1e6);
  farAway.optic.shape() = SphereMirror{{1e6, 0, 0}, 1e6};
  return {flatSphere, flatCylinder, noQuad, eyeAtAim, zeroScale, farAway};
}

inline const std::vector<Selection>& allSelections() {
  static const std::vector<Selection> all{
      {Part::none},      {Part::eye},   {Part::aim},      {Part::original}, {Part::mirror},
      {Part::sculpture}, {Part::light}, {Part::light, 1}, {Part::light, 7}, {Part::light, -1}};
  return all;
}

/// The numbers of a shape.
struct ShapeNumbers : SomeShapeFields {
  void point(const FieldName&, Point& value) override { allPoints.push_back(value); }
  void direction(const FieldName&, Vector& value) override { allPoints.push_back(value); }
  void length(const FieldName&, double& value) override { allLengths.push_back(value); }
  void lengths(const FieldName&, std::span<double> values) override {
    allLengths.insert(allLengths.end(), values.begin(), values.end());
  }
  void radii(const FieldName& name, std::vector<double>& values) override { lengths(name, values); }
  void curve(const FieldName&, std::vector<CurvePoint>& values) override {
    for (const CurvePoint& p : values) allPoints.emplace_back(p.x, p.y, 0);
  }
  void heights(const FieldName&, HeightGrid& grid) override {
    for (const double height : grid.heights) allPoints.emplace_back(0, 0, height);
  }
  void points(const FieldName&, std::span<Point> values) override {
    allPoints.insert(allPoints.end(), values.begin(), values.end());
  }

  std::vector<Point> allPoints;
  std::vector<double> allLengths;
};

/// Whether every number that edits can change is finite and within what a level file can have.
inline bool isSound(const Level& level) {
  bool sound = true;
  const auto point = [&](const Point& p) { sound &= isFinite(p) && glm::length(p) <= 2e6; };
  const auto size = [&](double s) { sound &= std::isfinite(s) && s >= 0; };
  ShapeNumbers numbers;
  Shape shape = level.optic.shape();
  visitFields(shape, numbers);
  for (const Point& p : numbers.allPoints) point(p);
  for (const double length : numbers.allLengths) size(length);
  point(level.camera.eye);
  point(level.camera.target);
  point(level.camera.up);
  point(level.original.placement.position);
  point(level.original.placement.rotationDegrees);
  for (int i = 0; i < 3; ++i) size(level.original.placement.scale[i]);
  for (const PointLight& light : level.lights) point(light.position);
  size(level.sculpture.depthScale);
  return sound;
}

/// How far two levels are apart in what edits can change, as a length.
inline double differenceOf(const Level& a, const Level& b) {
  double difference = std::abs(a.sculpture.depthScale - b.sculpture.depthScale);
  const auto point = [&](const Point& p, const Point& q) {
    difference = std::max(difference, glm::length(p - q));
  };
  point(a.camera.eye, b.camera.eye);
  point(a.camera.target, b.camera.target);
  point(a.camera.up, b.camera.up);
  for (std::size_t i = 0; i < a.lights.size(); ++i) point(a.lights[i].position, b.lights[i].position);
  for (const Point& p : {Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), Point(0)}) {
    point(PlacementMap(a.original.placement)(p), PlacementMap(b.original.placement)(p));
  }
  const Mesh m = tessellate(a.optic.shape(), 8).mesh, n = tessellate(b.optic.shape(), 8).mesh;
  const auto* tube = a.optic.shape().as<CylinderMirror>();
  if (tube) {  // its triangles may be turned about the axis
    const auto& other = shapeAs<CylinderMirror>(b.optic.shape());
    point(tube->bottom, other.bottom);
    point(tube->top, other.top);
    return std::max(difference, std::abs(tube->radius - other.radius));
  }
  if (const auto* cone = a.optic.shape().as<ConeMirror>()) {
    const auto& other = shapeAs<ConeMirror>(b.optic.shape());
    point(cone->bottom, other.bottom);
    point(cone->top, other.top);
    return std::max({difference, std::abs(cone->bottomRadius - other.bottomRadius),
                     std::abs(cone->topRadius - other.topRadius)});
  }
  if (const auto* bowl = a.optic.shape().as<ParaboloidMirror>()) {
    const auto& other = shapeAs<ParaboloidMirror>(b.optic.shape());
    point(bowl->vertex, other.vertex);
    point(bowl->axis, other.axis);
    return std::max({difference, std::abs(bowl->focalLength - other.focalLength),
                     std::abs(bowl->radius - other.radius), std::abs(bowl->innerRadius - other.innerRadius)});
  }
  for (std::size_t i = 0; i < m.positions.size(); ++i) point(m.positions[i], n.positions[i]);
  return difference;
}

}  // namespace anamorph::testing
