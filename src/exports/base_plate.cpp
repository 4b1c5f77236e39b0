#include "exports/base_plate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/language.h"
#include "exports/printable.h"
#include "exports/triangle_crossing.h"
#include "geometry/bvh.h"

namespace anamorph {
namespace {

using Point2 = glm::dvec2;

constexpr int sides = 16;       // of a post
constexpr int candidates = 32;  // along each side of the footprint's box
constexpr std::size_t maxPosts = 4;
constexpr double overlapMillimetres = 0.5;  // that shells reach into each other
constexpr double letInMillimetres = 0.2;    // a lower rim around a sculpture on the table hides less
constexpr double postFraction = 0.025;      // radius, of the sculpture's diagonal
constexpr double minPostRadius = 1, maxPostRadius = 4;

double turn(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

Point2 onCircle(int i) {
  const double angle = 2 * pi * i / sides;
  return {std::cos(angle), std::sin(angle)};
}

std::vector<Point2> outlineOf(const Mesh& sculpture, double margin) {
  std::vector<Point2> points;
  for (std::size_t i = 0; i < sculpture.positions.size(); ++i) {
    points.push_back({sculpture.positions.x[i], sculpture.positions.y[i]});
  }
  std::vector<Point2> wider;
  for (const Point2& p : convexHull(std::move(points))) {
    for (int i = 0; i < sides; ++i) wider.push_back(p + margin * onCircle(i));
  }
  return convexHull(std::move(wider));
}

// A convex column: below every corner of the outline one at `bottom`, above it one at its own height.
Mesh makeColumn(const std::vector<Point2>& outline, double bottom, const std::vector<double>& tops,
                const Point2& middle, double middleTop) {
  Mesh mesh;
  const auto n = static_cast<std::uint32_t>(outline.size());
  for (const Point2& p : outline) mesh.positions.push_back({p.x, p.y, bottom});
  for (std::uint32_t i = 0; i < n; ++i) mesh.positions.push_back({outline[i].x, outline[i].y, tops[i]});
  mesh.positions.push_back({middle.x, middle.y, bottom});
  mesh.positions.push_back({middle.x, middle.y, middleTop});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    mesh.triangles.push_back({i, j, n + j});
    mesh.triangles.push_back({i, n + j, n + i});
    mesh.triangles.push_back({2 * n, j, i});
    mesh.triangles.push_back({2 * n + 1, n + i, n + j});
  }
  return mesh;
}

Mesh makePlate(const std::vector<Point2>& outline, double bottom, double thickness) {
  Point2 middle{0};
  for (const Point2& p : outline) middle += p / double(outline.size());
  const std::vector<double> tops(outline.size(), bottom + thickness);
  return makeColumn(outline, bottom, tops, middle, bottom + thickness);
}

// Looks for places of posts below the sculpture and beside the mirror.
class Underside {
 public:
  Underside(const Mesh& sculpture, const Mesh& mirror, double plateMiddle)
      : box_(boundingBox(sculpture.positions)),
        start_(plateMiddle),
        sculpture_(sculpture.positions, sculpture.triangles),
        mirror_(mirror.positions, mirror.triangles) {}

  const Box& box() const { return box_; }

  /// The height to which a post reaches above this place: a little into the sculpture. Nothing where there is
  /// no sculpture above.
  std::optional<double> topAt(const Point2& place) const {
    const Ray up{{place.x, place.y, start_}, {0, 0, 1}};
    BvhHit lower, upper;
    if (!sculpture_.closestHit(up, lower)) return std::nullopt;
    const double lift = 1e-9 * box_.diagonal();
    const bool leaves = sculpture_.closestHit(up, upper, lower.t + lift);
    const double thickness = leaves ? upper.t - lower.t : 0;
    return start_ + lower.t + std::min(overlapMillimetres, 0.5 * thickness);
  }

  /// Whether a post of this radius has sculpture above all of it, and no mirror in its way.
  bool bears(const Point2& place, double radius) const {
    const auto isFree = [&](const Point2& p) {
      const auto top = topAt(p);
      return top && !mirror_.anyHit({{p.x, p.y, start_}, {0, 0, 1}}, 0, *top - start_);
    };
    for (int i = 0; i < sides; ++i) {
      if (!isFree(place + radius * onCircle(i))) return false;
    }
    return isFree(place);
  }

 private:
  Box box_;
  double start_;
  Bvh sculpture_, mirror_;
};

std::vector<Point2> findPlaces(const Underside& underside, double radius) {
  std::vector<Point2> places;
  const Vector step = underside.box().size() / double(candidates);
  for (int y = 0; y < candidates; ++y) {
    for (int x = 0; x < candidates; ++x) {
      const Point p = underside.box().min + Vector((x + 0.5) * step.x, (y + 0.5) * step.y, 0);
      if (underside.bears({p.x, p.y}, radius)) places.push_back({p.x, p.y});
    }
  }
  return places;
}

// As far apart as they can be: the one farthest from the middle first, then always the one farthest from all
// that are chosen (Gonzalez 1985).
std::vector<Point2> spread(const std::vector<Point2>& places, double leastDistance) {
  if (places.empty()) return {};
  Point2 middle{0};
  for (const Point2& p : places) middle += p / double(places.size());
  std::vector<double> distance;
  for (const Point2& p : places) distance.push_back(glm::length(p - middle));
  std::vector<Point2> chosen;
  while (chosen.size() < maxPosts) {
    const auto farthest = std::max_element(distance.begin(), distance.end());
    if (!chosen.empty() && *farthest < leastDistance) break;
    chosen.push_back(places[static_cast<std::size_t>(farthest - distance.begin())]);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double apart = glm::length(places[i] - chosen.back());
      distance[i] = chosen.size() == 1 ? apart : std::min(distance[i], apart);
    }
  }
  return chosen;
}

// Its top follows the underside of the sculpture.
Mesh makePost(const Underside& underside, const Point2& place, double radius, double bottom) {
  const double middleTop = underside.topAt(place).value_or(bottom);
  std::vector<Point2> outline;
  std::vector<double> tops;
  for (int i = 0; i < sides; ++i) {
    outline.push_back(place + radius * onCircle(i));
    tops.push_back(underside.topAt(outline.back()).value_or(middleTop));
  }
  return makeColumn(outline, bottom, tops, place, middleTop);
}

bool meet(const Mesh& a, const Mesh& b) {
  const auto corners = [](const Mesh& mesh, const Triangle& t) {
    return TriangleCornerPoints{mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]};
  };
  for (const Triangle& s : a.triangles) {
    for (const Triangle& t : b.triangles) {
      if (trianglesCross(corners(a, s), corners(b, t))) return true;
    }
  }
  return false;
}

// Narrower posts where there is little place.
void addPosts(const Underside& underside, BasePlate& plate) {
  double radius = std::clamp(postFraction * underside.box().diagonal(), minPostRadius, maxPostRadius);
  std::vector<Point2> places;
  for (int i = 0; i < 3 && places.empty(); ++i) {
    plate.postRadius = radius;
    places = findPlaces(underside, radius);
    radius /= 2;
  }
  if (places.empty()) {
    throw Error(
        tr("no base plate can bear this sculpture: the mirror stands below it, or it is too thin for a "
           "post. Leave the base plate out, and hang the sculpture up at the height that the viewing "
           "sheet says"));
  }
  plate.posts = spread(places, 3 * plate.postRadius);
  const double inPlate = plate.lowerFace + 0.5 * plate.thickness;
  for (const Point2& place : plate.posts) {
    appendMesh(plate.mesh, makePost(underside, place, plate.postRadius, inPlate));
  }
}

}  // namespace

std::vector<Point2> convexHull(std::vector<Point2> points) {
  std::sort(points.begin(), points.end(), [](const Point2& a, const Point2& b) {
    return std::pair{a.x, a.y} < std::pair{b.x, b.y};
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Point2> hull;
  // The lower chain from left to right, then the upper one back.
  for (int chain = 0; chain < 2; ++chain) {
    const std::size_t first = hull.size();
    for (const Point2& p : points) {
      while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();  // it begins the other chain
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

BasePlate makeBasePlate(const Mesh& sculpture, const Mesh& mirror, double table,
                        const BasePlateSettings& settings) {
  const double lowest = boundingBox(sculpture.positions).min.z;
  const double overlap = std::min(letInMillimetres, 0.5 * settings.thickness);
  BasePlate plate;
  plate.thickness = settings.thickness;
  plate.outline = outlineOf(sculpture, settings.margin);
  const bool floats = table + settings.thickness <= lowest + overlap;
  plate.lowerFace = floats ? table : lowest + overlap - settings.thickness;
  plate.mesh = makePlate(plate.outline, plate.lowerFace, plate.thickness);
  if (floats) addPosts(Underside(sculpture, mirror, table + 0.5 * settings.thickness), plate);
  if (meet(plate.mesh, mirror)) {
    throw Error(
        tr("no base plate fits under this sculpture: it would meet the mirror. Leave it out, or make its "
           "margin smaller"));
  }
  return plate;
}

}  // namespace anamorph
