#include "panels/export_window.h"

#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>

#include "base/language.h"
#include "panels/browser_places.h"
#include "panels/export_entries.h"
#include "panels/file_browser.h"
#include "panels/keys.h"
#include "panels/style.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

const ExportEntry& entryOf(const ExportDialog& dialog) {
  return exportEntries()[static_cast<std::size_t>(dialog.kind)];
}

void scaleRow(ExportDialog& dialog) {
  numberRow("mm per unit", dialog.request.millimetresPerUnit, {limits::millimetresPerUnit.panel, 0.1, "%.3g"},
            "How many millimetres a scene unit becomes.");
}

void plateRows(ExportDialog& dialog) {
  bool plate = dialog.request.basePlate.has_value();
  if (checkRow("Base plate", plate, "A slab that it stands on, with posts up to it where it floats.")) {
    dialog.request.basePlate = plate ? std::optional(BasePlateSettings{}) : std::nullopt;
  }
  if (!dialog.request.basePlate) return;
  numberRow("Thickness", dialog.request.basePlate->thickness, {limits::plateThickness.panel, 0.1, "%.1f mm"});
  numberRow("Margin", dialog.request.basePlate->margin, {limits::plateMargin.panel, 0.1, "%.1f mm"},
            "Around the sculpture.");
}

void pageRows(ExportDialog& dialog) {
  int paper = static_cast<int>(dialog.request.paper);
  if (choiceRow("Paper", paper, {"A4", "A3", "Letter"})) dialog.request.paper = static_cast<Paper>(paper);
  bool fits = !dialog.request.sheetScale;
  if (checkRow("As large as fits", fits, "1 : 1 where the paper is large enough.")) {
    dialog.request.sheetScale = fits ? std::nullopt : std::optional(1.0);
  }
  if (dialog.request.sheetScale) {
    numberRow("Scale 1 :", *dialog.request.sheetScale, {limits::sheetScale.panel, 0.1, "%.3g"});
  }
}

void rayRows(ExportDialog& dialog) {
  int source = dialog.request.vertexRays ? 1 : 0;
  if (choiceRow("Which", source, {"Through the pixels", "Through vertices"})) {
    dialog.request.vertexRays = source == 1 ? std::optional(200) : std::nullopt;
  }
  if (dialog.request.vertexRays)
    integerRow("How many", *dialog.request.vertexRays, limits::exportedVertexRays.panel);
}

void pictureRow(ExportDialog& dialog) {
  int picture = static_cast<int>(dialog.request.picture);
  if (choiceRow("Picture", picture, {"Reflection", "Original", "Difference"})) {
    dialog.request.picture = static_cast<PictureKind>(picture);
  }
}

void optionRows(ExportOption option, ExportDialog& dialog) {
  switch (option) {
    case ExportOption::millimetres:
      return scaleRow(dialog);
    case ExportOption::basePlate:
      return plateRows(dialog);
    case ExportOption::page:
      return pageRows(dialog);
    case ExportOption::raysOf:
      return rayRows(dialog);
    case ExportOption::picture:
      return pictureRow(dialog);
    case ExportOption::pictureSize:
      integerRow("Longer side", dialog.request.size, limits::exportedSize.panel, "In pixels.");
      return;
    case ExportOption::comparedSize:
      integerRow("Longer side", dialog.request.size, limits::comparedSize.panel,
                 "Of the pictures that are compared, in pixels.");
      return;
    case ExportOption::printCheck:  // its button is beside that which saves
      numberRow("Smallest width", dialog.request.smallestWidth,
                {limits::smallestWidth.panel, 0.01, "%.2f mm"},
                "Of the thinnest wall that the printer makes: two lines of a 0.4 mm nozzle are 0.8 mm.");
      return;
  }
}

void screenshotRows(ExportDialog& dialog) {
  integerRow("Times as large", dialog.shot.factor, limits::shotFactor, "As the window is.");
  checkRow("With the panels", dialog.shot.panels);
  checkRow("Transparent", dialog.shot.transparent, "No background and no ground.");
}

void kindRows(ExportDialog& dialog) {
  const ExportFormat* format = entryOf(dialog).format;
  if (!format) return screenshotRows(dialog);
  for (const ExportOption option : format->options) optionRows(option, dialog);
}

// The browser's choice: the file is written at once.
void takeChoice(ExportDialog& dialog, FileBrowser& browser, UiRequests& requests) {
  const ExportEntry& entry = entryOf(dialog);
  const auto path = awaitChosenFile(browser, entry.purpose, dialog.choosing);
  if (!path) return;
  dialog.folder = path->parent_path();
  dialog.say("");
  if (!entry.format) {
    dialog.shot.path = *path;
    requests.shot = dialog.shot;
    return;
  }
  dialog.request.kind = entry.format->kind;
  dialog.request.path = *path;
  requests.startExport = true;
}

void drawButtons(ExportDialog& dialog, const std::filesystem::path& level, FileBrowser& browser,
                 UiRequests& requests, const Look& look) {
  if (dialog.running) {
    ImGui::ProgressBar(static_cast<float>(dialog.fraction), {-90 * static_cast<float>(look.scale), 0});
    ImGui::SameLine();
    if (ImGui::Button(tr("Cancel"), {-FLT_MIN, 0})) requests.cancelExport = requests.cancelShot = true;
    return;
  }
  const ExportEntry& entry = entryOf(dialog);
  if (entry.format && entry.format->has(ExportOption::printCheck) &&
      wideButton("Check for printing", "Closed, the right side out, no crossings, walls thick enough.")) {
    requests.checkPrint = true;
  }
  if (wideButton("Save as...", "The key Enter does the same.") || std::exchange(dialog.saveAsked, false)) {
    dialog.choosing = true;
    browseFiles(browser, entry.purpose, proposedExport(browser, dialog.folder, level, entry.fileName));
  }
}

void drawOutcome(const ExportDialog& dialog, const Look& look) {
  if (dialog.message.empty()) return;
  ImGui::Separator();
  paragraph(capitalised(dialog.message));
  for (const std::string& line : dialog.lines) quietText(look, capitalised(line).c_str());
  for (const auto& [name, value] : dialog.rows) {
    quietText(look, name.c_str());
    ImGui::SameLine(0.3f * ImGui::GetWindowContentRegionMax().x);
    quietText(look, value.c_str());
  }
}

}  // namespace

bool exportKey(ExportDialog& dialog, int key) {
  if (dialog.running) return false;
  if (key == keys::enter || key == keys::padEnter) {
    dialog.saveAsked = true;
  } else if (key == keys::left || key == keys::right) {
    const int count = static_cast<int>(exportEntries().size());
    dialog.kind = (dialog.kind + (key == keys::right ? 1 : count - 1)) % count;
  } else {
    return false;
  }
  return true;
}

void drawExportWindow(ExportDialog& dialog, const std::filesystem::path& level, FileBrowser& browser,
                      UiRequests& requests, const Look& look) {
  takeChoice(dialog, browser, requests);
  if (!dialog.open) return;
  const float s = static_cast<float>(look.scale);
  if (beginToolWindow(look, "Export", "###export", dialog.open, 460, 470)) {
    ImGui::BeginDisabled(dialog.running);
    std::vector<const char*> names;
    for (const ExportEntry& entry : exportEntries()) names.push_back(entry.name);
    if (segmentedControl("kinds", dialog.kind, names, 3)) {
      dialog.say("");
    }
    quietText(look, entryOf(dialog).help);
    ImGui::Dummy({0, 4 * s});
    const auto checked = [&] {
      const ExportRequest& request = dialog.request;
      return std::tuple(request.millimetresPerUnit, request.smallestWidth, request.basePlate);
    };
    const auto before = checked();
    ImGui::PushID(dialog.kind);
    kindRows(dialog);
    ImGui::PopID();
    if (before != checked()) {
      dialog.say("");  // it was about something else
    }
    ImGui::EndDisabled();
    ImGui::Dummy({0, 4 * s});
    drawButtons(dialog, level, browser, requests, look);
    drawOutcome(dialog, look);
  }
  ImGui::End();
}

}  // namespace anamorph
