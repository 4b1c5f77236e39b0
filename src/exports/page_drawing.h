// The signs of technical drawings on a page: arrows, dimension lines, wrapped text, a ruler.
#pragma once

#include <string>
#include <vector>

#include "exports/page.h"
#include "math/palette.h"

namespace anamorph {

using Point2 = glm::dvec2;

/// Of the palette, as pens and fills want them.
namespace ink {
constexpr Color black = inkOf(palette::black), grey = inkOf(palette::grey), faint = inkOf(palette::faint),
                white = inkOf(palette::white);
constexpr Color blue = inkOf(palette::blue), lightBlue = inkOf(palette::lightBlue);
constexpr Color vermilion = inkOf(palette::vermilion), lightVermilion = inkOf(palette::lightVermilion);
constexpr Color green = inkOf(palette::green), lightGreen = inkOf(palette::lightGreen);
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
