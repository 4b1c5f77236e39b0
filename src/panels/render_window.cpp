// The high-resolution picture: size and samples, progress, zoom, save.

#include <algorithm>

#include <imgui.h>

#include "base/language.h"
#include "panels/browser_places.h"
#include "panels/file_browser.h"
#include "panels/panels.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

void settings(UiState& ui) {
  RenderDialog& dialog = ui.render;
  integerRow("Longer side", dialog.longerSide, limits::renderedSize.panel, "In pixels.");
  integerRow("Samples", dialog.samplesPerAxis, limits::samplesPerAxis,
             "Along each side of a pixel: 3 means 9 rays a pixel.");
  if (dialog.running) {
    ImGui::ProgressBar(static_cast<float>(dialog.fraction), {-80 * static_cast<float>(ui.scale), 0});
    ImGui::SameLine();
    if (ImGui::Button(tr("Cancel"), {-FLT_MIN, 0})) ui.requests.cancelRender = true;
  } else if (wideButton("Render")) {
    ui.requests.startRender = true;
  }
}

// Drag to shift, wheel to zoom at the mouse.
void picture(UiState& ui, const ImVec2& room) {
  RenderDialog& dialog = ui.render;
  const UiTexture& t = ui.textures.render;
  const ImVec2 p = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("picture", room);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(p, {p.x + room.x, p.y + room.y}, ImGui::GetColorU32(ImGuiCol_FrameBg));
  if (t.id == 0) return;
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActive()) {
    dialog.panX += io.MouseDelta.x;
    dialog.panY += io.MouseDelta.y;
  }
  const float fit = std::min(room.x / static_cast<float>(t.width), room.y / static_cast<float>(t.height));
  const ImVec2 middle{p.x + room.x / 2, p.y + room.y / 2};
  if (ImGui::IsItemHovered() && io.MouseWheel != 0) {
    const float zoom = std::clamp(dialog.zoom * std::pow(1.2f, io.MouseWheel), 1.0f, 40.0f),
                factor = zoom / dialog.zoom;
    dialog.panX = (dialog.panX - (io.MousePos.x - middle.x)) * factor + (io.MousePos.x - middle.x);
    dialog.panY = (dialog.panY - (io.MousePos.y - middle.y)) * factor + (io.MousePos.y - middle.y);
    dialog.zoom = zoom;
  }
  if (dialog.zoom == 1) dialog.panX = dialog.panY = 0;
  const float w = 0.5f * fit * dialog.zoom * static_cast<float>(t.width),
              h = 0.5f * fit * dialog.zoom * static_cast<float>(t.height);
  list->PushClipRect(p, {p.x + room.x, p.y + room.y}, true);
  list->AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(t.id)),
                 {middle.x + dialog.panX - w, middle.y + dialog.panY - h},
                 {middle.x + dialog.panX + w, middle.y + dialog.panY + h});
  list->PopClipRect();
}

// Proposes a name beside the last picture.
void saveButton(const Editor& editor, UiState& ui) {
  RenderDialog& dialog = ui.render;
  if (!wideButton("Save as...", "", ui.textures.render.id != 0 && !dialog.running)) return;
  dialog.choosing = true;
  browseFiles(ui, FilePurpose::saveImage,
              proposedExport(ui, dialog.folder, editor.session.path(), "render.png"));
}

}  // namespace

void drawRenderWindow(Editor& editor, UiState& ui) {
  RenderDialog& dialog = ui.render;
  if (const auto path = awaitChosenFile(ui, FilePurpose::saveImage, dialog.choosing)) {
    dialog.folder = path->parent_path();
    ui.requests.saveRender = *path;
  }
  if (!dialog.open) return;
  if (beginToolWindow(ui, "Render image", "###render", dialog.open, 620, 720)) {
    settings(ui);
    const float below = 2 * ImGui::GetFrameHeightWithSpacing();
    const ImVec2 avail = ImGui::GetContentRegionAvail();
    picture(ui, {std::max(1.0f, avail.x), std::max(1.0f, avail.y - below)});
    saveButton(editor, ui);
    quietText(ui, dialog.message.empty() ? "Wheel: zoom. Drag: shift." : dialog.message.c_str());
  }
  ImGui::End();
}

}  // namespace anamorph
