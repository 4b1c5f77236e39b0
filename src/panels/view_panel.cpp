#include "panels/view_panel.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <imgui.h>

#include "base/language.h"
#include "edit/depth_handle.h"
#include "edit/orbit.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

constexpr float dragThreshold = 4;  // pixels that the mouse may move in a click

ViewProjection projectionOf(const Editor& editor) {
  return {editor.pose, std::max(1, editor.viewWidth), std::max(1, editor.viewHeight)};
}

Pixel mouseIn(const Rect& rect) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  return {mouse.x - rect.x, mouse.y - rect.y};
}

bool isUsable(const Pixel& pixel) {
  return std::abs(pixel.x) < 1e6 && std::abs(pixel.y) < 1e6;
}

DragKeys keysOf(const ViewMouse& mouse) {
  DragKeys keys{ImGui::GetIO().KeyCtrl, ImGui::GetIO().KeyShift, {}};
  if (mouse.axisLock >= 0) keys.axisLock = mouse.axisLock;
  return keys;
}

// On the ray of the construction, else on the one through the middle of the original.
ShownGizmo depthHandle(const Editor& editor, const Look& look) {
  ShownGizmo shown;
  shown.mode = GizmoMode::scale;
  const LevelResult& result = editor.updater.result();
  if (editor.session.level().sculpture.frozen) return shown;
  if (result.problem || !result.original.mesh || findProblem(result.level.optic)) return shown;
  const bool picked = editor.point && isOn(*result.original.mesh, *editor.point);
  const Point point = picked ? pointOn(*result.original.mesh, *editor.point) : result.original.box.centre();
  const VertexRay ray = makeVertexRay(makeVertexMap(result.level), point);
  const auto frame = depthFrame(ray);
  if (!frame) return shown;
  shown.frame = *frame;
  shown.gizmo = makeDepthHandle(projectionOf(editor), *frame, ray.sculpture, look.scale);
  const double depthScale = editor.session.level().sculpture.depthScale;
  shown.label = ConstructionLabel{ray.sculpture, shownFormat("k = {:.2f}", depthScale)};
  return shown;
}

void startGizmoDrag(Editor& editor, UiState& ui, const ShownGizmo& shown, GizmoHandle handle,
                    const Pixel& mouse) {
  editor.session.finishChange();  // of a number that was typed into until now
  ui.mouse.drag = ViewDrag::gizmo;
  ui.mouse.axisLock = -1;
  ui.mouse.gizmoDrag.emplace(GizmoDragStart{editor.session.level(), editor.selection, shown.frame, shown.mode,
                                            handle, projectionOf(editor), mouse, ui.scale});
}

// A control point is dragged by itself as by its arrow; where it may go in a plane, in that.
bool pressControlPoint(Editor& editor, UiState& ui, const Pixel& mouse) {
  const Pick picked = pickAt(editor, ui, mouse);
  const auto control = controlPointOf(editor.session.level(), picked.selection);
  if (!control) return false;
  editor.selection = picked.selection;
  const ShownGizmo shown = currentGizmo(editor, ui);
  startGizmoDrag(editor, ui, shown, control->freedom > 1 ? GizmoHandle::xy : GizmoHandle::x, mouse);
  return true;
}

void press(Editor& editor, UiState& ui, const Pixel& mouse) {
  const ShownGizmo shown = currentGizmo(editor, ui);
  const GizmoHandle handle = pickHandle(shown.gizmo, mouse);
  if (handle != GizmoHandle::none) return startGizmoDrag(editor, ui, shown, handle, mouse);
  if (pressControlPoint(editor, ui, mouse)) return;
  ui.mouse.clickPending = true;
}

void click(Editor& editor, const UiState& ui, const Pixel& mouse) {
  const Pick picked = pickAt(editor, ui, mouse);
  editor.selection = picked.cell ? Selection{Part::eye, 0} : picked.selection;
  if (picked.cell) return pickCell(editor, picked.cell == editor.cell ? std::nullopt : picked.cell);
  pickPoint(editor, picked.point == editor.point ? std::nullopt : picked.point);  // a second click lets it go
}

// A double click: what is there becomes the centre that the view turns around.
void centre(Editor& editor, const UiState& ui, const Pixel& mouse) {
  const Pick picked = pickAt(editor, ui, mouse);
  if (std::isfinite(picked.distance)) flyTo(editor, setCentre(editor.pose, picked.where));
}

void zoom(Editor& editor, const UiState& ui, const Pixel& mouse, double steps) {
  takeOverView(editor);
  const Pick picked = pickAt(editor, ui, mouse);
  editor.pose = std::isfinite(picked.distance) ? zoomTowards(editor.pose, picked.where, steps)
                                               : zoomTo(editor.pose, projectionOf(editor), mouse, steps);
}

// Who wants to look from below hides the ground.
ViewPose aboveFloor(const Editor& editor, const std::function<ViewPose(double fraction)>& moved) {
  const GroundSettings& ground = editor.session.level().ground;
  return ground.visible ? keptAbove(ground.height, editor.pose, moved) : moved(1);
}

// Sideways as the mouse goes, downwards as far as the floor.
void orbitBy(Editor& editor, double x, double y) {
  editor.pose = aboveFloor(editor, [&](double part) { return orbit(editor.pose, x, part * y); });
}

void panBy(Editor& editor, double x, double y) {
  const ViewProjection projection = projectionOf(editor);
  editor.pose = aboveFloor(editor, [&](double part) { return pan(editor.pose, projection, x, part * y); });
}

void beginDrags(Editor& editor, UiState& ui, const Pixel& mouse) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsMouseDoubleClicked(0)) {
    ui.mouse.clickPending = false;
    centre(editor, ui, mouse);
  } else if (ImGui::IsMouseClicked(0)) {
    press(editor, ui, mouse);
  } else if (ImGui::IsMouseClicked(1) || (ImGui::IsMouseClicked(2) && io.KeyShift)) {
    ui.mouse.drag = ViewDrag::pan;
  } else if (ImGui::IsMouseClicked(2)) {
    ui.mouse.drag = ViewDrag::orbit;
  }
  if (io.MouseWheel != 0 && std::isfinite(io.MouseWheel))
    zoom(editor, ui, mouse, std::clamp(io.MouseWheel, -10.0f, 10.0f));
}

void continueDrag(Editor& editor, UiState& ui, const Pixel& mouse) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ui.mouse.clickPending && ImGui::IsMouseDragging(0, dragThreshold * static_cast<float>(ui.scale))) {
    ui.mouse.clickPending = false;
    ui.mouse.drag = ViewDrag::orbit;
  }
  const bool moved = io.MouseDelta.x != 0 || io.MouseDelta.y != 0;
  switch (ui.mouse.drag) {
    case ViewDrag::orbit:
      if (!moved) break;
      takeOverView(editor);
      orbitBy(editor, io.MouseDelta.x / ui.scale, io.MouseDelta.y / ui.scale);
      break;
    case ViewDrag::pan:
      if (!moved) break;
      takeOverView(editor);
      panBy(editor, io.MouseDelta.x, io.MouseDelta.y);
      break;
    case ViewDrag::gizmo:
      editor.session.change(ui.mouse.gizmoDrag->levelAt(mouse, keysOf(ui.mouse)));
      editor.status.sayOf(editor.session.level(), ui.mouse.gizmoDrag->text());
      break;
    case ViewDrag::none:
      break;
  }
}

bool anyButtonDown() {
  return ImGui::IsMouseDown(0) || ImGui::IsMouseDown(1) || ImGui::IsMouseDown(2);
}

void handleMouse(Editor& editor, UiState& ui, bool hovered) {
  const Pixel mouse = mouseIn(ui.layout.view);
  ui.mouse.hoveredHandle.reset();
  if (!isUsable(mouse)) return;
  const bool busy = ui.mouse.drag != ViewDrag::none || ui.mouse.clickPending;
  if (hovered && !busy) beginDrags(editor, ui, mouse);
  continueDrag(editor, ui, mouse);
  if (!anyButtonDown()) {
    if (ui.mouse.clickPending) click(editor, ui, mouse);
    ui.mouse.clickPending = false;
    endViewDrag(editor, ui.mouse, true);
  }
  if (ui.mouse.drag == ViewDrag::gizmo) {
    ui.mouse.hoveredHandle = ui.mouse.gizmoDrag->start().handle;
  } else if (hovered) {
    ui.mouse.hoveredHandle = pickHandle(currentGizmo(editor, ui).gizmo, mouse);
  }
  if (ui.mouse.hoveredHandle && *ui.mouse.hoveredHandle != GizmoHandle::none)
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
}

}  // namespace

ShownGizmo currentGizmo(const Editor& editor, const Look& look) {
  ShownGizmo shown;
  const Selection& selection = editor.selection;
  const Level& level = editor.session.level();
  if (selection.part == Part::none) return shown;  // before any box is measured
  if (editor.lookingThrough && selection.part == Part::eye) return shown;
  if (selection.part == Part::sculpture) return depthHandle(editor, look);
  if (editor.point && selection.part == Part::original) return shown;  // it would cover the construction
  shown.mode = editor.gizmoMode;
  for (const GizmoMode mode : {GizmoMode::move, GizmoMode::scale}) {
    if (!allows(level, selection, shown.mode)) shown.mode = mode;
  }
  const auto frame =
      frameOf(level, selection, shown.mode, editor.gizmoLocal, originalBox(editor), sculptureBox(editor));
  if (!frame) return shown;
  shown.frame = *frame;
  shown.gizmo =
      makeGizmo(projectionOf(editor), *frame, shown.mode, look.scale, scalesUniformly(level, selection));
  if (const auto control = controlPointOf(level, selection)) {
    shown.gizmo = restricted(std::move(shown.gizmo), control->freedom);
  }
  return shown;
}

Pick pickAt(Editor& editor, const Look& look, const Pixel& pixel) {
  const PreparedSculpture sculpture = shownSculpture(editor);
  const DisplaySettings display = shown(editor.display);
  return pick({projectionOf(editor), editor.updater.result().level, editor.updater.result().original,
               sculpture, display, editor.selection, look.scale},
              pixel);
}

void handleView(Editor& editor, UiState& ui) {
  const Rect& rect = ui.layout.view;
  if (!rect.empty()) ImGui::SetNextWindowBgAlpha(0);  // the picture is all of it, and may be transparent
  if (!beginPanel("view", rect, false, false)) return;
  editor.viewWidth = std::max(1, static_cast<int>(rect.width));
  editor.viewHeight = std::max(1, static_cast<int>(rect.height));
  ImGui::SetCursorScreenPos({rect.x, rect.y});
  ImGui::InvisibleButton("3d", {rect.width, rect.height},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  const bool hovered = ImGui::IsItemHovered();
  handleMouse(editor, ui, hovered);
  ImGui::End();
}

}  // namespace anamorph
