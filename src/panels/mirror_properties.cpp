// The mirror: its shape, its place, its look.

#include "panels/panels.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

constexpr NumberRange coordinates{-1e6, 1e6, 0.02, "%.2f"};
constexpr NumberRange lengths{0, 1e6, 0.01, "%.2f"};

// Another kind of mirror about the same centre, of a size that goes with the lengths of the levels.
MirrorShape replacement(int kind, const MirrorShape& old) {
  const Point c = middleOf(old);
  if (kind == 0)
    return PlaneMirror{
        {c + Vector(-5, 0, -4), c + Vector(5, 0, -4), c + Vector(5, 0, 4), c + Vector(-5, 0, 4)}};
  if (kind == 1) return CylinderMirror{c - Vector(0, 0, 5), c + Vector(0, 0, 5), 3};
  return SphereMirror{c, 4};
}

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

void drawMirrorProperties(Workspace& work, UiState& ui) {
  Level level = work.session.level();
  MirrorShape& shape = level.optic.shape;
  bool changed = false;
  if (section(ui, "Mirror")) {
    int kind = static_cast<int>(shape.index());
    if (choiceRow("Shape", kind, {"Plane", "Cylinder", "Sphere"}) &&
        kind != static_cast<int>(shape.index())) {
      shape = replacement(kind, shape);
      changed = true;
    }
    changed |= std::visit(ShapeRows{}, shape);
  }
  if (section(ui, "Look", false)) {
    changed |= colorRow("Tint", level.mirrorLook.tint, "The colour of what it reflects.");
    changed |= sliderRow("Reflectance", level.mirrorLook.reflectance, {0, 1, 0.01, "%.2f"},
                         "The share of the light that it gives back.");
  }
  if (changed) work.session.change(std::move(level));
}

}  // namespace anamorph
