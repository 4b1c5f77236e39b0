#include "edit/construction.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "pipeline/stages.h"

namespace anamorph {
namespace {

using Kind = ConstructionSegment::Kind;

constexpr int arcSegments = 24;

std::string pointText(const Point& p) {
  return fmt::format("({:.2f}, {:.2f}, {:.2f})", p.x, p.y, p.z);
}
std::string directionText(const Direction& d) {
  return fmt::format("({:.3f}, {:.3f}, {:.3f})", d.x, d.y, d.z);
}
std::string angleText(double angleDegrees) {
  return fmt::format("{:.1f}°", angleDegrees);
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

// How far a reflected ray goes that meets the mirror again.
double freeWay(const Optic& optic, const VertexRay& ray, double wanted) {
  const Vector towards = ray.original - ray.eye;
  const double way = freeLength(optic, followRay(optic, {ray.eye, towards})) * glm::length(towards);
  return std::isfinite(way) ? std::min(way, wanted) : wanted;
}

double angleOut(const VertexRay& ray) {
  return degrees(std::acos(std::clamp(glm::dot(ray.normal, ray.reflected), -1.0, 1.0)));
}

// False only where the published formulas are at work.
bool anglesAreEqual(const VertexRay& ray) {
  return std::abs(angleOut(ray) - ray.angleDegrees) < 0.05;
}

void addReflection(Construction& made, const Optic& optic, double depthScale) {
  const VertexRay& ray = made.ray;
  const bool mapped = ray.status == PathStatus::mapped;
  const double reach = mapped ? depthScale * ray.distance : freeWay(optic, ray, depthScale * ray.distance);
  const Point end = mapped ? ray.sculpture : ray.mirror + reach * ray.reflected;
  made.segments.push_back({ray.mirror, ray.original, Kind::virtualRay});
  made.segments.push_back({ray.mirror, end, Kind::reflected});
  made.distances.push_back({0.5 * (ray.mirror + ray.original), fmt::format("d = {:.2f}", ray.distance)});
  if (!mapped) return;
  made.points.push_back({ray.sculpture, "S"});
  made.distances.push_back(
      {0.5 * (ray.mirror + end), fmt::format("{} = {:.2f}", depthScale == 1 ? "d" : "k·d", reach)});
}

void addMirrorPoint(Construction& made, const Optic& optic, double depthScale) {
  const VertexRay& ray = made.ray;
  const Vector back = ray.eye - ray.mirror;
  const double toEye = glm::length(back);
  const double length = normalLength(toEye, depthScale * ray.distance);
  made.segments.push_back({ray.eye, ray.mirror, Kind::incident});
  made.segments.push_back({ray.mirror, ray.mirror + length * ray.normal, Kind::normal});
  made.points.push_back({ray.mirror, "Q"});
  made.points.push_back({ray.mirror + length * ray.normal, "N"});
  if (ray.status == PathStatus::inFrontOfMirror) return;  // the ray ends at P, before it is reflected
  const bool equal = anglesAreEqual(ray);
  const std::string in = "α = " + angleText(ray.angleDegrees);
  const std::string out = equal ? in : "β = " + angleText(angleOut(ray));
  if (toEye > 0) made.arcs.push_back(makeArc(ray.mirror, 0.6 * length, back / toEye, ray.normal, in));
  made.arcs.push_back(makeArc(ray.mirror, 0.6 * length, ray.normal, ray.reflected, out));
  addReflection(made, optic, depthScale);
}

// The one line of sight, as far as something lies on it.
void addSight(Construction& made, double depthScale) {
  const VertexRay& ray = made.ray;
  const bool mapped = ray.status == PathStatus::mapped;
  Point far = ray.original;
  for (const Point& p : {ray.mirror, mapped ? ray.sculpture : ray.original}) {
    if (glm::length(p - ray.eye) > glm::length(far - ray.eye)) far = p;
  }
  made.segments.push_back({ray.eye, far, Kind::incident});
  made.points.push_back({ray.mirror, "Q"});
  made.distances.push_back({0.5 * (ray.mirror + ray.original), fmt::format("d = {:.2f}", ray.distance)});
  if (!mapped) return;
  made.points.push_back({ray.sculpture, "S"});
  made.segments.push_back({ray.mirror, ray.sculpture, Kind::reflected});
  made.distances.push_back(
      {0.5 * (ray.mirror + ray.sculpture), fmt::format("k·d = {:.2f}", depthScale * ray.distance)});
}

void addSightRows(Construction& made, double depthScale) {
  const VertexRay& ray = made.ray;
  made.rows = {{"E  eye", pointText(ray.eye)},
               {"P  original vertex", pointText(ray.original)},
               {"Q  on the canvas", pointText(ray.mirror)},
               {"d = |PQ|", fmt::format("{:.3f}", ray.distance)},
               {"k  depth scale", fmt::format("{:.3f}", depthScale)}};
  if (ray.status == PathStatus::mapped) made.rows.push_back({"S = Q + k (P - Q)", pointText(ray.sculpture)});
}

void addRows(Construction& made, bool hitsMirror, double depthScale) {
  const VertexRay& ray = made.ray;
  const auto add = [&](const char* name, std::string value) {
    made.rows.push_back({name, std::move(value)});
  };
  const auto addLength = [&](const char* name, double length) { add(name, fmt::format("{:.3f}", length)); };
  add("E  eye", pointText(ray.eye));
  add("P  original vertex", pointText(ray.original));
  if (hitsMirror) {
    add("Q  mirror point", pointText(ray.mirror));
    add("N  normal at Q", directionText(ray.normal));
  }
  if (hitsMirror && ray.status != PathStatus::inFrontOfMirror) {
    if (anglesAreEqual(ray)) {
      add("α  both angles", angleText(ray.angleDegrees));
    } else {
      add("α  angle in", angleText(ray.angleDegrees));
      add("β  angle out", angleText(angleOut(ray)));
    }
    add("R  reflected", directionText(ray.reflected));
    addLength("d = |PQ|", ray.distance);
    addLength("k  depth scale", depthScale);
  }
  if (ray.status == PathStatus::mapped) {
    addLength("k·d = |QS|", depthScale * ray.distance);
    add("S = Q + k·d R", pointText(ray.sculpture));
  }
}

}  // namespace

Construction makeConstruction(const Optic& optic, const Point& eye, const Point& original, double depthScale,
                              const Mistakes& mistakes) {
  Construction made;
  made.ray = makeVertexRay(optic, eye, original, depthScale, mistakes);
  const VertexRay& ray = made.ray;
  const bool hitsMirror = lengthSquared(ray.normal) > 0.5 && isFinite(ray.mirror) && isFinite(ray.reflected);
  made.points = {{eye, "E"}, {original, "P"}};
  const bool passes = optic.kind == OpticKind::none;
  if (hitsMirror && passes) {
    addSight(made, depthScale);
    addSightRows(made, depthScale);
  } else {
    if (hitsMirror) {
      addMirrorPoint(made, optic, depthScale);
    } else {
      made.segments.push_back({eye, original, Kind::incident});
    }
    addRows(made, hitsMirror, depthScale);
  }
  if (ray.status != PathStatus::mapped) {
    made.explanation = explainStatus(ray.status) + std::string(".");
    made.explanation[0] = static_cast<char>(std::toupper(made.explanation[0]));
  }
  return made;
}

Construction makeConstruction(const Level& level, const Point& original) {
  return makeConstruction(level.optic, level.camera.eye, original, level.sculpture.depthScale,
                          level.sculpture.mistakes);
}

const std::optional<Construction>& ConstructionStage::at(const Level& level, const Point& original) {
  return memo_.get(
      {level.optic, level.camera.eye, original, level.sculpture.depthScale, level.sculpture.mistakes},
      [&](const Input&) { return std::optional(makeConstruction(level, original)); });
}

}  // namespace anamorph
