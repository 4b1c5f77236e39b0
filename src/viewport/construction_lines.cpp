#include "viewport/construction_lines.h"

#include "viewport/ray_lines.h"

namespace anamorph {
namespace {

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
      line = makeLine(virtualRayLook);
      break;
    case ConstructionSegment::Kind::normal:
      line = makeLine(normalLook);
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
      line.color = inkOf(palette::normal);
      line.width = 2.2;
      line.inFront = true;
      lines.push_back(line);
    }
  }
  return lines;
}

}  // namespace anamorph
