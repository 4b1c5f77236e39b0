#include "exports/page_drawing.h"

#include <cmath>
#include <sstream>
#include <utility>

#include "base/language.h"

#include "exports/page_file.h"

namespace anamorph {
namespace {

constexpr double headLength = 2.2, headWidth = 1.1;  // of arrows
constexpr double textSize = 2.7, textGap = 0.8;      // of dimensions
const Pen thin{0.18, ink::grey, {}};

Point2 across(const Point2& direction) {
  return {direction.y, -direction.x};
}

void drawHead(Page& page, const Point2& tip, const Point2& direction, const Color& color) {
  const Point2 back = tip - headLength * direction, side = 0.5 * headWidth * across(direction);
  page.items.push_back(PageShape{{{tip, back + side, back - side}}, true, {}, color});
}

}  // namespace

void drawLine(Page& page, const Point2& from, const Point2& to, const Pen& pen) {
  page.items.push_back(PageShape{{{from, to}}, false, pen, {}});
}

void drawArrow(Page& page, const Point2& from, const Point2& to, const Pen& pen) {
  const Point2 direction = glm::normalize(to - from);
  drawLine(page, from, to - 0.5 * headLength * direction, pen);
  drawHead(page, to, direction, pen.color);
}

void drawText(Page& page, PageText text) {
  page.items.push_back(std::move(text));
}

void drawDimension(Page& page, const Point2& from, const Point2& to, const std::string& text) {
  const Point2 direction = glm::normalize(to - from);
  const double length = glm::length(to - from), width = textWidth(text, textSize);
  const bool vertical = std::abs(direction.y) > std::abs(direction.x);
  const bool inside = length > width + 2 * headLength + 2 * textGap;
  Point2 middle = 0.5 * (from + to);
  if (inside) {
    drawLine(page, from + headLength * direction, to - headLength * direction, thin);
    drawHead(page, from, -direction, thin.color);
    drawHead(page, to, direction, thin.color);
  } else {
    const double beyond = headLength + 1;
    drawLine(page, from - beyond * direction, to + (beyond + width + textGap) * direction, thin);
    drawHead(page, from, direction, thin.color);
    drawHead(page, to, -direction, thin.color);
    middle = to + (beyond + 0.5 * width + 0.5 * textGap) * direction;
  }
  const Point2 up = vertical ? Point2(-textGap, 0) : Point2(0, -textGap);
  drawText(page, {middle + up, text, textSize, false, TextAlign::centre, vertical, ink::black});
}

void drawRuler(Page& page, const Point2& at) {
  const Pen pen{0.25, ink::black, {}};
  drawLine(page, at, at + Point2(100, 0), pen);
  for (int half = 0; half <= 20; ++half) {
    const Point2 tick = at + Point2(5 * half, 0);
    drawLine(page, tick, tick - Point2(0, half % 2 == 1 ? 1.5 : half % 20 == 0 ? 4 : 2.5), pen);
    if (half % 2 == 0) {
      drawText(page, {tick + Point2(0, 3.2), std::to_string(5 * half), 2.4, false, TextAlign::centre, false,
                      ink::black});
    }
  }
}

void drawEye(Page& page, const Point2& at, double size) {
  PageShape lid{{{}}, true, Pen{0.3, ink::black, {}}, ink::white};
  constexpr int steps = 16;
  for (int i = 0; i < 2 * steps; ++i) {
    const double x = std::cos(pi * i / steps), arc = 0.48 * (1 - x * x);
    lid.lines[0].push_back(at + 0.5 * size * Point2(x, i < steps ? -arc : arc));
  }
  page.items.push_back(std::move(lid));
  page.items.push_back(PageCircle{at, 0.17 * size, {}, ink::black});
}

std::vector<std::string> wrapText(const std::string& text, double size, double width) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::string longer = lines.empty() ? word : lines.back() + " " + word;
    if (!lines.empty() && textWidth(longer, size) <= width) {
      lines.back() = longer;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

std::string formatLength(double millimetres) {
  return shownFormat("{:.1f}", millimetres);
}

}  // namespace anamorph
