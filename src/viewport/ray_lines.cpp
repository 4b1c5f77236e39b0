#include "viewport/ray_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "anamorphosis/vertex_ray.h"
#include "pipeline/stages.h"

namespace anamorph {
namespace {

constexpr double thinnest = 0.4, thickest = 2.5;  // times the thickness, for contributions 0 and 1
constexpr double missLength = 1.3;                // of |EP|, for vertex rays that meet no mirror

// A way with bends, of which a prefix has been travelled.
struct Stretch {
  double begin = 0, end = 0;  // along the way

  /// What share of it lies behind somebody who has come so far.
  double fraction(double travelled) const {
    if (travelled >= end) return 1;
    return travelled <= begin || end <= begin ? 0 : (travelled - begin) / (end - begin);
  }
};

double brightest(const Color& color) {
  return std::max({color.x, color.y, color.z});
}

double contributionOf(const RaySegment& segment, const RayTree& tree) {
  const double whole = brightest(tree.color);
  return whole > 0 ? std::clamp(brightest(segment.contribution) / whole, 0.0, 1.0) : 0;
}

bool isShown(const RaySegment& segment, double contribution, const RaySettings& settings) {
  const bool toLight = segment.kind == RayKind::light || segment.kind == RayKind::shadow;
  if (toLight && !settings.lightRays) return false;
  if (segment.kind == RayKind::noHit && settings.hideNoHit) return false;
  return !(settings.hideNegligible && contribution < settings.negligible);
}

Line lineOf(const RaySegment& segment, double contribution, const RaySettings& settings) {
  Line line = rayStyle(segment.kind);
  line.from = segment.from;
  line.to = segment.to;
  line.width = settings.thickness;
  if (settings.thicknessByContribution) line.width *= thinnest + contribution * (thickest - thinnest);
  // Virtual Ray Tracer's formula.
  if (settings.alphaByContribution)
    line.alpha *= std::pow(0.65 * contribution + 0.25, settings.alphaExponent);
  if (settings.colorByContribution) line.color = glm::clamp(glm::sqrt(segment.contribution), 0.0, 1.0);
  return line;
}

// Where each segment begins and ends along the way from the eye.
std::vector<Stretch> stretchesOf(const RayTree& tree) {
  std::vector<Stretch> stretches;
  for (const RaySegment& segment : tree.segments) {
    const double begin = segment.parent >= 0 ? stretches[segment.parent].end : 0;
    stretches.push_back({begin, begin + glm::length(segment.to - segment.from)});
  }
  return stretches;
}

// The way at whose end all that is shown of the tree is complete. What is hidden costs no time.
double wayOf(const RayTree& tree, const std::vector<Stretch>& stretches, const RaySettings& settings) {
  double end = 0;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const RaySegment& segment = tree.segments[i];
    if (isShown(segment, contributionOf(segment, tree), settings)) end = std::max(end, stretches[i].end);
  }
  return end;
}

void addPart(std::vector<Line>& lines, Line line, double fraction) {
  if (!(fraction > 0) || !(lengthSquared(line.to - line.from) > 0)) return;
  if (fraction < 1) line.to = line.from + fraction * (line.to - line.from);
  lines.push_back(line);
}

template <typename Visit>
void visitTrees(const std::vector<RayTree>& trees, std::optional<std::size_t> only, const Visit& visit) {
  for (std::size_t i = 0; i < trees.size(); ++i) {
    if (!only || *only == i) visit(trees[i]);
  }
}

std::vector<VertexRay> sampleVertexRays(const LevelScene& level, const Mesh& original,
                                        const RaySettings& settings) {
  std::vector<VertexRay> rays;
  const VertexMap map = makeVertexMap(level);
  const std::size_t count = original.positions.size();
  const std::size_t wanted = std::min<std::size_t>(std::max(settings.vertexCount, 0), count);
  for (std::size_t i = 0; i < wanted; ++i) {
    // At the middle of each of `wanted` equal parts of the list.
    const std::size_t vertex = (2 * i + 1) * count / (2 * wanted);
    rays.push_back(makeVertexRay(map, original.positions[vertex]));
  }
  return rays;
}

// The straight pieces of a vertex ray, or the one that it has when it is not mapped.
std::vector<Line> linesOf(const VertexRay& ray, const RaySettings& settings) {
  if (!ray.mapped() && settings.hideNoHit) return {};
  std::vector<Line> lines;
  const auto add = [&](RayKind kind, const Point& from, const Point& to) {
    Line line = rayStyle(kind);
    line.from = from;
    line.to = to;
    line.width = settings.thickness;
    lines.push_back(line);
  };
  if (!ray.mapped()) {
    const double reach = ray.meets() ? 1 : missLength;
    add(RayKind::noHit, ray.eye, ray.eye + reach * (ray.original - ray.eye));
    return lines;
  }
  if (!ray.bends) {
    add(RayKind::camera, ray.eye, ray.sculpture);
    return lines;
  }
  add(RayKind::camera, ray.eye, ray.legs.front().start);
  for (std::size_t i = 0; i < ray.legs.size(); ++i) {
    const bool last = i + 1 == ray.legs.size();
    add(RayKind::reflected, ray.legs[i].start, last ? ray.sculpture : ray.legs[i + 1].start);
  }
  return lines;
}

double lengthOf(const std::vector<Line>& lines) {
  double length = 0;
  for (const Line& line : lines) length += glm::length(line.to - line.from);
  return length;
}

double secondsFor(double length, const RaySettings& settings) {
  return settings.animate && settings.speed > 0 ? length / settings.speed : 0;
}

double travelledIn(double seconds, const RaySettings& settings) {
  return settings.animate ? seconds * settings.speed : std::numeric_limits<double>::infinity();
}

// Lengths along the way to seconds, in order; those that no eye could tell apart count once.
std::vector<double> stopsAt(std::vector<double> ways, const RaySettings& settings) {
  ways.push_back(0);
  std::sort(ways.begin(), ways.end());
  const double gap = 1e-3 * ways.back();
  std::vector<double> stops;
  for (const double way : ways) {
    if (stops.empty() || way - stops.back() > gap) stops.push_back(way);
  }
  for (double& stop : stops) stop = secondsFor(stop, settings);
  return stops;
}

}  // namespace

Line rayStyle(RayKind kind) {
  return makeLine(lookOf(kind).line);
}

std::vector<Line> makeTreeLines(const std::vector<RayTree>& trees, const RaySettings& settings,
                                std::optional<std::size_t> only, double seconds) {
  std::vector<Line> lines;
  double travelled = travelledIn(seconds, settings);
  visitTrees(trees, only, [&](const RayTree& tree) {
    const std::vector<Stretch> stretches = stretchesOf(tree);
    for (std::size_t i = 0; i < tree.segments.size(); ++i) {
      const double contribution = contributionOf(tree.segments[i], tree);
      if (!isShown(tree.segments[i], contribution, settings)) continue;
      addPart(lines, lineOf(tree.segments[i], contribution, settings), stretches[i].fraction(travelled));
    }
    if (settings.animate && settings.sequential) travelled -= wayOf(tree, stretches, settings);
  });
  return lines;
}

std::vector<Line> makeVertexRayLines(const LevelScene& level, const Mesh& original, const RaySettings& settings,
                                     double seconds) {
  std::vector<Line> lines;
  double travelled = travelledIn(seconds, settings);
  for (const VertexRay& ray : sampleVertexRays(level, original, settings)) {
    double begin = 0;
    for (const Line& leg : linesOf(ray, settings)) {
      const double end = begin + glm::length(leg.to - leg.from);
      addPart(lines, leg, Stretch{begin, end}.fraction(travelled));
      begin = end;
    }
    if (settings.animate && settings.sequential) travelled -= begin;
  }
  return lines;
}

double treeAnimationSeconds(const std::vector<RayTree>& trees, const RaySettings& settings,
                            std::optional<std::size_t> only) {
  double most = 0, sum = 0;
  visitTrees(trees, only, [&](const RayTree& tree) {
    const double length = wayOf(tree, stretchesOf(tree), settings);
    most = std::max(most, length);
    sum += length;
  });
  return secondsFor(settings.sequential ? sum : most, settings);
}

double vertexRayAnimationSeconds(const LevelScene& level, const Mesh& original, const RaySettings& settings) {
  double most = 0, sum = 0;
  for (const VertexRay& ray : sampleVertexRays(level, original, settings)) {
    const double length = lengthOf(linesOf(ray, settings));
    most = std::max(most, length);
    sum += length;
  }
  return secondsFor(settings.sequential ? sum : most, settings);
}

std::vector<double> treeAnimationStops(const std::vector<RayTree>& trees, const RaySettings& settings,
                                       std::optional<std::size_t> only) {
  std::vector<double> ways;
  double begin = 0;
  visitTrees(trees, only, [&](const RayTree& tree) {
    const std::vector<Stretch> stretches = stretchesOf(tree);
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const RaySegment& segment = tree.segments[i];
      if (isShown(segment, contributionOf(segment, tree), settings)) ways.push_back(begin + stretches[i].end);
    }
    if (settings.sequential) begin += wayOf(tree, stretches, settings);
  });
  return stopsAt(std::move(ways), settings);
}

std::vector<double> vertexRayAnimationStops(const LevelScene& level, const Mesh& original,
                                            const RaySettings& settings) {
  std::vector<double> ways;
  double begin = 0;
  for (const VertexRay& ray : sampleVertexRays(level, original, settings)) {
    double end = begin;
    for (const Line& leg : linesOf(ray, settings)) {
      end += glm::length(leg.to - leg.from);
      ways.push_back(end);
    }
    if (settings.sequential) begin = end;
  }
  return stopsAt(std::move(ways), settings);
}

}  // namespace anamorph
