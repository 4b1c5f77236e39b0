// A mirror of triangles from a mesh file, for surfaces that have no formula. A ray meets a flat triangle, whichever comes
// first, and is reflected by the mean of the normals at its corners, which the file has (vn) or its faces give:
//
//        n0 .            Q = b0 p0 + b1 p1 + b2 p2       N = unit(b0 n0 + b1 n1 + b2 n2)
//          / \  N
//      n1 '---' n2       b: Q's barycentric coordinates
//
// What is seen in it is smooth, with an error that falls with the square of the triangles' size. The file is never
// written: what moves the mirror changes its placement.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "geometry/bvh.h"
#include "geometry/smooth_mesh.h"
#include "math/placement.h"
#include "optics/shape_helpers.h"

namespace anamorph {

struct MeshMirror {
  static constexpr const char *name = "mesh", *label = "Mesh from a file...";
  static constexpr int since = 2;
  static constexpr bool needsFile = true;

  SurfaceFile file;
  Placement placement;
  bool operator==(const MeshMirror&) const = default;

  void visitFields(ShapeFields& fields);

  /// Rays are sent through the file's own mesh, so that a mirror that is moved needs no tree of its own.
  struct Prepared {
    std::shared_ptr<const Bvh> tree;  ///< null: nothing is met
    glm::dmat3 turn{1};
    Box box;
    Point middle{0};  ///< of the file's own box: turning leaves it where it is
  };
  Prepared prepare() const;

  // ---- Rays

  std::optional<SurfaceHit> intersect(const Prepared& prepared, const Ray& ray, double tMin) const;

  // ---- What can be wrong

  std::optional<std::string> findProblem() const;
  std::optional<std::string> findEyeProblem(const Prepared& prepared, const Point& eye) const;
  Point eyeOutside(const Prepared& prepared, const Point& eye, const Point& original) const;

  // ---- Its place

  Box box(const Prepared& prepared) const { return prepared.box; }
  Point middle(const Prepared& prepared) const { return prepared.middle; }
  Axes axes() const;
  ShapeExtent extent(const Prepared& prepared) const;
  /// One that waits for its file.
  static MeshMirror filling(const ShapeExtent& room, const Point& eye);
  void map(const ShapeMap& map);
  /// A mesh ends where it ends: only its outline grows.
  void carryOn();

  // ---- How it is drawn and described

  /// Of the triangle that is the fraction u of the way through the file.
  Point pointAt(double u, double v) const;
  /// The mesh itself, however many segments are wanted.
  SmoothMesh tessellate(int segments) const;
  /// It has no parameters to draw lines of.
  SurfaceLines lines() const { return {0, 0, false, 0, 0, {}, {}}; }
  double borderDistance(const Point&) const { return 1; }
  ShapeWords words(const Prepared& prepared, LengthText text) const;
};

}  // namespace anamorph
