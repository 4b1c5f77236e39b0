// The mirror, or the canvas in its place: shape, place, look.

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/language.h"
#include "edit/control_points.h"
#include "level/mirror_kind.h"
#include "optics/shape_table.h"
#include "panels/file_flow.h"
#include "panels/panels.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

constexpr NumberRange coordinates{limits::coordinates, 0.02, "%.2f"};
constexpr NumberRange lengthRange{limits::lengths, 0.01, "%.2f"};

// Rows of a shape's fields; a panel has its sizes first and then its points.
class ShapeRows : public ShapeFields {
 public:
  enum class Part { sizes, points };
  ShapeRows(Part part, int selected) : controlPoint(selected), part_(part) {}

  void length(const FieldName& name, double& value) override {
    if (part_ != Part::sizes) return;
    const NumberRange range = name.mayBeZero
                                  ? NumberRange{limits::lengthsOrZero, lengthRange.speed, lengthRange.format}
                                  : lengthRange;
    changed |= numberRow(name.label, value, range, name.help);
  }
  void direction(const FieldName& name, Vector& value) override { point(name, value); }
  void angles(const FieldName& name, Vector& value) override { point(name, value); }
  void flag(const FieldName& name, bool& value) override {
    if (part_ == Part::sizes) changed |= checkRow(name.label, value, name.help);
  }
  void lengths(const FieldName& name, std::span<double> values) override {
    if (part_ != Part::sizes) return;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string label = fmt::format("{} {}", tr(name.label), i + 1);
      changed |= numberRow(label.c_str(), values[i], lengthRange, name.help);
    }
  }
  void radii(const FieldName& name, std::vector<double>& values) override {
    if (!splineRows(name, values)) return;
    changed |= numberRow("Its radius", values[chosen()], lengthRange);
  }
  void curve(const FieldName& name, std::vector<CurvePoint>& values) override {
    if (!splineRows(name, values)) return;
    changed |= numberRow("Its x", values[chosen()].x, coordinates);
    changed |= numberRow("Its y", values[chosen()].y, coordinates);
  }
  void heights(const FieldName& name, HeightGrid& values) override {
    if (part_ != Part::sizes || values.rows() < 2 || values.columns < 2) return;
    int rows = static_cast<int>(values.rows()), columns = static_cast<int>(values.columns);
    if (integerRow("Control rows", rows, limits::patchPoints, name.help) |
        integerRow("Control columns", columns, limits::patchPoints, name.help)) {
      values = resampled(values, static_cast<std::size_t>(rows), static_cast<std::size_t>(columns));
      changed = true;
    }
    pointRow(values.heights.size());
    changed |= numberRow("Its height", values.heights[chosen()], coordinates);
  }
  void file(const FieldName& name, SurfaceFile& value) override {
    if (part_ == Part::sizes) textRow(name.label, value.path, name.help);
  }
  void distance(const FieldName& name, const Point& from, Point& to) override {
    if (part_ != Part::sizes) return;
    const double old = glm::length(to - from);
    double now = old;
    if (!numberRow(name.label, now, lengthRange, name.help)) return;
    to = from + now * (old > 0 ? (to - from) / old : Vector(0, 0, 1));
    changed = true;
  }
  void point(const FieldName& name, Point& value) override {
    if (part_ == Part::points) changed |= vectorRow(name.label, value, coordinates, name.help);
  }
  void points(const FieldName& name, std::span<Point> values) override {
    if (part_ != Part::points) return;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string label = fmt::format("{} {}", tr(name.label), i + 1);
      changed |= vectorRow(label.c_str(), values[i], coordinates, name.help);
    }
  }

  bool changed = false;
  int controlPoint;  ///< the control point that is selected; -1: none

 private:
  std::size_t chosen() const { return static_cast<std::size_t>(std::max(controlPoint, 0)); }

  // Which of the control points the next rows are about.
  void pointRow(std::size_t count) {
    int number = std::min(std::max(controlPoint, 0) + 1, static_cast<int>(count));
    if (integerRow("Control point", number, {1, static_cast<double>(count)},
                   "Or drag its dot in the 3D view, where the mirror is selected.") ||
        controlPoint >= static_cast<int>(count)) {
      controlPoint = number - 1;
    }
  }

  template <typename Value>
  bool splineRows(const FieldName& name, std::vector<Value>& values) {
    if (part_ != Part::sizes || values.size() < 2) return false;
    int count = static_cast<int>(values.size());
    const Range counts{static_cast<double>(name.fewest), limits::splinePoints.max};
    if (integerRow("Control points", count, counts, name.help)) {
      values = resampled(values, static_cast<std::size_t>(std::max(count, 2)));
      changed = true;
    }
    pointRow(values.size());
    return true;
  }

  Part part_;
};

bool shapeRows(Shape& shape, Selection& selection) {
  const int before = selection.part == Part::controlPoint ? selection.index : -1;
  ShapeRows sizes(ShapeRows::Part::sizes, before), points(ShapeRows::Part::points, before);
  visitFields(shape, sizes);
  visitFields(shape, points);
  if (sizes.controlPoint != before) selection = {Part::controlPoint, sizes.controlPoint};
  return sizes.changed || points.changed;
}

// A kind that needs a file comes into the level when that has been chosen and read.
bool shapeChoice(Shape& shape, Editor& editor, UiState& ui) {
  std::vector<const char*> labels;
  for (const ShapeType& type : shapeTypes()) labels.push_back(type.label);
  int chosen = static_cast<int>(shapeIndex(shape));
  if (!choiceRow("Shape", chosen, labels,
                 "Another one has the same middle, and is as large as fits the old one.")) {
    return false;
  }
  const auto kind = static_cast<std::size_t>(chosen);
  if (shapeTypes()[kind].needsFile) chooseMirror(editor, ui);
  const Shape old = std::exchange(shape, mirrorOfKind(kind, shape, editor.session.level().camera.eye));
  return !(old == shape);
}

// The planes that cut it off. One that would leave nothing is said to, as any other fault of the shape.
bool cutRows(Shape& shape) {
  std::vector<HalfSpace> clip = shape.clip();
  bool changed = false;
  for (std::size_t i = 0; i < clip.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    changed |= vectorRow("Cut at", clip[i].point, coordinates, "A point of the plane.");
    Vector keeps = clip[i].normal;
    if (vectorRow("Keeps towards", keeps, coordinates,
                  "The plane's normal: what lies on its side is kept.") &&
        glm::length(keeps) >= limits::lengths.min) {
      clip[i].normal = keeps;
      changed = true;
    }
    const bool removed = wideButton("Remove this cut");
    ImGui::PopID();
    if (!removed) continue;
    clip.erase(clip.begin() + static_cast<std::ptrdiff_t>(i));
    shape.clipBy(std::move(clip));
    return true;
  }
  const bool hasMiddle = !findShapeProblem(shape);
  if (wideButton("Cut it off", "By a plane through its middle; the upper part is kept.",
                 hasMiddle && clip.size() < limits::mostClips)) {
    clip.push_back({middleOf(shape), {0, 0, 1}});
    changed = true;
  }
  if (changed) shape.clipBy(std::move(clip));
  return changed;
}

}  // namespace

void drawMirrorProperties(Editor& editor, UiState& ui) {
  Level level = editor.session.level();
  Shape& shape = level.optic.shape();
  bool changed = false;
  bool reflects = isVisible(level.optic);
  if (section(ui, reflects ? "Mirror" : "Canvas")) {
    if (checkRow(
            "Reflects", reflects,
            "Off: no mirror but a canvas that light passes. The sculpture's points slide along the view rays "
            "towards it: perspective anamorphosis.")) {
      level.optic.parts.front().kind = reflects ? OpticKind::mirror : OpticKind::canvas;
      changed = true;
    }
    changed |= shapeChoice(shape, editor, ui);
    changed |= shapeRows(shape, editor.selection);
    if (shapeTypes()[shapeIndex(shape)].needsFile && wideButton("Another mesh...")) chooseMirror(editor, ui);
    problemText(ui, findShapeProblem(shape).value_or(""));
  }
  if (section(ui, "Cuts", !shape.clip().empty())) changed |= cutRows(shape);
  if (reflects && section(ui, "Look", false)) {
    changed |= colorRow("Tint", level.mirrorLook.tint, "The colour of what it reflects.");
    changed |= sliderRow("Reflectance", level.mirrorLook.reflectance, {limits::fractions, 0.01, "%.2f"},
                         "The share of the light that it gives back.");
  }
  if (changed) editor.session.change(std::move(level));
}

}  // namespace anamorph
