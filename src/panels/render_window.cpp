#include "panels/render_window.h"

#include <algorithm>

#include <imgui.h>

#include "base/language.h"
#include "panels/browser_places.h"
#include "panels/file_browser.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

void settings(RenderDialog& dialog, UiRequests& requests, const Look& look) {
  integerRow("Longer side", dialog.longerSide, limits::renderedSize.panel, "In pixels.");
  integerRow("Samples", dialog.samplesPerAxis, limits::samplesPerAxis,
             "Along each side of a pixel: 3 means 9 rays a pixel.");
  if (dialog.running) {
    ImGui::ProgressBar(static_cast<float>(dialog.fraction), {-80 * static_cast<float>(look.scale), 0});
    ImGui::SameLine();
    if (ImGui::Button(tr("Cancel"), {-FLT_MIN, 0})) requests.cancelRender = true;
  } else if (wideButton("Render")) {
    requests.startRender = true;
  }
}

// Drag to shift, wheel to zoom at the mouse.
void picture(RenderDialog& dialog, const UiTexture& t, const ImVec2& room) {
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
void saveButton(RenderDialog& dialog, const UiTexture& image, const std::filesystem::path& level,
                FileBrowser& browser) {
  if (!wideButton("Save as...", "", image.id != 0 && !dialog.running)) return;
  dialog.choosing = true;
  browseFiles(browser, FilePurpose::saveImage, proposedExport(browser, dialog.folder, level, "render.png"));
}

}  // namespace

void drawRenderWindow(RenderDialog& dialog, const UiTexture& image, const std::filesystem::path& level,
                      FileBrowser& browser, UiRequests& requests, const Look& look) {
  if (const auto path = awaitChosenFile(browser, FilePurpose::saveImage, dialog.choosing)) {
    dialog.folder = path->parent_path();
    requests.saveRender = *path;
  }
  if (!dialog.open) return;
  if (beginToolWindow(look, "Render image", "###render", dialog.open, 620, 720)) {
    settings(dialog, requests, look);
    const float below = 2 * ImGui::GetFrameHeightWithSpacing();
    const ImVec2 avail = ImGui::GetContentRegionAvail();
    picture(dialog, image, {std::max(1.0f, avail.x), std::max(1.0f, avail.y - below)});
    saveButton(dialog, image, level, browser);
    quietText(look, !dialog.saving.empty()   ? "The picture is being saved..."
                    : dialog.message.empty() ? "Wheel: zoom. Drag: shift."
                                             : dialog.message.c_str());
  }
  ImGui::End();
}

}  // namespace anamorph
