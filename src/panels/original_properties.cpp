// The original: what it is, where it stands, how it looks.

#include "panels/material_rows.h"
#include "panels/panels.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

OriginalShape defaultShape(int kind) {
  switch (kind) {
    case 1:
      return SphereShape{};
    case 2:
      return TorusKnotShape{};
    case 3:
      return LetterFShape{};
    case 4:
      return PawnShape{};
    default:
      return BoxShape{};
  }
}

struct ShapeRows {
  bool operator()(BoxShape& box) const {
    bool changed = vectorRow("Size", box.size, {0.01, 1000, 0.01, "%.2f"});
    changed |= integerRow("Segments", box.segments, 1, 64,
                          "Quads along every edge. 1 gives 8 vertices: try it with the tolerance off.");
    return changed;
  }
  bool operator()(SphereShape& sphere) const {
    bool changed = numberRow("Radius", sphere.radius, {0.01, 1000, 0.01, "%.2f"});
    changed |= integerRow("Segments", sphere.segments, 3, 256, "Around its equator.");
    return changed;
  }
  bool operator()(TorusKnotShape& knot) const {
    bool changed = numberRow("Tube radius", knot.tubeRadius, {0.01, 1, 0.005, "%.2f"});
    changed |= integerRow("Segments", knot.segments, 3, 1024, "Along the knot.");
    changed |= integerRow("Sides", knot.sides, 3, 64, "Around the tube.");
    return changed;
  }
  bool operator()(LetterFShape& letter) const {
    bool changed = numberRow("Height", letter.height, {0.01, 1000, 0.01, "%.2f"});
    changed |= integerRow("Segments", letter.segments, 1, 64, "Along every edge of its blocks.");
    return changed;
  }
  bool operator()(PawnShape& pawn) const {
    bool changed = numberRow("Height", pawn.height, {0.01, 1000, 0.01, "%.2f"});
    changed |= integerRow("Segments", pawn.segments, 3, 256, "Around its axis.");
    return changed;
  }
  bool operator()(FileShape& file) const {
    textRow("File", file.path);
    return false;
  }
};

bool shapeRows(OriginalShape& shape) {
  std::vector<const char*> names{"Box", "Sphere", "Torus knot", "Letter F", "Pawn"};
  if (std::holds_alternative<FileShape>(shape)) names.push_back("Mesh file");
  int kind = static_cast<int>(shape.index());
  if (choiceRow("Shape", kind, names, "What is to be seen in the mirror.") &&
      kind != static_cast<int>(shape.index())) {
    shape = defaultShape(kind);
    return true;
  }
  return std::visit(ShapeRows{}, shape);
}

bool placementRows(Placement& placement) {
  bool changed =
      vectorRow("Position", placement.position, {-1e6, 1e6, 0.02, "%.2f"}, "Of the shape's own origin.");
  changed |=
      vectorRow("Rotation", placement.rotationDegrees, {-1e6, 1e6, 0.5, "%.1f°"}, "About x, then y, then z.");
  changed |= vectorRow("Scale", placement.scale, {0, 1000, 0.005, "%.3f"}, "Along the shape's own axes.");
  return changed;
}

}  // namespace

void drawOriginalProperties(Workspace& work, UiState& ui) {
  Level level = work.session.level();
  bool changed = false;
  if (section(ui, "Original")) changed |= shapeRows(level.original.shape);
  if (section(ui, "Placement")) changed |= placementRows(level.original.placement);
  if (section(ui, "Shown as")) {
    int look = static_cast<int>(work.display.originalLook);
    if (choiceRow("Original", look, {"Solid", "Ghost", "Hidden"},
                  "In the 3D view. A ghost shines through the mirror in front of it.")) {
      work.display.originalLook = static_cast<OriginalLook>(look);
    }
    checkRow("Seen in the mirror", work.display.originalInMirror,
             "Whether the mirror of the 3D view reflects the original too.");
  }
  if (section(ui, "Material", false)) changed |= materialRows(level.original.material);
  if (changed) work.session.change(std::move(level));
}

}  // namespace anamorph
