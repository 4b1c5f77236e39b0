#include "viewport/canvas_lines.h"

#include <cmath>

#include "math/frame.h"
#include "math/palette.h"

namespace anamorph {
namespace {

constexpr int divisions = 8, chords = 48;

class Drawing {
 public:
  explicit Drawing(bool selected) : color_(inkOf(selected ? palette::selected : palette::canvas)) {}

  void add(const Point& from, const Point& to, bool edge) {
    lines.push_back({from, to, color_, edge ? 0.95 : 0.4, edge ? 1.8 : 0.9});
  }

  /// middle + cos(angle) a + sin(angle) b
  void addRing(const Point& middle, const Vector& a, const Vector& b, bool edge) {
    const auto at = [&](int i) {
      const double angle = 2 * pi * i / chords;
      return middle + std::cos(angle) * a + std::sin(angle) * b;
    };
    for (int i = 0; i < chords; ++i) add(at(i), at(i + 1), edge);
  }

  std::vector<Line> lines;

 private:
  Color color_;
};

struct DrawShape {
  Drawing& drawing;

  void operator()(const PlaneMirror& plane) const {
    const auto& c = plane.corners;
    for (int i = 0; i <= divisions; ++i) {
      const bool edge = i == 0 || i == divisions;
      const double t = double(i) / divisions;
      drawing.add(glm::mix(c[0], c[1], t), glm::mix(c[3], c[2], t), edge);
      drawing.add(glm::mix(c[0], c[3], t), glm::mix(c[1], c[2], t), edge);
    }
  }
  void operator()(const CylinderMirror& cylinder) const {
    const Vector axis = cylinder.top - cylinder.bottom;
    const Direction along = glm::normalize(axis), side = perpendicular(along);
    const Vector a = cylinder.radius * side, b = cylinder.radius * glm::cross(along, side);
    for (int i = 0; i <= divisions / 2; ++i) {
      const bool edge = i == 0 || i == divisions / 2;
      drawing.addRing(cylinder.bottom + (2.0 * i / divisions) * axis, a, b, edge);
    }
    for (int i = 0; i < 2 * divisions; ++i) {
      const double angle = pi * i / divisions;
      const Vector out = std::cos(angle) * a + std::sin(angle) * b;
      drawing.add(cylinder.bottom + out, cylinder.top + out, false);
    }
  }
  void operator()(const SphereMirror& sphere) const {
    const double r = sphere.radius;
    const Vector x(r, 0, 0), y(0, r, 0), z(0, 0, r);
    for (int i = 0; i < divisions; ++i) {
      const double angle = pi * i / divisions;
      drawing.addRing(sphere.centre, std::cos(angle) * x + std::sin(angle) * y, z, false);
    }
    for (int i = 1; i < divisions; ++i) {
      const double up = pi * i / divisions - pi / 2;
      drawing.addRing(sphere.centre + std::sin(up) * z, std::cos(up) * x, std::cos(up) * y,
                      2 * i == divisions);
    }
  }
};

}  // namespace

std::vector<Line> makeCanvasLines(const Optic& optic, bool selected) {
  if (optic.kind != OpticKind::none || findShapeProblem(optic.shape)) return {};
  Drawing drawing(selected);
  std::visit(DrawShape{drawing}, optic.shape);
  return drawing.lines;
}

}  // namespace anamorph
