// How a shape tells of its fields: it hands them one after the other, in the order of the file, to whoever walks over
// them: the level file, its schema, the panels, lessons. A new kind of field is a new function here, and the compiler
// asks all of them what they make of it.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "geometry/smooth_mesh.h"
#include "math/uniform_spline.h"
#include "math/vec.h"

namespace anamorph {

struct FieldName {
  const char* key;    ///< in files
  const char* label;  ///< in panels, English
  const char* help = "";
  bool mayBeZero = false;                   ///< of a length: else it is > 0
  bool mayBeAbsent = false;                 ///< in files; then it is what it was
  std::size_t fewest = fewestOpenControls;  ///< of the control values of a curve
};

/// A point of a curve in its own plane.
using CurvePoint = glm::dvec2;

/// Numbers in rows of equal length.
struct HeightGrid {
  std::size_t columns = 0;
  std::vector<double> heights;  ///< row by row

  bool operator==(const HeightGrid&) const = default;
  std::size_t rows() const { return columns > 0 ? heights.size() / columns : 0; }
  double at(std::size_t row, std::size_t column) const { return heights[row * columns + column]; }
  double& at(std::size_t row, std::size_t column) { return heights[row * columns + column]; }
};

class Bvh;

/// A mesh file that a surface is made of. Its mesh is read when the level is (pipeline/mirror_files.h); levels are equal
/// when path and mesh are.
struct SurfaceFile {
  /// More would take a computer's memory and seconds of every change.
  static constexpr std::size_t mostTriangles = 5'000'000;

  std::string path;                        ///< as it was written
  std::shared_ptr<const SmoothMesh> mesh;  ///< null: it has not been read
  std::string problem;                     ///< why not
  std::shared_ptr<const Bvh> tree{};       ///< of the mesh: one for all that share it

  bool operator==(const SurfaceFile& other) const {
    return path == other.path && problem == other.problem &&
           (mesh == other.mesh || (mesh && other.mesh && *mesh == *other.mesh));
  }
};

class ShapeFields {
 public:
  virtual ~ShapeFields() = default;
  virtual void point(const FieldName& name, Point& value) = 0;
  /// Of any length > 0.
  virtual void direction(const FieldName& name, Vector& value) = 0;
  /// Degrees about x, then y, then z.
  virtual void angles(const FieldName& name, Vector& value) = 0;
  virtual void length(const FieldName& name, double& value) = 0;
  virtual void flag(const FieldName& name, bool& value) = 0;
  /// Several points under one key; in panels each has the label and its number.
  virtual void points(const FieldName& name, std::span<Point> values) = 0;
  /// So many lengths under one key.
  virtual void lengths(const FieldName& name, std::span<double> values) = 0;
  /// As many radii as there are wanted: control values of a spline.
  virtual void radii(const FieldName& name, std::vector<double>& values) = 0;
  /// As many points as there are wanted: control points of a spline.
  virtual void curve(const FieldName& name, std::vector<CurvePoint>& values) = 0;
  virtual void heights(const FieldName& name, HeightGrid& values) = 0;
  virtual void file(const FieldName& name, SurfaceFile& value) = 0;
  /// A length that is no field, because it follows from two points; only panels show it.
  virtual void distance(const FieldName& /*name*/, const Point& /*from*/, Point& /*to*/) {}
};

/// For who wants some kinds only.
class SomeShapeFields : public ShapeFields {
 public:
  void point(const FieldName&, Point&) override {}
  void direction(const FieldName&, Vector&) override {}
  void angles(const FieldName&, Vector&) override {}
  void length(const FieldName&, double&) override {}
  void flag(const FieldName&, bool&) override {}
  void points(const FieldName&, std::span<Point>) override {}
  void lengths(const FieldName&, std::span<double>) override {}
  void radii(const FieldName&, std::vector<double>&) override {}
  void curve(const FieldName&, std::vector<CurvePoint>&) override {}
  void heights(const FieldName&, HeightGrid&) override {}
  void file(const FieldName&, SurfaceFile&) override {}
};

}  // namespace anamorph
