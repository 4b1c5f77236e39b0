#include "panels/browser_places.h"

#include <algorithm>
#include <string>
#include <vector>

#include <imgui.h>

#include "base/error.h"
#include "base/folder.h"
#include "base/language.h"
#include "level/level_library.h"
#include "panels/style.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

struct Place {
  std::string name;
  fs::path folder;
};

std::vector<Place> placesOf(const FileBrowser& browser) {
  std::vector<Place> places{{tr("Home"), homeFolder()}};
  if (browser.purpose == FilePurpose::openLevel) {
    try {
      places.push_back({tr("Installed levels"), levelFolder()});
    } catch (const Error&) {
      // There are none.
    }
  }
  for (const fs::path& folder : browser.recentFolders) {
    const bool known =
        std::any_of(places.begin(), places.end(), [&](const Place& place) { return place.folder == folder; });
    if (!known) places.push_back({folder.filename().string(), folder});
  }
  return places;
}

std::optional<fs::path> placeRows(const FileBrowser& browser) {
  std::optional<fs::path> chosen;
  int number = 0;
  for (const Place& place : placesOf(browser)) {
    ImGui::PushID(number++);
    if (ImGui::Selectable(place.name.c_str(), place.folder == browser.folder)) chosen = place.folder;
    tooltip(place.folder.string().c_str());
    ImGui::PopID();
  }
  return chosen;
}

}  // namespace

bool isBelow(const fs::path& folder, const fs::path& root) {
  const fs::path relative = folder.lexically_relative(root);
  return !relative.empty() && *relative.begin() != "..";
}

fs::path usualFolder(const FileBrowser& browser) {
  return browser.recentFolders.empty() ? homeFolder() : browser.recentFolders.front();
}

void rememberFolder(FileBrowser& browser, const fs::path& folder) {
  auto& folders = browser.recentFolders;
  folders.erase(std::remove(folders.begin(), folders.end(), folder), folders.end());
  folders.insert(folders.begin(), folder);
  if (folders.size() > maxRecentFolders) folders.resize(maxRecentFolders);
}

bool placesAreBeside(const Look& look) {
  return ImGui::GetWindowWidth() > 560 * static_cast<float>(look.scale);
}

fs::path proposedExport(const FileBrowser& browser, const fs::path& lastFolder, const fs::path& level,
                        const std::string& name) {
  const std::string stem = level.stem().string();
  return (lastFolder.empty() ? usualFolder(browser) : lastFolder) / (stem.empty() ? name : stem + "-" + name);
}

std::optional<fs::path> drawPathRow(const FileBrowser& browser, const Look& look) {
  const ImGuiStyle& style = ImGui::GetStyle();
  std::optional<fs::path> chosen;
  ImGui::BeginDisabled(!browser.folder.has_relative_path() || browser.folder == browser.root);
  if (ImGui::Button(tr("Up"))) chosen = browser.folder.parent_path();
  ImGui::EndDisabled();
  tooltip("Backspace does the same while nothing is typed.");
  if (!placesAreBeside(look)) {
    ImGui::SameLine();
    ImGui::SetNextItemWidth(7 * ImGui::GetFontSize());
    if (ImGui::BeginCombo("##places", tr("Places"))) {
      if (const auto place = placeRows(browser)) chosen = place;
      ImGui::EndCombo();
    }
  }
  // As many of the last parts as there is room for.
  std::vector<fs::path> parts;
  for (fs::path path = browser.folder; parts.empty() || path != parts.back(); path = path.parent_path()) {
    parts.push_back(path);
  }
  const auto nameOf = [](const fs::path& path) {
    return path.has_filename() ? path.filename().string() : std::string("/");
  };
  ImGui::SameLine();
  float room = ImGui::GetContentRegionAvail().x - 2 * ImGui::GetFontSize();
  std::size_t count = 0;
  while (count < parts.size()) {
    room -= ImGui::CalcTextSize(nameOf(parts[count]).c_str()).x + 2 * style.FramePadding.x +
            style.ItemInnerSpacing.x;
    if (room < 0 && count > 0) break;
    ++count;
  }
  if (count < parts.size()) {
    ImGui::TextDisabled("...");
    ImGui::SameLine(0, style.ItemInnerSpacing.x);
  }
  for (std::size_t i = count; i-- > 0;) {
    ImGui::PushID(static_cast<int>(i));
    const FontScope strong(i == 0 ? look.fonts.strong : nullptr);
    if (ImGui::Button(nameOf(parts[i]).c_str()) && i > 0) chosen = parts[i];
    ImGui::PopID();
    if (i > 0) ImGui::SameLine(0, style.ItemInnerSpacing.x);
  }
  return chosen;
}

std::optional<fs::path> drawPlaces(const FileBrowser& browser, const Look& look, float below) {
  ImGui::BeginChild("places", {170 * static_cast<float>(look.scale), -below});
  const auto chosen = placeRows(browser);
  ImGui::EndChild();
  return chosen;
}

}  // namespace anamorph
