#include "exports/viewing_sheet.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.h"
#include "base/language.h"
#include "exports/page_file.h"
#include "exports/sheet_plan.h"
#include "exports/sheet_side_view.h"
#include "exports/sheet_words.h"

namespace anamorph {
namespace {

constexpr double margin = 10, headHeight = 17, rulerHeight = 12, gap = 4;
constexpr double wordSize = 2.9, lineStep = 4.1, paragraphStep = 1.4;
constexpr double leastSideView = 46, mostSideView = 84;
constexpr double wordsBeside = 82;  // the width of what is beside the plan

glm::dvec2 sizeOf(Paper paper) {
  switch (paper) {
    case Paper::a3:
      return {297, 420};
    case Paper::letter:
      return {215.9, 279.4};
    case Paper::a4:
      break;
  }
  return {210, 297};
}

// The steps as lines of the width that they have.
struct Words {
  struct Line {
    std::string name, text;  // the name before the first line of each paragraph
    Color color{0};
    double y = 0;  // below the top
  };
  std::vector<Line> lines;
  double indent = 0;
  double height = 0;
};

Words layWords(const std::vector<SheetStep>& steps, double width) {
  Words words;
  for (const SheetStep& step : steps)
    words.indent = std::max(words.indent, textWidth(step.name, wordSize, true) + 3);
  for (const SheetStep& step : steps) {
    std::string name = step.name;
    for (const std::string& text : wrapText(step.text, wordSize, width - words.indent)) {
      words.lines.push_back({name, text, step.color, words.height + wordSize});
      words.height += lineStep;
      name.clear();
    }
    words.height += paragraphStep;
  }
  return words;
}

void drawWords(Page& page, const Words& words, const Point2& corner) {
  for (const Words::Line& line : words.lines) {
    const Point2 at = corner + Point2(0, line.y);
    if (!line.name.empty())
      drawText(page, {at, line.name, wordSize, true, TextAlign::left, false, line.color});
    drawText(page,
             {at + Point2(words.indent, 0), line.text, wordSize, false, TextAlign::left, false, ink::black});
  }
}

struct Layout {
  double width = 0, height = 0;
  Rectangle plan, words, side;
  Words text;
};

// Words and side view below the plan.
Layout layUpright(const glm::dvec2& paper, const std::vector<SheetStep>& steps,
                  double sideView = leastSideView) {
  Layout layout{paper.x, paper.y, {}, {}, {}, {}};
  const double inner = paper.x - 2 * margin, half = 0.5 * (inner - gap);
  layout.text = layWords(steps, half);
  const double block = std::max(layout.text.height, sideView);
  const double bottom = paper.y - margin - rulerHeight - gap;
  layout.words = {{margin, bottom - block}, {margin + half, bottom}};
  layout.side = {{margin + half + gap, bottom - block}, {paper.x - margin, bottom}};
  layout.plan = {{margin, margin + headHeight}, {paper.x - margin, bottom - block - gap}};
  return layout;
}

// Words and side view to the right of the plan.
Layout layAcross(const glm::dvec2& paper, const std::vector<SheetStep>& steps) {
  Layout layout{paper.y, paper.x, {}, {}, {}, {}};
  layout.text = layWords(steps, wordsBeside);
  const double column = layout.width - margin - wordsBeside, top = margin + headHeight + 2;
  const double bottom = layout.height - margin - rulerHeight - gap;
  const double words = top + layout.text.height;
  layout.words = {{column, top}, {layout.width - margin, words}};
  layout.side = {{column, words + gap}, {layout.width - margin, std::min(words + gap + 75, bottom)}};
  layout.plan = {{margin, margin + headHeight}, {column - gap, bottom}};
  return layout;
}

bool fits(const SheetPlan& plan, const Layout& layout, double scale, bool withEye) {
  const Point2 size = sizeOnPage(plan, scale, withEye), room = layout.plan.size();
  return size.x <= room.x && size.y <= room.y;
}

struct Choice {
  bool across = false;
  double scale = 1;
  bool withEye = true;
};

// Of one scale: with the eye's place rather than without, upright rather than across.
std::optional<Choice> chooseAt(const SheetPlan& plan, const Layout& upright, const Layout& across,
                               double scale) {
  for (const bool withEye : {true, false}) {
    if (fits(plan, upright, scale, withEye)) return Choice{false, scale, withEye};
    if (fits(plan, across, scale, withEye)) return Choice{true, scale, withEye};
  }
  return std::nullopt;
}

Choice chooseLargest(const SheetPlan& plan, const Layout& upright, const Layout& across) {
  for (double decade = 1; decade < 1e12; decade *= 10) {
    for (const double step : {1.0, 2.0, 5.0}) {
      if (const auto choice = chooseAt(plan, upright, across, step * decade)) return *choice;
    }
  }
  throw Error(tr("cannot draw the viewing sheet: it would be larger than the world"));
}

// With the words for the scale; what the plan leaves free goes to the side view.
Layout finishLayout(const Arrangement& arrangement, const SheetPlan& plan, const Choice& choice,
                    Paper paper) {
  const std::vector<SheetStep> steps = makeSheetSteps(arrangement, choice.scale);
  if (choice.across) return layAcross(sizeOf(paper), steps);
  const Layout layout = layUpright(sizeOf(paper), steps);
  const double free = layout.plan.size().y - sizeOnPage(plan, choice.scale, choice.withEye).y;
  const double sideView = std::min(layout.side.size().y + std::max(free, 0.0), mostSideView);
  return layUpright(sizeOf(paper), steps, sideView);
}

[[noreturn]] void refuse(const SheetPlan& plan, const Layout& layout, Paper paper, double scale) {
  const Point2 size = sizeOnPage(plan, scale, false), room = layout.plan.size();
  throw Error(
      trFormat("the viewing sheet at {} needs {:.0f} x {:.0f} mm, and {} has {:.0f} x {:.0f} mm for it: "
               "choose a smaller scale, larger paper or fewer millimetres per unit",
               scaleName(scale), std::ceil(size.x), std::ceil(size.y), paperName(paper), std::floor(room.x),
               std::floor(room.y)));
}

void drawHead(Page& page, const Arrangement& arrangement, double scale, Paper paper) {
  constexpr double titleSize = 5.5;
  const double room = page.width - 2 * margin;
  std::string title = tr(arrangement.title.empty() ? "Viewing sheet" : arrangement.title);
  const double width = textWidth(title, titleSize, true);
  const double size = std::max(3.0, titleSize * std::min(1.0, room / width));
  drawText(page, {{margin, margin + 5.5}, title, size, true, TextAlign::left, false, ink::black});
  const std::string kind = trFormat("Viewing sheet, scale {}, seen from above. {:g} mm per scene unit.",
                                    scaleName(scale), arrangement.millimetresPerUnit);
  drawText(page, {{margin, margin + 11}, kind, 3, false, TextAlign::left, false, ink::grey});
  drawText(page, {{page.width - margin, margin + 11},
                  std::string(paperName(paper)) + ", Anamorph",
                  3,
                  false,
                  TextAlign::right,
                  false,
                  ink::grey});
  drawLine(page, {margin, margin + 13.5}, {page.width - margin, margin + 13.5}, Pen{0.2, ink::grey, {}});
}

void drawFoot(Page& page) {
  const double y = page.height - margin - 5;
  drawRuler(page, {margin, y});
  const double x = margin + 107;
  drawText(page, {{x, y - 1}, tr("Check your printer:"), 2.9, true, TextAlign::left, false, ink::black});
  drawText(page,
           {{x, y + 3.1}, tr("this ruler is 100 mm long."), 2.9, false, TextAlign::left, false, ink::black});
}

}  // namespace

const char* paperName(Paper paper) {
  constexpr const char* names[] = {"A4", "A3", "letter"};
  return names[static_cast<int>(paper)];
}

ViewingSheet makeViewingSheet(const LevelResult& finished, const Arrangement& arrangement, Paper paper,
                              std::optional<double> scale) {
  const SheetPlan plan = makeSheetPlan(arrangement);
  // The words for 1 : 1 are the longest, so what fits with them fits.
  const std::vector<SheetStep> steps = makeSheetSteps(arrangement, scale.value_or(1));
  const Layout upright = layUpright(sizeOf(paper), steps), across = layAcross(sizeOf(paper), steps);
  std::optional<Choice> choice;
  if (scale) {
    choice = chooseAt(plan, upright, across, *scale);
    if (!choice) refuse(plan, upright, paper, *scale);
  } else {
    choice = chooseLargest(plan, upright, across);
  }
  const Layout layout = finishLayout(arrangement, plan, *choice, paper);
  ViewingSheet sheet;
  sheet.scale = choice->scale;
  sheet.showsEye = choice->withEye;
  sheet.page.width = layout.width;
  sheet.page.height = layout.height;
  sheet.page.title = tr(arrangement.title) + ": " + tr("Viewing sheet");
  drawHead(sheet.page, arrangement, sheet.scale, paper);
  drawSheetPlan(sheet.page, plan, layout.plan, sheet.scale, sheet.showsEye);
  drawWords(sheet.page, layout.text, layout.words.min);
  drawSideView(sheet.page, makeSideView(finished, arrangement), layout.side);
  drawFoot(sheet.page);
  return sheet;
}

}  // namespace anamorph
