#include "panels/export_window.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>

#include "base/language.h"
#include "panels/browser_places.h"
#include "panels/file_browser.h"
#include "panels/keys.h"
#include "panels/style.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

constexpr int screenshotKind = exportKindCount - 1;

bool isScreenshot(const ExportDialog& dialog) {
  return dialog.kind == screenshotKind;
}

void scaleRow(ExportDialog& dialog) {
  numberRow("mm per unit", dialog.request.millimetresPerUnit, {0.001, 1000, 0.1, "%.3g"},
            "How many millimetres a scene unit becomes.");
}

void plateRows(ExportDialog& dialog) {
  bool plate = dialog.request.basePlate.has_value();
  if (checkRow("Base plate", plate, "A slab that it stands on, with posts up to it where it floats.")) {
    dialog.request.basePlate = plate ? std::optional(BasePlateSettings{}) : std::nullopt;
  }
  if (!dialog.request.basePlate) return;
  numberRow("Thickness", dialog.request.basePlate->thickness, {0.2, 50, 0.1, "%.1f mm"});
  numberRow("Margin", dialog.request.basePlate->margin, {0, 100, 0.1, "%.1f mm"}, "Around the sculpture.");
}

void sheetRows(ExportDialog& dialog) {
  int paper = static_cast<int>(dialog.request.paper);
  if (choiceRow("Paper", paper, {"A4", "A3", "Letter"})) dialog.request.paper = static_cast<Paper>(paper);
  bool fits = !dialog.request.sheetScale;
  if (checkRow("As large as fits", fits, "1 : 1 where the paper is large enough.")) {
    dialog.request.sheetScale = fits ? std::nullopt : std::optional(1.0);
  }
  if (dialog.request.sheetScale) {
    numberRow("Scale 1 :", *dialog.request.sheetScale, {0.1, 1000, 0.1, "%.3g"});
  }
}

void rayRows(ExportDialog& dialog) {
  int source = dialog.request.vertexRays ? 1 : 0;
  if (choiceRow("Which", source, {"Through the pixels", "Through vertices"})) {
    dialog.request.vertexRays = source == 1 ? std::optional(200) : std::nullopt;
  }
  if (dialog.request.vertexRays) integerRow("How many", *dialog.request.vertexRays, 1, 10000);
}

void pictureRows(ExportDialog& dialog) {
  int picture = static_cast<int>(dialog.request.picture);
  if (choiceRow("Picture", picture, {"Reflection", "Original", "Difference"})) {
    dialog.request.picture = static_cast<PictureKind>(picture);
  }
  integerRow("Longer side", dialog.request.size, 16, 8192, "In pixels.");
}

void screenshotRows(ExportDialog& dialog) {
  integerRow("Times as large", dialog.shot.factor, 1, 4, "As the window is.");
  checkRow("With the panels", dialog.shot.panels);
  checkRow("Transparent", dialog.shot.transparent, "No background and no ground.");
}

void kindRows(ExportDialog& dialog) {
  if (isScreenshot(dialog)) return screenshotRows(dialog);
  switch (static_cast<ExportKind>(dialog.kind)) {
    case ExportKind::sculpture:
      scaleRow(dialog);
      return plateRows(dialog);
    case ExportKind::viewingSheet:
      scaleRow(dialog);
      plateRows(dialog);
      return sheetRows(dialog);
    case ExportKind::rays:
      scaleRow(dialog);
      return rayRows(dialog);
    case ExportKind::matchReport:
      integerRow("Longer side", dialog.request.size, 16, 4096,
                 "Of the pictures that are compared, in pixels.");
      return;
    case ExportKind::picture:
      return pictureRows(dialog);
  }
}

const char* explanation(const ExportDialog& dialog) {
  if (isScreenshot(dialog)) return "The window as it is, as PNG.";
  switch (static_cast<ExportKind>(dialog.kind)) {
    case ExportKind::sculpture:
      return "For a 3D printer: OBJ, STL or PLY, in millimetres.";
    case ExportKind::viewingSheet:
      return "One page, PDF or SVG: put mirror and sculpture on their outlines, and your eye where it says.";
    case ExportKind::rays:
      return "Lines for a modelling program, as OBJ.";
    case ExportKind::matchReport:
      return "How well the reflection agrees: a page with pictures (HTML), or figures (JSON).";
    case ExportKind::picture:
      return "What the RT camera sees, as PNG.";
  }
  return "";
}

FilePurpose purposeOf(const ExportDialog& dialog) {
  if (isScreenshot(dialog)) return FilePurpose::saveImage;
  constexpr FilePurpose purposes[] = {FilePurpose::saveMesh, FilePurpose::saveSheet, FilePurpose::saveLines,
                                      FilePurpose::saveReport, FilePurpose::saveImage};
  return purposes[dialog.kind];
}

const char* nameOf(const ExportDialog& dialog) {
  constexpr const char* names[] = {"sculpture.stl", "sheet.pdf",   "rays.obj",
                                   "match.html",    "picture.png", "window.png"};
  return names[dialog.kind];
}

// The browser's choice: the file is written at once.
void takeChoice(ExportDialog& dialog, FileBrowser& browser, UiRequests& requests) {
  const auto path = awaitChosenFile(browser, purposeOf(dialog), dialog.choosing);
  if (!path) return;
  dialog.folder = path->parent_path();
  dialog.say("");
  if (isScreenshot(dialog)) {
    dialog.shot.path = *path;
    requests.shot = dialog.shot;
    return;
  }
  dialog.request.kind = static_cast<ExportKind>(dialog.kind);
  dialog.request.path = *path;
  requests.startExport = true;
}

void drawButtons(ExportDialog& dialog, const std::filesystem::path& level, FileBrowser& browser,
                 UiRequests& requests, const Look& look) {
  if (dialog.running) {
    ImGui::ProgressBar(static_cast<float>(dialog.fraction), {-90 * static_cast<float>(look.scale), 0});
    ImGui::SameLine();
    if (ImGui::Button(tr("Cancel"), {-FLT_MIN, 0})) requests.cancelExport = true;
    return;
  }
  if (dialog.kind == static_cast<int>(ExportKind::sculpture) &&
      wideButton("Check for printing", "Closed, the right side out, no crossings, walls thick enough.")) {
    requests.checkPrint = true;
  }
  if (wideButton("Save as...", "The key Enter does the same.") || std::exchange(dialog.saveAsked, false)) {
    dialog.choosing = true;
    browseFiles(browser, purposeOf(dialog), proposedExport(browser, dialog.folder, level, nameOf(dialog)));
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
    dialog.kind = (dialog.kind + (key == keys::right ? 1 : exportKindCount - 1)) % exportKindCount;
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
    if (segmentedControl("kinds", dialog.kind,
                         {"Sculpture", "Viewing sheet", "Rays", "Match report", "Picture", "Screenshot"},
                         3)) {
      dialog.say("");
    }
    quietText(look, explanation(dialog));
    ImGui::Dummy({0, 4 * s});
    const auto before = std::pair(dialog.request.millimetresPerUnit, dialog.request.basePlate);
    ImGui::PushID(dialog.kind);
    kindRows(dialog);
    ImGui::PopID();
    if (before != std::pair(dialog.request.millimetresPerUnit, dialog.request.basePlate)) {
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
