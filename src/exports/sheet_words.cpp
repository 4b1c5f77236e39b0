#include "exports/sheet_words.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/language.h"
#include "exports/page_drawing.h"

namespace anamorph {
namespace {

constexpr double nothing = 0.05;  // millimetres

std::string mm(double millimetres) {
  return formatLength(millimetres) + " mm";
}

struct DescribeMirror {
  const Arrangement& arrangement;
  double bottom;  // above the table

  std::string standing(const std::string& how) const {
    return bottom > nothing
               ? how + fmt::format(fmt::runtime(tr(", its lowest point {} above the table.")), mm(bottom))
               : how + ".";
  }

  std::string operator()(const PlaneMirror& plane) const {
    const auto side = [&](int i) { return glm::length(plane.corners[(i + 1) % 4] - plane.corners[i]); };
    const double lean = degrees(std::asin(std::min(1.0, std::abs(planeNormal(plane).z))));
    const std::string size =
        fmt::format(fmt::runtime(tr("Flat, {} x {} mm. ")), formatLength(side(0)), formatLength(side(1)));
    if (lean < 0.05)
      return size + standing(tr("Upright on the blue line, its reflecting side towards the eye"));
    return size + standing(fmt::format(
                      fmt::runtime(tr("Over the blue outline, leaning {:.1f} degrees from upright")), lean));
  }
  std::string operator()(const CylinderMirror& cylinder) const {
    const Vector axis = cylinder.top - cylinder.bottom;
    const double lean = degrees(std::atan2(std::hypot(axis.x, axis.y), std::abs(axis.z)));
    const std::string size = fmt::format(fmt::runtime(tr("A cylinder of {} mm diameter, {} mm high. ")),
                                         formatLength(2 * cylinder.radius), formatLength(glm::length(axis)));
    if (lean < 0.05) return size + standing(tr("Upright on the blue circle"));
    return size +
           standing(fmt::format(fmt::runtime(tr("Over the blue outline, leaning {:.1f} degrees")), lean));
  }
  std::string operator()(const SphereMirror& sphere) const {
    return fmt::format(fmt::runtime(tr("A ball of {} mm diameter. ")), formatLength(2 * sphere.radius)) +
           standing(tr("Its lowest point over the cross; the blue circle is its outline"));
  }
};

std::string sculptureText(const Arrangement& arrangement, double bottom, double top) {
  const std::string place = tr("Over its orange outline, ");
  if (!arrangement.plate) {
    if (bottom <= nothing)
      return place + fmt::format(fmt::runtime(tr("on the table; it is {} high.")), mm(top));
    return place + fmt::format(fmt::runtime(tr("its lowest point {} and its highest {} above the table.")),
                               mm(bottom), mm(top));
  }
  const double face = arrangement.plate->lowerFace - arrangement.table;
  if (face < -nothing) {
    return place + fmt::format(fmt::runtime(tr("the lower face of its base plate {} below the table: raise "
                                               "the mirror and the eye by as much.")),
                               mm(-face));
  }
  return place + tr("its base plate (green) on the table.");
}

}  // namespace

std::vector<SheetStep> makeSheetSteps(const Arrangement& arrangement, double scale) {
  const Box mirror = boundingBox(arrangement.mirrorSurface.positions);
  const Box sculpture = boundingBox(arrangement.sculpture.positions);
  std::vector<SheetStep> steps;
  std::string paper = "Print at 100 % and compare the ruler below with a real one. Lengths are in mm.";
  if (scale > 1) paper = "Smaller than life: set up by the figures, which are true lengths in mm.";
  if (scale < 1) paper = "Larger than life: set up by the figures, which are true lengths in mm.";
  steps.push_back({tr("Paper"), tr(paper), ink::black});
  if (arrangement.hasMirror) {
    const DescribeMirror describe{arrangement, mirror.min.z - arrangement.table};
    steps.push_back({tr("Mirror"), std::visit(describe, arrangement.mirror), ink::blue});
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
  steps.push_back(
      {tr("Eye"),
       fmt::format(fmt::runtime(
                       tr("{} above the table, {} from the cross along the centre line. Look with one eye.")),
                   mm(arrangement.sideOf(arrangement.eye).y), mm(glm::length(eye))),
       ink::black});
  if (!arrangement.onGround) {
    steps.push_back(
        {tr("Table"), tr("Its height is that of the lowest point of what stands on it."), ink::black});
  }
  return steps;
}

}  // namespace anamorph
