#include "exports/sheet_words.h"

#include <fmt/format.h>

#include "base/language.h"
#include "exports/page_drawing.h"

namespace anamorph {
namespace {

constexpr double nothing = 0.05;  // millimetres

std::string mm(double millimetres) {
  return formatLength(millimetres) + " mm";
}

// A plane that cuts the mirror off, by a height where it is level, else by a point of it and its slope.
std::string describeCut(const Arrangement& arrangement, const HalfSpace& half) {
  const Direction n = glm::normalize(half.normal);
  const double height = half.point.z - arrangement.table;
  constexpr double level = 1 - 1e-9;
  if (n.z > level) return trFormat("What is lower than {} above the table is cut away. ", mm(height));
  if (n.z < -level) return trFormat("What is higher than {} above the table is cut away. ", mm(height));
  const Point2 at = arrangement.planOf(half.point);
  const Point2 way = arrangement.planOf(half.point + n) - at;
  return trFormat(
      "A plane cuts it through the point {} to the right of the cross, {} beyond it and {} high; kept is the "
      "side "
      "towards ({:.2f}, {:.2f}, {:.2f}) in right, beyond and up. ",
      mm(at.x), mm(at.y), mm(height), way.x, way.y, n.z);
}

std::string describeMirror(const Arrangement& arrangement, double bottom) {
  const Shape& mirror = arrangement.mirror;
  ShapeWords words = mirror->words(formatLength);
  if (!mirror.clip().empty()) {
    const Vector size = boxOf(mirror).size();
    words.size += trFormat("Of it a piece of {} x {} x {} is left, along the axes of the level. ", mm(size.x),
                           mm(size.y), mm(size.z));
    for (const HalfSpace& half : mirror.clip()) words.size += describeCut(arrangement, half);
    words.stance = tr("Over the blue outline");
  }
  if (bottom <= nothing) return words.size + words.stance + ".";
  return words.size + words.stance + trFormat(", its lowest point {} above the table.", mm(bottom));
}

std::string sculptureText(const Arrangement& arrangement, double bottom, double top) {
  const std::string place = tr("Over its orange outline, ");
  if (!arrangement.plate) {
    if (bottom <= nothing) return place + trFormat("on the table; it is {} high.", mm(top));
    return place + trFormat("its lowest point {} and its highest {} above the table.", mm(bottom), mm(top));
  }
  const double face = arrangement.plate->lowerFace - arrangement.table;
  if (face < -nothing) {
    return place + trFormat(
                       "the lower face of its base plate {} below the table: raise "
                       "the mirror and the eye by as much.",
                       mm(-face));
  }
  return place + tr("its base plate (green) on the table.");
}

}  // namespace

std::string scaleName(double scale) {
  return scale >= 1 ? shownFormat("1 : {:.6g}", scale) : shownFormat("{:.6g} : 1", 1 / scale);
}

std::vector<SheetStep> makeSheetSteps(const Arrangement& arrangement, double scale) {
  const Box mirror = boundingBox(arrangement.mirrorSurface.positions);
  const Box sculpture = boundingBox(arrangement.sculpture.positions);
  std::vector<SheetStep> steps;
  std::string paper = "Print at 100 % and compare the ruler below with a real one. Lengths are in mm.";
  if (scale > 1) paper = "Smaller than life: set up by the figures, which are true lengths in mm.";
  if (scale < 1) paper = "Larger than life: set up by the figures, which are true lengths in mm.";
  steps.push_back({tr("Paper"), tr(paper), ink::black});
  if (arrangement.hasMirror) {
    steps.push_back({tr("Mirror"), describeMirror(arrangement, mirror.min.z - arrangement.table), ink::blue});
  } else {
    steps.push_back({tr("Canvas"),
                     tr("Only thought of: nothing stands there, the sculpture is seen directly."),
                     ink::blue});
  }
  steps.push_back(
      {tr("Sculpture"),
       sculptureText(arrangement, sculpture.min.z - arrangement.table, sculpture.max.z - arrangement.table),
       ink::vermilion});
  const Point2 eye = arrangement.planOf(arrangement.eye);
  steps.push_back({tr("Eye"),
                   trFormat("{} above the table, {} from the cross along the centre line. Look with one eye.",
                            mm(arrangement.sideOf(arrangement.eye).y), mm(glm::length(eye))),
                   ink::black});
  if (!arrangement.onGround) {
    steps.push_back(
        {tr("Table"), tr("Its height is that of the lowest point of what stands on it."), ink::black});
  }
  return steps;
}

}  // namespace anamorph
