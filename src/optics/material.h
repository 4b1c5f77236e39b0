// How surfaces answer light, and the lights: the Phong model of Virtual Ray Tracer. Colours are linear RGB.
#pragma once

#include "math/vec.h"

namespace anamorph {

/// colour * (ambient + diffuse * sum of light * cos) + specular * sum of light * cos^shininess.
struct Material {
  Color color{0.8};
  double ambient = 0.2;
  double diffuse = 0.7;
  double specular = 0.15;
  double shininess = 32;

  bool operator==(const Material&) const = default;
};

/// A point light; intensity does not fall off with distance, as in Virtual Ray Tracer.
struct PointLight {
  Point position{0, 0, 10};
  Color color{1};
  double intensity = 1;

  bool operator==(const PointLight&) const = default;
};

/// A vertical gradient behind everything: `bottom` straight down, `top` straight up.
struct Background {
  Color top{0.02, 0.045, 0.09};
  Color bottom{0.48, 0.52, 0.57};

  bool operator==(const Background&) const = default;
};

}  // namespace anamorph
