#include "panels/material_rows.h"

#include "panels/widgets.h"

namespace anamorph {

bool materialRows(Material& material) {
  const NumberRange fraction{limits::fractions, 0.01, "%.2f"};
  bool changed = colorRow("Colour", material.color);
  changed |= sliderRow("Ambient", material.ambient, fraction, "Light that comes from everywhere.");
  changed |= sliderRow("Diffuse", material.diffuse, fraction, "Light that is scattered to all sides.");
  changed |= sliderRow("Specular", material.specular, fraction, "The highlight's strength.");
  changed |= sliderRow("Shininess", material.shininess, {limits::shininess.panel, 1, "%.0f"},
                       "Larger: a smaller, sharper highlight.", true);
  return changed;
}

}  // namespace anamorph
