// The mirror, or the canvas in its place: shape, place, look.

#include "edit/replacements.h"
#include "panels/panels.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

constexpr NumberRange coordinates{limits::coordinates, 0.02, "%.2f"};
constexpr NumberRange lengths{limits::lengths, 0.01, "%.2f"};

struct ShapeRows {
  bool operator()(PlaneMirror& plane) const {
    constexpr const char* names[] = {"Corner 1", "Corner 2", "Corner 3", "Corner 4"};
    bool changed = false;
    for (int i = 0; i < 4; ++i) {
      changed |= vectorRow(names[i], plane.corners[i], coordinates,
                           "The four corners have to lie in one plane, in order around it.");
    }
    return changed;
  }
  bool operator()(CylinderMirror& cylinder) const {
    bool changed = numberRow("Radius", cylinder.radius, lengths);
    double height = glm::length(cylinder.top - cylinder.bottom);
    if (numberRow("Height", height, lengths, "The bottom stays where it is.")) {
      const double old = glm::length(cylinder.top - cylinder.bottom);
      const Vector axis = old > 0 ? (cylinder.top - cylinder.bottom) / old : Vector(0, 0, 1);
      cylinder.top = cylinder.bottom + height * axis;
      changed = true;
    }
    changed |= vectorRow("Bottom", cylinder.bottom, coordinates, "The lower end of the axis.");
    changed |= vectorRow("Top", cylinder.top, coordinates, "The upper end of the axis.");
    return changed;
  }
  bool operator()(SphereMirror& sphere) const {
    bool changed = numberRow("Radius", sphere.radius, lengths);
    changed |= vectorRow("Centre", sphere.centre, coordinates);
    return changed;
  }
};

}  // namespace

void drawMirrorProperties(Editor& editor, UiState& ui) {
  Level level = editor.session.level();
  MirrorShape& shape = level.optic.shape;
  bool changed = false;
  bool reflects = level.optic.kind == OpticKind::mirror;
  if (section(ui, reflects ? "Mirror" : "Canvas")) {
    if (checkRow(
            "Reflects", reflects,
            "Off: no mirror but a canvas that light passes. The sculpture's points slide along the view rays "
            "towards it: perspective anamorphosis.")) {
      level.optic.kind = reflects ? OpticKind::mirror : OpticKind::none;
      changed = true;
    }
    int kind = static_cast<int>(shape.index());
    if (choiceRow("Shape", kind, {"Plane", "Cylinder", "Sphere"},
                  "Another one has the same middle, and is as large as fits the old one.") &&
        kind != static_cast<int>(shape.index())) {
      shape = mirrorOfKind(static_cast<std::size_t>(kind), shape, level.camera.eye);
      changed = true;
    }
    changed |= std::visit(ShapeRows{}, shape);
    problemText(ui, findShapeProblem(shape).value_or(""));
  }
  if (reflects && section(ui, "Look", false)) {
    changed |= colorRow("Tint", level.mirrorLook.tint, "The colour of what it reflects.");
    changed |= sliderRow("Reflectance", level.mirrorLook.reflectance, {limits::fractions, 0.01, "%.2f"},
                         "The share of the light that it gives back.");
  }
  if (changed) editor.session.change(std::move(level));
}

}  // namespace anamorph
