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

constexpr double cardSeconds = 4;

struct Card {
  Rect Layout::*part;
  const char* title;
  const char* text;
};
constexpr std::array cards{
    Card{&Layout::view, "The scene",
         "A sculpture, a mirror, and the RT camera that looks into it. Drag to turn, use the wheel to come "
         "nearer, "
         "click a thing to select it and drag its arrows."},
    Card{&Layout::lesson, "The lesson",
         "One step at a time: why, what to do, and what to notice. Show me makes the move for you."},
    Card{&Layout::properties, "The properties",
         "The numbers of what is selected. Drag one, or double click to type."},
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
  tour.seconds = 0;
  if (++tour.card >= static_cast<int>(cards.size())) endTour(tour, preferences);
}

void drawCard(Tour& tour, Preferences& preferences, const Look& look) {
  const Card& card = cards[static_cast<std::size_t>(tour.card)];
  {
    const FontScope title(look.fonts.title);
    ImGui::TextUnformatted(tr(card.title));
  }
  paragraph(tr(card.text));
  ImGui::ProgressBar(static_cast<float>(std::min(1.0, tour.seconds / cardSeconds)),
                     {-FLT_MIN, 3 * static_cast<float>(look.scale)}, "");
  const bool last = tour.card + 1 == static_cast<int>(cards.size());
  if (ImGui::Button(tr(last ? "Begin" : "Next"))) return nextCard(tour, preferences);
  if (last) return;
  ImGui::SameLine();
  if (ImGui::Button(tr("Skip the tour"))) endTour(tour, preferences);
}

}  // namespace

void startTour(Tour& tour) {
  tour = {0, 0};
}

void endTour(Tour& tour, Preferences& preferences) {
  tour.card = -1;
  preferences.tourSeen = true;
}

void drawTour(Tour& tour, Preferences& preferences, const Layout& layout, const Look& look) {
  if (!tour.goesOn()) return;
  const auto index = static_cast<std::size_t>(tour.card);
  if (index >= cards.size()) return endTour(tour, preferences);
  const Rect rect = layout.*cards[index].part;
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
  const bool reading = ImGui::IsWindowHovered();
  drawCard(tour, preferences, look);
  ImGui::End();
  ImGui::PopStyleVar(2);
  if (!tour.goesOn() || reading) return;
  tour.seconds += static_cast<double>(ImGui::GetIO().DeltaTime);
  if (tour.seconds >= cardSeconds) nextCard(tour, preferences);
}

}  // namespace anamorph
