// The mirror of a grid of heights over a rectangle: a uniform bicubic B-spline z = f(x, y).
//
//        Y                 X = unit(across), Y = unit(up), made perpendicular to X, Z = X x Y, from the origin
//        |   z = f(x,y)    0 <= x <= size[0], 0 <= y <= size[1]; heights[row][column], rows along Y
//        '-------- X       (rows - 3) x (columns - 3) cells; along a ray of degree 6 in each
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "math/uniform_spline.h"
#include "optics/spline_ray.h"

namespace anamorph {

struct PatchMirror {
  static constexpr const char *name = "patch", *label = "Free form";
  static constexpr int since = 2;

  Point origin{-6, 0, 0};
  Vector across{1, 0, 0};  ///< of any length > 0
  Vector up{0, 0, 1};      ///< not along `across`
  std::array<double, 2> size{12, 8};
  HeightGrid heights{6, {0,   0,   0,   0,   0,   0,    //
                         0,   0.3, 0.5, 0.5, 0.3, 0,    //
                         0.1, 0.6, 1,   1,   0.6, 0.1,  //
                         0.1, 0.6, 1,   1,   0.6, 0.1,  //
                         0,   0.3, 0.5, 0.5, 0.3, 0,    //
                         0,   0,   0,   0,   0,   0}};  ///< control values
  bool operator==(const PatchMirror&) const = default;

  void visitFields(ShapeFields& fields) {
    fields.point({"origin", "Origin", "The corner where x and y are 0."}, origin);
    fields.direction({"across", "Across", "The x axis: along the rows of heights."}, across);
    fields.direction({"up", "Up", "The y axis: from row to row."}, up);
    fields.lengths({"size", "Size", "Along x and along y."}, size);
    fields.heights({"heights", "Height", "What the surface is drawn towards, in front of its plane."},
                   heights);
  }

  // ---- Rays

  struct Cell {
    std::array<Cubic, 4> rows;  ///< Bezier control heights
    double least, greatest;     ///< of them
  };
  struct Prepared {
    Axes axes;
    std::array<double, 2> size;
    std::array<int, 2> count{};  ///< of cells, along x and y
    std::vector<Cell> cells;     ///< row by row
    double least, greatest;      ///< of all

    std::array<double, 2> cellSize() const { return {size[0] / count[0], size[1] / count[1]}; }
    const Cell& cell(int column, int row) const {
      return cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(count[0]) +
                   static_cast<std::size_t>(column)];
    }
  };
  Prepared prepare() const;
  std::optional<SurfaceHit> intersect(const Prepared& prepared, const Ray& ray, double tMin) const {
    return firstHit(prepared, ray, tMin, {});
  }
  bool meetsBetween(const Prepared& prepared, const Ray& ray, double tMin, double tMax) const {
    return firstHit(prepared, ray, tMin, {tMin, tMax}).has_value();
  }

  std::size_t bytes() const { return heights.heights.size() * (sizeof(double) + sizeof(Cell)); }

  // ---- What can be wrong

  std::optional<std::string> findProblem() const;
  std::optional<std::string> findEyeProblem(const Prepared& prepared, const Point& eye) const;
  Point eyeOutside(const Point& eye, const Point& original) const;

  // ---- Its place

  /// To a hundred thousandth of its size, never too small.
  Box box() const;
  Point middle() const { return pointAt(0.5, 0.5); }
  /// Along its width, through it, up its side: the scene's for one that stands upright.
  Axes axes() const;
  ShapeExtent extent() const;
  /// Gently bulging towards the eye.
  static PatchMirror filling(const ShapeExtent& room, const Point& eye);
  std::vector<ControlPoint> controlPoints() const;
  void moveControlPoint(std::size_t number, const Vector& motion);
  void map(const ShapeMap& map);
  /// Level, as far again on all sides.
  void carryOn();

  // ---- How it is drawn and described

  Point pointAt(double u, double v) const;
  Direction normalAt(double u, double v) const;
  std::array<int, 2> gridFor(int segments) const;
  SurfaceLines lines() const;
  double borderDistance(const Point& p) const;
  ShapeWords words(LengthText text) const;

 private:
  /// The first crossing at t > tMin of a stretch of the ray.
  std::optional<SurfaceHit> firstHit(const Prepared& prepared, const Ray& ray, double tMin,
                                     const Stretch& within) const;
  struct Place {
    double height, slopeX, slopeY;
  };
  Place placeAt(double x, double y) const;
  /// The same in a cell, 0..1 both ways.
  Place placeIn(const Cell& cell, double u, double v) const;
  Axes frame() const;  ///< X, Y, Z
  std::array<int, 2> cellCount() const;
};

}  // namespace anamorph
