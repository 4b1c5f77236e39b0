// Triangle meshes: shared corner points and the triangles between them. Plain data; everything that reads or makes a
// mesh is a free function of the files beside this one.
//
// Points are kept as three separate arrays x, y, z. The deformation reads and writes nothing but points, and with
// separate arrays its loops vectorise.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "math/box.h"
#include "math/vec.h"

namespace anamorph {

class PointArray {
 public:
  PointArray() = default;
  explicit PointArray(std::size_t count) : x(count), y(count), z(count) {}

  bool operator==(const PointArray&) const = default;
  std::size_t size() const { return x.size(); }
  bool empty() const { return x.empty(); }
  Point operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
  void set(std::size_t i, const Point& p) {
    x[i] = p.x;
    y[i] = p.y;
    z[i] = p.z;
  }
  void push_back(const Point& p) {
    x.push_back(p.x);
    y.push_back(p.y);
    z.push_back(p.z);
  }
  void resize(std::size_t count) {
    for (auto* axis : {&x, &y, &z}) axis->resize(count);
  }
  void reserve(std::size_t count) {
    for (auto* axis : {&x, &y, &z}) axis->reserve(count);
  }

  std::vector<double> x, y, z;  ///< always of the same size
};

/// Corner indices, counter-clockwise seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

struct Mesh {
  PointArray positions;
  std::vector<Triangle> triangles;

  bool operator==(const Mesh&) const = default;
};

/// The box of all positions, used by a triangle or not; empty for an empty mesh.
Box boundingBox(const PointArray& points);

/// Every position through `map`, a callable Point -> Point.
template <typename Map>
PointArray mapPoints(const PointArray& points, const Map& map) {
  PointArray result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) result.set(i, map(points[i]));
  return result;
}

/// (b - a) x (c - a): twice the area long, pointing outwards.
Vector areaVector(const PointArray& points, const Triangle& triangle);

/// Volume inside a closed mesh; positive when its triangles are counter-clockwise seen from outside.
double signedVolume(const Mesh& mesh);

/// Whether every edge is used exactly once in each direction, so that the surface has no border and one orientation.
/// Corners count as the same when their indices are: weld first.
bool isClosed(const Mesh& mesh);

struct WeldedMesh {
  Mesh mesh;
  std::vector<std::uint32_t> vertexOf;    ///< for each old position, its new index
  std::vector<std::uint32_t> triangleOf;  ///< for each new triangle, the old one it was
};

/// Joins positions with equal coordinates (files repeat them along texture seams, STL for every triangle). Triangles
/// that have two equal corners afterwards are dropped. New positions keep the order of their first appearance.
WeldedMesh weldPositions(const Mesh& mesh);

/// Centred on the origin and scaled by one factor so that the longest side of the box is 1: the mesh fits the unit
/// cube with its proportions kept. A mesh without extent is only centred.
Mesh unitize(Mesh mesh);

}  // namespace anamorph
