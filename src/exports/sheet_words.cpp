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

std::string describeMirror(const Shape& mirror, double bottom) {
  ShapeWords words = mirror->words(formatLength);
  if (!mirror.clip().empty()) {
    const Vector size = boxOf(mirror).size();
    words.size += trFormat("Of it a piece of {} x {} x {} is left, cut off by planes. ", mm(size.x),
                           mm(size.y), mm(size.z));
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
    steps.push_back(
        {tr("Mirror"), describeMirror(arrangement.mirror, mirror.min.z - arrangement.table), ink::blue});
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
