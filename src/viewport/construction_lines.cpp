#include "viewport/construction_lines.h"

#include "viewport/ray_lines.h"

namespace anamorph {
namespace {

constexpr Color green{0, 0.62, 0.45};  // Okabe and Ito's 009E73
constexpr Color pale{0.75, 0.8, 0.85};
constexpr double width = 3.2;

Line styleOf(ConstructionSegment::Kind kind) {
  Line line;
  switch (kind) {
    case ConstructionSegment::Kind::incident:
      line = rayStyle(RayKind::camera);
      break;
    case ConstructionSegment::Kind::reflected:
      line = rayStyle(RayKind::reflected);
      break;
    case ConstructionSegment::Kind::virtualRay:
      line.color = pale;
      line.style = LineStyle::dotted;
      break;
    case ConstructionSegment::Kind::normal:
      line.color = green;
      line.style = LineStyle::dotted;
      line.arrow = true;
      break;
  }
  line.width = width;
  line.inFront = true;
  return line;
}

}  // namespace

std::vector<Line> makeConstructionLines(const Construction& construction) {
  std::vector<Line> lines;
  for (const ConstructionSegment& segment : construction.segments) {
    Line line = styleOf(segment.kind);
    line.from = segment.from;
    line.to = segment.to;
    lines.push_back(line);
  }
  for (const ConstructionArc& arc : construction.arcs) {
    for (std::size_t i = 1; i < arc.points.size(); ++i) {
      Line line;
      line.from = arc.points[i - 1];
      line.to = arc.points[i];
      line.color = green;
      line.width = 2.2;
      line.inFront = true;
      lines.push_back(line);
    }
  }
  return lines;
}

}  // namespace anamorph
