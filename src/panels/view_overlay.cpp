// The 3D view's picture and what lies over it: the frame of the RT camera's image, the gizmo, labels of the construction,
// axes.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <imgui.h>

#include "edit/lesson_run.h"
#include "panels/highlight.h"
#include "panels/panels.h"
#include "panels/style.h"
#include "panels/view_panel.h"
#include "panels/view_windows.h"

namespace anamorph {
namespace {

// Draws in pixels of the view.
class Ink {
 public:
  Ink(const Editor& editor, const UiState& ui)
      : projection_(editor.pose, std::max(1, editor.viewWidth), std::max(1, editor.viewHeight)),
        rect_(ui.layout.view),
        scale_(static_cast<float>(ui.scale)),
        list_(ImGui::GetWindowDrawList()) {}

  const ViewProjection& projection() const { return projection_; }
  float scale() const { return scale_; }
  ImDrawList& list() const { return *list_; }
  ImVec2 at(const Pixel& pixel) const {
    return {rect_.x + static_cast<float>(pixel.x), rect_.y + static_cast<float>(pixel.y)};
  }

  // Where a point is seen, unless that is far outside the view.
  std::optional<Pixel> find(const Point& point) const {
    const auto pixel = projection_.pixelOf(point);
    if (!pixel || !(std::abs(pixel->x) < 1e4 && std::abs(pixel->y) < 1e4)) return std::nullopt;
    return pixel;
  }

 private:
  ViewProjection projection_;
  Rect rect_;
  float scale_;
  ImDrawList* list_;
};

// Text on plates that keep it readable over anything. Each label goes beside its point, to the first of some
// places where it covers no other label and no marked point.
class Labels {
 public:
  explicit Labels(const Ink& ink) : ink_(ink) {}

  void keepFree(const Pixel& pixel) {
    const float r = 5 * ink_.scale();
    const ImVec2 p = ink_.at(pixel);
    taken_.push_back({p.x - r, p.y - r, 2 * r, 2 * r});
  }

  void draw(const Pixel& pixel, const std::string& text, ImU32 color) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str()), p = ink_.at(pixel);
    const Rect plate = place(p, {size.x + 2 * padX(), size.y + 2 * padY()});
    taken_.push_back(plate);
    const ImVec2 middle{plate.x + plate.width / 2, plate.y + plate.height / 2};
    const float away = std::hypot(middle.x - p.x, middle.y - p.y);
    if (away > plate.width / 2 + 26 * ink_.scale())
      ink_.list().AddLine(p, middle, IM_COL32(255, 255, 255, 110));
    ink_.list().AddRectFilled({plate.x, plate.y}, {plate.x + plate.width, plate.y + plate.height},
                              ink::of(palette::labelPlate, 205), 3 * ink_.scale());
    ink_.list().AddText({plate.x + padX(), plate.y + padY()}, color, text.c_str());
  }

 private:
  float padX() const { return 4 * ink_.scale(); }
  float padY() const { return 1 * ink_.scale(); }

  // Around the point in rings that grow, to the right first.
  Rect place(const ImVec2& p, const ImVec2& size) const {
    constexpr int directions = 12, rings = 7;
    for (int ring = 0; ring < rings; ++ring) {
      const float gap = (9 + 15 * static_cast<float>(ring)) * ink_.scale();
      for (int i = 0; i < directions; ++i) {
        const int step = (i + 1) / 2 * (i % 2 == 0 ? 1 : -1);
        const float angle = static_cast<float>(2 * pi * step / directions);
        const float x = std::cos(angle), y = std::sin(angle);
        const Rect plate{p.x + gap * x + (x - 1) * size.x / 2, p.y + gap * y + (y - 1) * size.y / 2, size.x,
                         size.y};
        if (std::none_of(taken_.begin(), taken_.end(), [&](const Rect& r) { return overlap(r, plate); }))
          return plate;
      }
    }
    return {p.x + 9 * ink_.scale(), p.y - size.y / 2, size.x, size.y};
  }

  // Or nearly touch each other.
  bool overlap(const Rect& a, const Rect& b) const {
    const float gap = 2 * ink_.scale();
    return a.x < b.x + b.width + gap && b.x < a.x + a.width + gap && a.y < b.y + b.height + gap &&
           b.y < a.y + a.height + gap;
  }

  const Ink& ink_;
  std::vector<Rect> taken_;
};

void drawGizmo(const Ink& ink, const Gizmo& gizmo) {
  for (const GizmoShape& shape : gizmo.shapes) {
    std::vector<ImVec2> points;
    for (const Pixel& pixel : shape.points) points.push_back(ink.at(pixel));
    ImU32 color = ink::of(palette::viewAxes[static_cast<std::size_t>(std::clamp(shape.color, 0, 3))]);
    if (shape.emphasis == GizmoShape::Emphasis::strong) color = ink::of(palette::heldHandle);
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

void drawPoints(const Ink& ink, const Construction& construction, Labels& labels) {
  for (const ConstructionLabel& label : construction.points) {
    const auto pixel = ink.find(label.at);
    if (!pixel) continue;
    labels.keepFree(*pixel);
    ink.list().AddCircleFilled(ink.at(*pixel), 4.2f * ink.scale(), ink::of(palette::pointRim));
    ink.list().AddCircleFilled(ink.at(*pixel), 3.0f * ink.scale(), ink::of(palette::pointLabel));
  }
}

// The vertex that was picked last with all it has; of the one before it only the letters, without the eye's.
void drawConstructions(const Ink& ink, Editor& editor, Labels& labels) {
  const auto& last = currentConstruction(editor);
  const auto& earlier = earlierConstruction(editor);
  const auto draw = [&](const ConstructionLabel& label, Rgb color) {
    if (const auto pixel = ink.find(label.at)) labels.draw(*pixel, label.text, ink::of(color));
  };
  for (const auto* construction : {&last, &earlier}) {
    if (*construction) drawPoints(ink, **construction, labels);
  }
  if (last) {
    for (const ConstructionLabel& label : last->points) draw(label, palette::pointLabel);
    for (const ConstructionLabel& label : last->distances) draw(label, palette::distanceLabel);
    for (const ConstructionArc& arc : last->arcs) draw(arc.label, palette::angleLabel);
  }
  if (!earlier) return;
  for (const ConstructionLabel& label : earlier->points) {
    if (label.text != "E") draw(label, palette::pointLabel);
  }
}

// A cross where the RT camera looks at, while it is selected.
void drawAim(const Ink& ink, const Editor& editor) {
  if (editor.selection.part != Part::eye && editor.selection.part != Part::aim) return;
  if (!editor.display.rtCamera || editor.lookingThrough) return;
  const auto pixel = ink.find(editor.session.level().camera.target);
  if (!pixel) return;
  const ImVec2 p = ink.at(*pixel);
  const float r = 7 * ink.scale();
  const ImU32 color =
      editor.selection.part == Part::aim ? ink::of(palette::selected) : IM_COL32(255, 255, 255, 220);
  ink.list().AddCircle(p, r, color, 0, 1.8f * ink.scale());
  ink.list().AddLine({p.x - 1.6f * r, p.y}, {p.x + 1.6f * r, p.y}, color, 1.4f * ink.scale());
  ink.list().AddLine({p.x, p.y - 1.6f * r}, {p.x, p.y + 1.6f * r}, color, 1.4f * ink.scale());
}

// A dot for each control point of the mirror, while it is selected.
void drawControlPoints(const Ink& ink, const Editor& editor) {
  const Selection& selection = editor.selection;
  if (!isOfMirror(selection)) return;
  const Shape& mirror = editor.session.level().optic.shape();
  if (!editor.display.mirror || editor.lookingThrough || findShapeProblem(mirror)) return;
  int number = 0;
  for (const ControlPoint& control : controlPointsOf(mirror)) {
    const bool chosen = selection == Selection{Part::controlPoint, number++};
    const auto pixel = ink.find(control.at);
    if (!pixel) continue;
    const ImVec2 p = ink.at(*pixel);
    const float r = (chosen ? 5.5f : 3.5f) * ink.scale();
    ink.list().AddCircleFilled(p, r + 1.2f * ink.scale(), ink::of(palette::pointRim));
    ink.list().AddCircleFilled(p, r, chosen ? ink::of(palette::selected) : ink::of(palette::pointLabel));
  }
}

void drawAxes(const Ink& ink, const Rect& rect) {
  constexpr const char* names[] = {"x", "y", "z"};
  const float s = ink.scale(), length = 30 * s;
  const float up = rect.width < 420 * s ? 92 * s : 48 * s;  // in a narrow view the button is below them
  const ImVec2 origin{rect.x + 48 * s, rect.y + rect.height - up};
  const Frame& frame = ink.projection().frame();
  std::array<int, 3> order{0, 1, 2};
  const auto depth = [&](int axis) { return frame.forward[axis]; };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return depth(a) > depth(b); });
  for (const int axis : order) {
    const ImVec2 tip{origin.x + length * static_cast<float>(frame.right[axis]),
                     origin.y - length * static_cast<float>(frame.up[axis])};
    const ImU32 color = ink::of(palette::viewAxes[static_cast<std::size_t>(axis)]);
    ink.list().AddLine(origin, tip, color, 2.4f * s);
    const ImVec2 size = ImGui::CalcTextSize(names[axis]);
    const float k = 1.32f;
    ink.list().AddText(
        {origin.x + k * (tip.x - origin.x) - size.x / 2, origin.y + k * (tip.y - origin.y) - size.y / 2},
        color, names[axis]);
  }
}

// While the view is the RT camera's: the border of its image, and all beside it dimmed.
void drawImageFrame(const Ink& ink, const Editor& editor, const Rect& rect) {
  if (!editor.lookingThrough || editor.flight) return;
  const PixelGrid& grid = editor.session.level().grid;
  const double imageAspect = double(grid.columns) / grid.rows;
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

// The points that the open step's move picks; where it picks none, the view as a whole.
void highlightView(const Ink& ink, const Editor& editor, const Rect& rect) {
  const auto around = [](const ImVec2& low, const ImVec2& high, float by) {
    highlightArea("3D view", {low.x - by, low.y - by}, {high.x + by, high.y + by});
  };
  bool anyPoint = false;
  for (const Point& point : pointsOfMove(editor)) {
    const auto pixel = ink.find(point);
    if (!pixel) continue;
    around(ink.at(*pixel), ink.at(*pixel), 8 * ink.scale());
    anyPoint = true;
  }
  if (!anyPoint) around({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, -ImGui::GetFontSize());
}

void drawPicture(const UiTexture& picture, const Rect& rect) {
  if (picture.id == 0) return;
  const float top = picture.bottomUp ? 1.0f : 0.0f;
  ImGui::GetWindowDrawList()->AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(picture.id)),
                                       {rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height},
                                       {0, top}, {1, 1 - top});
}

}  // namespace

void drawView(Editor& editor, UiState& ui) {
  const Rect& rect = ui.layout.view;
  if (rect.empty()) return;
  ImGui::Begin("view");
  drawPicture(ui.textures.view, rect);
  const Ink ink(editor, ui);
  ink.list().PushClipRect({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, true);
  drawImageFrame(ink, editor, rect);
  drawAim(ink, editor);
  drawControlPoints(ink, editor);
  const bool alone = editor.display.alone != ShownAlone::nothing;
  Labels labels(ink);
  if (!alone) drawConstructions(ink, editor, labels);
  const ShownGizmo shown = currentGizmo(editor, ui);
  drawGizmo(ink, emphasised(shown.gizmo, ui.mouse.hoveredHandle.value_or(GizmoHandle::none)));
  if (const auto at = shown.label ? ink.find(shown.label->at) : std::nullopt)
    labels.draw(*at, shown.label->text, ink::of(palette::distanceLabel));
  if (!ui.bare) drawAxes(ink, rect);
  ink.list().PopClipRect();
  highlightView(ink, editor, rect);
  ImGui::End();
  if (!(ui.headless && ui.panelsHidden)) drawViewButtons(editor, ui);
  drawProblem(editor, ui);
  if (ui.bare) return;
  drawViewSigns(editor, ui);
  drawViewProblem(ui);
  drawPausedRays(editor, ui);
  if (ui.preferences.legend && !alone) drawLegend(editor, ui);
}

}  // namespace anamorph
