#include "edit/construction.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "anamorphosis/ray_bundle.h"
#include "base/language.h"
#include "pipeline/stages.h"

namespace anamorph {
namespace {

using Kind = ConstructionSegment::Kind;

constexpr int arcSegments = 24;
constexpr double farthestFocus = 8;  // |QS|: others are no danger to the sculpture

std::string pointText(const Point& p) {
  return shownFormat("({:.2f}, {:.2f}, {:.2f})", p.x, p.y, p.z);
}
std::string directionText(const Direction& d) {
  return shownFormat("({:.3f}, {:.3f}, {:.3f})", d.x, d.y, d.z);
}
std::string angleText(double angleDegrees) {
  return shownFormat("{:.1f}°", angleDegrees);
}

// From direction `from` to `to` (unit), turned at an even speed in their plane.
Direction turned(const Direction& from, const Direction& to, double fraction) {
  const double angle = std::atan2(glm::length(glm::cross(from, to)), glm::dot(from, to));
  const Vector side = to - glm::dot(to, from) * from;
  const double sine = glm::length(side);
  if (!(sine > 1e-12)) return from;
  return std::cos(fraction * angle) * from + (std::sin(fraction * angle) / sine) * side;
}

ConstructionArc makeArc(const Point& centre, double radius, const Direction& from, const Direction& to,
                        const std::string& text) {
  ConstructionArc arc;
  for (int i = 0; i <= arcSegments; ++i) {
    arc.points.push_back(centre + radius * turned(from, to, double(i) / arcSegments));
  }
  arc.label = {centre + 1.25 * radius * turned(from, to, 0.5), text};
  return arc;
}

// Long enough to be seen, short enough to stay near Q.
double normalLength(double toEye, double reach) {
  return std::max(std::min(0.3 * toEye, 0.8 * reach), 0.08 * toEye);
}

const char* reachName(const VertexMap& map) {
  if (map.depthOffset != 0) return "d₀ + k·d";
  return map.depthScale == 1 ? "d" : "k·d";
}

// How far a reflected ray goes that meets the mirror again.
double freeWay(const VertexMap& map, const VertexRay& ray, double wanted) {
  const Vector towards = ray.original - ray.eye;
  const double way = freeLength(map.optic, followRay(map.optic, {ray.eye, towards})) * glm::length(towards);
  return std::isfinite(way) ? std::min(way, wanted) : wanted;
}

// False only where the published formulas are at work.
bool anglesAreEqual(const VertexLeg& leg) {
  return std::abs(leg.angleOutDegrees - leg.angleInDegrees) < 0.05;
}

void addReflection(Construction& made, const VertexMap& map) {
  const VertexRay& ray = made.ray;
  const VertexLeg& last = ray.legs.back();
  const double reach = ray.mapped() ? ray.reach : freeWay(map, ray, ray.reach);
  const Point end = ray.mapped() ? ray.sculpture : last.start + reach * last.direction;
  made.segments.push_back({last.start, ray.original, Kind::virtualRay});
  for (std::size_t i = 0; i < ray.legs.size(); ++i) {
    const bool isLast = i + 1 == ray.legs.size();
    made.segments.push_back({ray.legs[i].start, isLast ? end : ray.legs[i + 1].start, Kind::reflected});
  }
  made.distances.push_back({0.5 * (last.start + ray.original), shownFormat("d = {:.2f}", ray.distance)});
  if (!ray.mapped()) return;
  made.points.push_back({ray.sculpture, "S"});
  made.distances.push_back({0.5 * (last.start + end), shownFormat("{} = {:.2f}", reachName(map), reach)});
}

// Where neighbouring rays cross, on the way to S or a little beyond.
void addFoci(Construction& made, const VertexMap& map) {
  const VertexRay& ray = made.ray;
  if (map.mistakes.any() || !ray.mapped()) return;
  const auto bundle = bundleAround(map, ray.original);
  const std::vector<double> foci = bundle ? bundle->foci() : std::vector<double>();
  const VertexLeg& last = ray.legs.back();
  std::string distances;
  double farthest = ray.reach;
  for (const double focus : foci) {
    if (focus > farthestFocus * ray.reach) continue;
    made.points.push_back({last.start + focus * last.direction, "F"});
    farthest = std::max(farthest, focus);
    distances += (distances.empty() ? "" : ", ") + shownFormat("{:.3f}", focus);
  }
  if (farthest > ray.reach)
    made.segments.push_back({ray.sculpture, last.start + farthest * last.direction, Kind::virtualRay});
  if (!distances.empty()) made.rows.push_back({"|QF|  rays cross", distances});
}

// Q with N and both angles; `from` is where the ray came from.
void addMirrorPoint(Construction& made, const VertexLeg& leg, const Point& from, double length) {
  const Vector back = from - leg.start;
  const double way = glm::length(back);
  made.segments.push_back({leg.start, leg.start + length * leg.normal, Kind::normal});
  made.points.push_back({leg.start, "Q"});
  made.points.push_back({leg.start + length * leg.normal, "N"});
  if (made.ray.status == PathStatus::inFrontOfMirror) return;  // the ray ends at P, before it is reflected
  const std::string in = "α = " + angleText(leg.angleInDegrees);
  const std::string out = anglesAreEqual(leg) ? in : "β = " + angleText(leg.angleOutDegrees);
  if (way > 0) made.arcs.push_back(makeArc(leg.start, 0.6 * length, back / way, leg.normal, in));
  made.arcs.push_back(makeArc(leg.start, 0.6 * length, leg.normal, leg.direction, out));
}

void addMirrorPoints(Construction& made, const VertexMap& map) {
  const VertexRay& ray = made.ray;
  const double toEye = glm::length(ray.eye - ray.legs.front().start);
  const double length = normalLength(toEye, ray.reach);
  made.segments.push_back({ray.eye, ray.legs.front().start, Kind::incident});
  Point from = ray.eye;
  for (const VertexLeg& leg : ray.legs) {
    addMirrorPoint(made, leg, from, length);
    from = leg.start;
  }
  if (ray.status != PathStatus::inFrontOfMirror) addReflection(made, map);
}

// The one line of sight, as far as something lies on it.
void addSight(Construction& made, const VertexMap& map) {
  const VertexRay& ray = made.ray;
  const Point canvas = ray.legs.back().start;
  Point far = ray.original;
  for (const Point& p : {canvas, ray.mapped() ? ray.sculpture : ray.original}) {
    if (glm::length(p - ray.eye) > glm::length(far - ray.eye)) far = p;
  }
  made.segments.push_back({ray.eye, far, Kind::incident});
  made.points.push_back({canvas, "Q"});
  made.distances.push_back({0.5 * (canvas + ray.original), shownFormat("d = {:.2f}", ray.distance)});
  if (!ray.mapped()) return;
  made.points.push_back({ray.sculpture, "S"});
  made.segments.push_back({canvas, ray.sculpture, Kind::reflected});
  made.distances.push_back(
      {0.5 * (canvas + ray.sculpture),
       shownFormat("{} = {:.2f}", map.depthOffset == 0 ? "k·d" : reachName(map), ray.reach)});
}

void addSightRows(Construction& made, const VertexMap& map) {
  const VertexRay& ray = made.ray;
  made.rows = {{"E  eye", pointText(ray.eye)},
               {"P  original vertex", pointText(ray.original)},
               {"Q  on the canvas", pointText(ray.legs.back().start)},
               {"d = |PQ|", shownFormat("{:.3f}", ray.distance)},
               {"k  depth scale", shownFormat("{:.3f}", map.depthScale)}};
  const bool offset = map.depthOffset != 0;
  if (offset) made.rows.push_back({"d₀  depth offset", shownFormat("{:.3f}", map.depthOffset)});
  if (!ray.mapped()) return;
  made.rows.push_back({offset ? "S = Q + k (P − Q) + d₀ R" : "S = Q + k (P − Q)", pointText(ray.sculpture)});
}

void addRows(Construction& made, const VertexMap& map) {
  const VertexRay& ray = made.ray;
  const auto add = [&](const char* name, std::string value) {
    made.rows.push_back({name, std::move(value)});
  };
  const auto addLength = [&](const char* name, double length) { add(name, shownFormat("{:.3f}", length)); };
  add("E  eye", pointText(ray.eye));
  add("P  original vertex", pointText(ray.original));
  for (const VertexLeg& leg : ray.legs) {
    add("Q  mirror point", pointText(leg.start));
    add("N  normal at Q", directionText(leg.normal));
    if (ray.status == PathStatus::inFrontOfMirror) continue;
    if (anglesAreEqual(leg)) {
      add("α  both angles", angleText(leg.angleInDegrees));
    } else {
      add("α  angle in", angleText(leg.angleInDegrees));
      add("β  angle out", angleText(leg.angleOutDegrees));
    }
    add("R  reflected", directionText(leg.direction));
  }
  if (ray.meets() && ray.status != PathStatus::inFrontOfMirror) {
    // The published formula measures to another point than P.
    addLength(map.mistakes.distance ? "d  as published" : "d = |PQ|", ray.distance);
    addLength("k  depth scale", map.depthScale);
    if (map.depthOffset != 0) addLength("d₀  depth offset", map.depthOffset);
  }
  if (ray.mapped()) {
    const bool offset = map.depthOffset != 0;
    addLength(offset ? "d₀ + k·d = |QS|" : "k·d = |QS|", ray.reach);
    add(offset ? "S = Q + (d₀ + k·d) R" : "S = Q + k·d R", pointText(ray.sculpture));
  }
}

// What of the ray can be drawn.
bool isDrawable(const VertexRay& ray) {
  return ray.meets() && std::all_of(ray.legs.begin(), ray.legs.end(), [](const VertexLeg& leg) {
           return lengthSquared(leg.normal) > 0.5 && isFinite(leg.start) && isFinite(leg.direction);
         });
}

}  // namespace

Construction makeConstruction(const VertexMap& map, const Point& original) {
  Construction made;
  made.ray = makeVertexRay(map, original);
  if (!isDrawable(made.ray)) made.ray.legs.clear();
  made.points = {{map.eye, "E"}, {original, "P"}};
  if (made.ray.meets() && !made.ray.bends) {
    addSight(made, map);
    addSightRows(made, map);
  } else {
    if (made.ray.meets()) {
      addMirrorPoints(made, map);
    } else {
      made.segments.push_back({map.eye, original, Kind::incident});
    }
    addRows(made, map);
    addFoci(made, map);
  }
  if (!made.ray.mapped()) {
    made.explanation = explainStatus(made.ray.status) + std::string(".");
    made.explanation[0] = static_cast<char>(std::toupper(made.explanation[0]));
  }
  return made;
}

const std::optional<Construction>& ConstructionStage::at(const VertexMap& map, const Point& original) {
  return memo_.get({map, original}, [](const Input& input) {
    return std::optional(makeConstruction(input.map, input.original));
  });
}

}  // namespace anamorph
