#include "panels/tour.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <imgui.h>

#include "base/language.h"
#include "panels/style.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

struct Card {
  Rect Layout::*part;  // null: the tabs of the properties
  const char* title;
  const char* text;
};
constexpr std::array<Card, tourCards> cards{
    Card{&Layout::view, "The scene",
         "A sculpture, a mirror, and the RT camera that looks into it (RT = ray tracing). Drag to turn, use "
         "the "
         "wheel to come nearer, click a thing to select it and drag its arrows."},
    Card{&Layout::lesson, "The lesson",
         "One step at a time: why, what to do, and what to notice. Where? points at what is meant, Do it "
         "makes "
         "the move for you."},
    Card{nullptr, "The tabs",
         "One for each thing of the scene, one for the rays, one for the view. Lessons name them: in the tab "
         "Eye, in the tab Sculpture."},
    Card{&Layout::properties, "The properties",
         "The numbers of the tab that is open. Drag one, or double click to type."},
    Card{&Layout::preview, "What the eye sees",
         "The RT camera's picture, traced ray by ray, and how well it matches the original."},
    Card{&Layout::left, "The levels",
         "Begin with the first. F1 shows all keys, and Ctrl+Z takes back everything."},
};

// In a window of its own, below the card and above the panels.
void dimAround(const Rect& r, const ImVec2& display, const Look& look) {
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(display);
  ImGui::Begin("##tour-dim", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoInputs |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->PushClipRectFullScreen();
  const ImU32 dim = IM_COL32(0, 0, 0, 120);
  list->AddRectFilled({0, 0}, {display.x, r.y}, dim);
  list->AddRectFilled({0, r.y + r.height}, display, dim);
  list->AddRectFilled({0, r.y}, {r.x, r.y + r.height}, dim);
  list->AddRectFilled({r.x + r.width, r.y}, {display.x, r.y + r.height}, dim);
  const float s = static_cast<float>(look.scale);
  list->AddRect({r.x + s, r.y + s}, {r.x + r.width - s, r.y + r.height - s}, ink::of(palette::pointedAt),
                3 * s, 0, 3 * s);
  list->PopClipRect();
  ImGui::End();
}

void nextCard(Tour& tour, Preferences& preferences) {
  if (++tour.card >= tourCards) endTour(tour, preferences);
}

void drawCard(Tour& tour, Preferences& preferences, const Look& look) {
  const Card& card = cards[static_cast<std::size_t>(tour.card)];
  {
    const FontScope title(look.fonts.title);
    ImGui::TextUnformatted(tr(card.title));
  }
  paragraph(tr(card.text));
  quietText(look, fmt::format("{} / {}", tour.card + 1, tourCards).c_str());
  const bool last = tour.card + 1 == tourCards;
  if (ImGui::Button(tr(last ? "Begin" : "Next"))) return nextCard(tour, preferences);
  if (last) return;
  ImGui::SameLine();
  if (ImGui::Button(tr("Skip the tour"))) endTour(tour, preferences);
}

}  // namespace

void startTour(Tour& tour) {
  tour.card = 0;
}

void endTour(Tour& tour, Preferences& preferences) {
  tour.card = -1;
  preferences.tourSeen = true;
}

void drawTour(Tour& tour, Preferences& preferences, const Layout& layout, const Rect& tabs,
              const Look& look) {
  if (!tour.goesOn()) return;
  if (tour.card >= tourCards) return endTour(tour, preferences);
  const Rect Layout::*const part = cards[static_cast<std::size_t>(tour.card)].part;
  const Rect rect = part ? layout.*part : layout.properties.empty() ? Rect() : tabs;
  if (rect.empty()) return nextCard(tour, preferences);  // a small window has not got it
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float s = static_cast<float>(look.scale);
  dimAround(rect, display, look);
  // In the view: beside all parts, and in none but it; its buttons stay where they are.
  const Rect& view = layout.view;
  ImGui::SetNextWindowPos({view.x + view.width / 2, view.y + 0.85f * view.height}, ImGuiCond_Always,
                          {0.5f, 1});
  ImGui::SetNextWindowSize({std::min(340 * s, display.x), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 8 * s);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {16 * s, 12 * s});
  ImGui::Begin("##tour", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoNav);
  drawCard(tour, preferences, look);
  ImGui::End();
  ImGui::PopStyleVar(2);
}

}  // namespace anamorph
