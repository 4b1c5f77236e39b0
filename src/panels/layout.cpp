#include "panels/layout.h"

#include <algorithm>
#include <cmath>

namespace anamorph {
namespace {

constexpr float menuHeight = 30, statusHeight = 26;
constexpr float smallestView = 240, smallestPreview = 200, smallestProperties = 160, smallestLesson = 250;
constexpr float foldedLevels = 44;
constexpr float mostWords = 0.4f;   // of the window's height
constexpr float roomyLesson = 640;  // has any step's texts, its figure and what there is to notice

// Side panels give way before they go: each gives its share of what the view lacks.
void squeeze(float& left, float& right, float lacking, float scale) {
  const float spareLeft = std::max(0.0f, left - smallestLeft * scale);
  const float spareRight = std::max(0.0f, right - smallestRight * scale);
  if (lacking <= 0 || lacking > spareLeft + spareRight) return;
  left -= lacking * spareLeft / (spareLeft + spareRight);
  right -= lacking * spareRight / (spareLeft + spareRight);
}

// The preview stays beside the view for an audience, as far as there is room for both.
void presentPreview(const LayoutInput& in, Layout& layout) {
  const float s = in.scale, most = std::max(0.36f * in.width, smallestRight * s);
  const float width = std::floor(std::min(in.rightWidth * s, most));
  if (in.width - width < smallestView * s || in.height < smallestPreview * s) return;
  layout.view.width -= width;
  layout.preview = {layout.view.width, 0, width, in.height};
}

Layout hiddenLayout(const LayoutInput& in) {
  Layout layout;
  layout.view = {0, 0, in.width, in.height};
  if (in.presenting) presentPreview(in, layout);
  return layout;
}

Layout panelLayout(const LayoutInput& in) {
  Layout layout;
  const float s = in.scale;
  const float menu = std::round(menuHeight * s),
              status = in.height > 300 * s ? std::round(statusHeight * s) : 0;
  layout.menu = {0, 0, in.width, std::min(menu, in.height)};
  layout.status = {0, in.height - status, in.width, status};
  const float top = layout.menu.height, height = std::max(0.0f, in.height - top - status);

  float left = in.leftWidth * s;
  float right = (in.previewExpanded ? std::max(in.rightWidth, 0.5f * in.width / s) : in.rightWidth) * s;
  squeeze(left, right, smallestView * s - (in.width - left - right), s);
  // A hair of room for what rounding took.
  if (in.width - left - right < smallestView * s - 0.5f) left = 0;
  if (in.width - right < smallestView * s) right = 0;
  left = std::floor(left);
  right = std::floor(right);
  float list = std::min((46 + levelRowHeight * static_cast<float>(in.levels)) * s, 0.42f * height);
  layout.levelsFolded = in.lessonRuns && !in.levelsOpen && height - list < roomyLesson * s;
  if (layout.levelsFolded) list = foldedLevels * s;
  if (height - list < smallestLesson * s) list = 0;  // the menu Level has the list too
  list = std::floor(list);
  layout.left = {0, top, left, left > 0 ? list : 0};
  layout.lesson = {0, top + list, left, left > 0 ? height - list : 0};
  layout.view = {left, top, in.width - left - right, height};

  float preview = in.previewExpanded ? std::max(in.previewHeight * s, height - 2 * smallestProperties * s)
                                     : in.previewHeight * s;
  preview = std::floor(std::min(preview, height - smallestProperties * s));
  if (preview < smallestPreview * s) preview = 0;
  if (right <= 0) preview = 0;
  layout.properties = {in.width - right, top, right, right > 0 ? height - preview : 0};
  layout.preview = {in.width - right, top + height - preview, right, preview};
  return layout;
}

}  // namespace

Layout makeLayout(const LayoutInput& in) {
  LayoutInput above = in;
  const float words = std::min(std::ceil(in.wordsHeight), std::floor(mostWords * in.height));
  above.height -= words;
  Layout layout = in.panelsHidden ? hiddenLayout(above) : panelLayout(above);
  layout.words = {0, above.height, in.width, words};
  return layout;
}

double fittingScale(double wanted, double width, double height) {
  constexpr double step = 0.125;  // every other scale is another set of letters
  constexpr double leastWidth = smallestLeft + smallestView + smallestRight,
                   leastHeight = menuHeight + statusHeight + smallestProperties + smallestPreview;
  const double largest = step * std::floor(std::min(width / leastWidth, height / leastHeight) / step);
  return std::min(wanted, std::max(largest, 1.0));
}

}  // namespace anamorph
