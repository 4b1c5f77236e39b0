// What lies over the 3D view: the frame of the RT camera's image, the gizmo, labels of the construction,
// axes.

#include <algorithm>
#include <array>
#include <cmath>

#include <imgui.h>

#include "panels/panels.h"
#include "panels/style.h"
#include "panels/view_panel.h"
#include "panels/view_windows.h"

namespace anamorph {
namespace {

constexpr std::array<ImU32, 4> axisColors{IM_COL32(226, 74, 70, 255), IM_COL32(74, 176, 84, 255),
                                          IM_COL32(76, 134, 235, 255), IM_COL32(240, 240, 240, 255)};

// Draws in pixels of the view.
class Ink {
 public:
  Ink(const Workspace& work, const UiState& ui)
      : projection_(work.pose, std::max(1, work.viewWidth), std::max(1, work.viewHeight)),
        rect_(ui.layout.view),
        scale_(static_cast<float>(ui.scale)),
        list_(ImGui::GetWindowDrawList()) {}

  const ViewProjection& projection() const { return projection_; }
  float scale() const { return scale_; }
  ImDrawList& list() const { return *list_; }
  ImVec2 at(const Pixel& pixel) const {
    return {rect_.x + static_cast<float>(pixel.x), rect_.y + static_cast<float>(pixel.y)};
  }

  // Text on a plate that keeps it readable over anything.
  void label(const Pixel& pixel, const std::string& text, ImU32 color) const {
    if (!(std::abs(pixel.x) < 1e5 && std::abs(pixel.y) < 1e5)) return;
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 p = at(pixel), pad{4 * scale_, 1 * scale_};
    list_->AddRectFilled({p.x - pad.x, p.y - pad.y}, {p.x + size.x + pad.x, p.y + size.y + pad.y},
                         IM_COL32(18, 20, 25, 190), 3 * scale_);
    list_->AddText(p, color, text.c_str());
  }

 private:
  ViewProjection projection_;
  Rect rect_;
  float scale_;
  ImDrawList* list_;
};

void drawGizmo(const Ink& ink, const Gizmo& gizmo) {
  for (const GizmoShape& shape : gizmo.shapes) {
    std::vector<ImVec2> points;
    for (const Pixel& pixel : shape.points) points.push_back(ink.at(pixel));
    ImU32 color = axisColors[static_cast<std::size_t>(std::clamp(shape.color, 0, 3))];
    if (shape.emphasis == GizmoShape::Emphasis::strong) color = IM_COL32(255, 205, 60, 255);
    if (shape.emphasis == GizmoShape::Emphasis::dim)
      color = (color & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 70);
    const bool plane = shape.filled && axisOf(shape.handle) < 3 && shape.points.size() == 4 &&
                       (shape.handle == GizmoHandle::xy || shape.handle == GizmoHandle::yz ||
                        shape.handle == GizmoHandle::zx);
    if (plane) color = (color & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 130);
    if (shape.filled) {
      ink.list().AddConvexPolyFilled(points.data(), static_cast<int>(points.size()), color);
    } else {
      ink.list().AddPolyline(points.data(), static_cast<int>(points.size()), color, 0, 2.6f * ink.scale());
    }
  }
}

void drawConstruction(const Ink& ink, const Construction& construction) {
  const auto draw = [&](const ConstructionLabel& label, ImU32 color, double dx, double dy) {
    if (const auto pixel = ink.projection().pixelOf(label.at)) {
      ink.label(*pixel + Pixel(dx, dy) * double(ink.scale()), label.text, color);
    }
  };
  const ImU32 white = IM_COL32(255, 255, 255, 255), green = IM_COL32(90, 220, 170, 255),
              yellow = IM_COL32(255, 225, 120, 255);
  for (const ConstructionArc& arc : construction.arcs) draw(arc.label, green, 6, -8);
  for (const ConstructionLabel& label : construction.distances) draw(label, yellow, 8, -8);
  for (const ConstructionLabel& label : construction.points) {
    if (const auto pixel = ink.projection().pixelOf(label.at)) {
      ink.list().AddCircleFilled(ink.at(*pixel), 4.2f * ink.scale(), IM_COL32(20, 22, 28, 255));
      ink.list().AddCircleFilled(ink.at(*pixel), 3.0f * ink.scale(), white);
    }
    draw(label, white, 8, 3);
  }
}

// A cross where the RT camera looks at, while it is selected.
void drawAim(const Ink& ink, const Workspace& work) {
  if (work.selection.part != Part::eye && work.selection.part != Part::aim) return;
  if (!work.display.rtCamera || work.lookingThrough) return;
  const auto pixel = ink.projection().pixelOf(work.session.level().camera.target);
  if (!pixel || !(std::abs(pixel->x) < 1e5 && std::abs(pixel->y) < 1e5)) return;
  const ImVec2 p = ink.at(*pixel);
  const float r = 7 * ink.scale();
  const ImU32 color =
      work.selection.part == Part::aim ? IM_COL32(255, 89, 0, 255) : IM_COL32(255, 255, 255, 220);
  ink.list().AddCircle(p, r, color, 0, 1.8f * ink.scale());
  ink.list().AddLine({p.x - 1.6f * r, p.y}, {p.x + 1.6f * r, p.y}, color, 1.4f * ink.scale());
  ink.list().AddLine({p.x, p.y - 1.6f * r}, {p.x, p.y + 1.6f * r}, color, 1.4f * ink.scale());
}

void drawAxes(const Ink& ink, const Rect& rect) {
  constexpr const char* names[] = {"x", "y", "z"};
  const float s = ink.scale(), length = 30 * s;
  const ImVec2 origin{rect.x + 48 * s, rect.y + rect.height - 48 * s};
  const Frame& frame = ink.projection().frame();
  std::array<int, 3> order{0, 1, 2};
  const auto depth = [&](int axis) { return frame.forward[axis]; };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return depth(a) > depth(b); });
  for (const int axis : order) {
    const ImVec2 tip{origin.x + length * static_cast<float>(frame.right[axis]),
                     origin.y - length * static_cast<float>(frame.up[axis])};
    const ImU32 color = axisColors[static_cast<std::size_t>(axis)];
    ink.list().AddLine(origin, tip, color, 2.4f * s);
    const ImVec2 size = ImGui::CalcTextSize(names[axis]);
    const float k = 1.32f;
    ink.list().AddText(
        {origin.x + k * (tip.x - origin.x) - size.x / 2, origin.y + k * (tip.y - origin.y) - size.y / 2},
        color, names[axis]);
  }
}

// While the view is the RT camera's: the border of its image, and all beside it dimmed.
void drawImageFrame(const Ink& ink, const Workspace& work, const Rect& rect) {
  if (!work.lookingThrough || work.flight) return;
  const Camera& camera = work.session.level().camera;
  const double imageAspect = double(camera.gridColumns) / camera.gridRows;
  const double half = std::min(0.5 * rect.height * imageAspect, 0.5 * rect.width);
  const float w = static_cast<float>(half), h = static_cast<float>(half / imageAspect);
  const float cx = rect.x + rect.width / 2, cy = rect.y + rect.height / 2;
  const ImU32 dim = IM_COL32(0, 0, 0, 110);
  ImDrawList& list = ink.list();
  list.AddRectFilled({rect.x, rect.y}, {rect.x + rect.width, cy - h}, dim);
  list.AddRectFilled({rect.x, cy + h}, {rect.x + rect.width, rect.y + rect.height}, dim);
  list.AddRectFilled({rect.x, cy - h}, {cx - w, cy + h}, dim);
  list.AddRectFilled({cx + w, cy - h}, {rect.x + rect.width, cy + h}, dim);
  list.AddRect({cx - w, cy - h}, {cx + w, cy + h}, IM_COL32(255, 255, 255, 150), 0, 0, 1.2f * ink.scale());
}

}  // namespace

void drawViewOverlay(Workspace& work, UiState& ui) {
  const Rect& rect = ui.layout.view;
  if (rect.empty()) return;
  ImGui::Begin("view");
  const Ink ink(work, ui);
  ink.list().PushClipRect({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, true);
  drawImageFrame(ink, work, rect);
  drawAim(ink, work);
  if (const auto construction = currentConstruction(work)) drawConstruction(ink, *construction);
  drawGizmo(ink, emphasised(currentGizmo(work, ui).gizmo, ui.hoveredHandle.value_or(GizmoHandle::none)));
  drawAxes(ink, rect);
  ink.list().PopClipRect();
  ImGui::End();
  drawViewButtons(work, ui);
  drawProblem(work, ui);
  if (ui.preferences.legend && work.rays.show) drawLegend(work, ui);
}

}  // namespace anamorph
