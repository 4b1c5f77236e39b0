// The signs of technical drawings on a page: arrows, dimension lines, wrapped text, a ruler.
#pragma once

#include <string>
#include <vector>

#include "exports/page.h"

namespace anamorph {

using Point2 = glm::dvec2;

/// Okabe and Ito's, as in the window.
namespace ink {
inline const Color black{0}, grey{0.42}, faint{0.75};
inline const Color blue = Color(0, 114, 178) / 255.0, lightBlue{0.89, 0.945, 0.975};
inline const Color vermilion = Color(213, 94, 0) / 255.0, lightVermilion{0.99, 0.91, 0.84};
inline const Color green = Color(0, 158, 115) / 255.0;
}  // namespace ink

/// Everything that is drawn goes to the end of the page.
void drawLine(Page& page, const Point2& from, const Point2& to, const Pen& pen);
void drawArrow(Page& page, const Point2& from, const Point2& to, const Pen& pen);
void drawText(Page& page, PageText text);

/// A line with arrow heads at both ends and its text, for lengths along the page's sides. Where there is too
/// little room between the ends the text stands beyond `to`, and arrows point from outside.
///
///     |<---- 30.0 ---->|          ->||<- 3.0
void drawDimension(Page& page, const Point2& from, const Point2& to, const std::string& text);

/// A ruler of 100 mm with centimetres and half centimetres, its left end at `at`.
void drawRuler(Page& page, const Point2& at);

/// An eye, `size` wide, in the middle of which `at` is.
void drawEye(Page& page, const Point2& at, double size);

/// The words of a text in lines that are no wider than `width` where words allow.
std::vector<std::string> wrapText(const std::string& text, double size, double width);

/// 12.3 without the unit; 0.0 for what is nearly nothing.
std::string formatLength(double millimetres);

}  // namespace anamorph
