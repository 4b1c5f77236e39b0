#include "panels/long_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <imgui.h>
#include <imgui_internal.h>

#include "base/language.h"
#include "base/text.h"
#include "panels/number_breaks.h"

namespace anamorph {
namespace {

constexpr std::size_t mostLayouts = 16;
constexpr std::size_t mostLineBytes = 4096;  // letters without a width would make one line of all

// The part of a paragraph that goes into one line; at least a character.
std::string_view firstLine(std::string_view paragraph, const ImFont& font, float scale, float width) {
  std::size_t most = std::min(paragraph.size(), mostLineBytes);
  if (most < paragraph.size()) {
    while (most > 1 && (static_cast<unsigned char>(paragraph[most]) & 0xC0) == 0x80) --most;
  }
  const char* begin = paragraph.data();
  const char* end = font.CalcWordWrapPositionA(scale, begin, begin + most, width);
  const auto length = static_cast<std::size_t>(end - begin);
  return paragraph.substr(0, std::max({length, characterLength(paragraph), std::size_t{1}}));
}

}  // namespace

void LongTexts::wrap(Layout& layout) {
  const float scale = layout.size / layout.font->FontSize;
  std::string_view rest = layout.text;
  while (!rest.empty()) {
    const std::string_view paragraph = rest.substr(0, rest.find('\n'));
    const std::string_view line =
        paragraph.empty() ? paragraph : firstLine(paragraph, *layout.font, scale, layout.width);
    ++measured_;
    layout.lines.push_back(line);
    rest.remove_prefix(line.size());
    // Blanks at which a line was broken are not seen.
    while (line.size() < paragraph.size() && !rest.empty() && ImCharIsBlankA(rest.front())) {
      rest.remove_prefix(1);
    }
    if (!rest.empty() && rest.front() == '\n') rest.remove_prefix(1);
  }
}

const LongTexts::Layout& LongTexts::layoutOf(std::string source) {
  const ImFont* font = ImGui::GetFont();
  const float size = ImGui::GetFontSize(), width = std::max(1.0f, ImGui::GetContentRegionAvail().x);
  const auto found = std::find_if(layouts_.begin(), layouts_.end(), [&](const Layout& known) {
    return known.font == font && known.size == size && known.width == width && known.source == source;
  });
  if (found != layouts_.end()) {
    layouts_.splice(layouts_.begin(), layouts_, found);
    return layouts_.front();
  }
  if (layouts_.size() == mostLayouts) layouts_.pop_back();
  std::string text = numbersTogether(source);
  layouts_.push_front({std::move(source), std::move(text), font, size, width, {}});
  wrap(layouts_.front());
  return layouts_.front();
}

void LongTexts::draw(const std::string& english) {
  const Layout& layout = layoutOf(tr(english));
  const std::size_t count = layout.lines.size();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImRect& clip = ImGui::GetCurrentWindow()->ClipRect;
  const auto lineAt = [&](float y) {
    const float line = std::floor((y - at.y) / layout.size);
    return static_cast<std::size_t>(std::clamp(line, 0.0f, static_cast<float>(count)));
  };
  const ImU32 color = ImGui::GetColorU32(ImGuiCol_Text);
  const std::size_t end = std::min(lineAt(clip.Max.y) + 1, count);
  for (std::size_t i = lineAt(clip.Min.y); i < end; ++i) {
    const std::string_view line = layout.lines[i];
    ++drawn_;
    ImGui::GetWindowDrawList()->AddText({at.x, at.y + static_cast<float>(i) * layout.size}, color,
                                        line.data(), line.data() + line.size());
  }
  ImGui::Dummy({layout.width, static_cast<float>(std::max<std::size_t>(count, 1)) * layout.size});
}

}  // namespace anamorph
