// The map of mirror anamorphosis as a value: from a vertex P of the original to the vertex S of the sculpture
// (method section 2). Whatever two maps are equal send every point to the same place.
#pragma once

#include "optics/mistakes.h"
#include "optics/optic.h"

namespace anamorph {

struct VertexMap {
  Optic optic;
  Point eye{0};
  double depthScale = 1;   ///< k
  double depthOffset = 0;  ///< scene units
  Mistakes mistakes{};

  bool operator==(const VertexMap&) const = default;
};

/// How far beyond the optic the vertex of a point lies that is `towards` from the eye, in lengths of that ray: k times
/// the rest of the way, and the offset.
double exitLength(const VertexMap& map, const OpticPath& path, const Vector& towards);

/// Where a point goes, and what became of it. Not mapped: the point itself.
struct MappedPoint {
  Point point;
  PathStatus status;
};
MappedPoint mapPoint(const VertexMap& map, const Point& original);
/// The same when the path of the ray from the eye to `original` is known.
MappedPoint mapAlong(const VertexMap& map, const OpticPath& path, const Point& original);

/// The ray through a point as the published formulas have it, where the map makes mistakes.
struct PublishedRay {
  Direction normal{0};
  Direction reflected{0};  ///< unit
  double distance = 0;     ///< without the depth scale
  Point sculpture{0};
};
/// `path` is that of the ray from the eye to `original`, and meets the optic.
PublishedRay followPublished(const VertexMap& map, const OpticPath& path, const Point& original);

/// Whether the map makes any of the published mistakes: where nothing bends light there are none to make.
bool makesMistakes(const VertexMap& map, const OpticPath& path);

}  // namespace anamorph
