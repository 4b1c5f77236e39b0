#include "edit/gizmo.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

namespace anamorph {
namespace {

using Emphasis = GizmoShape::Emphasis;

constexpr double pickPixels = 7;
constexpr double endOnSine = 0.0871557427;  // sin 5 degrees: axes nearer to the view direction are hidden
constexpr double axisStart = 0.18, planeStart = 0.28, planeEnd = 0.48,
                 viewRing = 1.16;  // in lengths of an axis
constexpr int ringSegments = 72;

constexpr GizmoHandle axisHandles[] = {GizmoHandle::x, GizmoHandle::y, GizmoHandle::z};
constexpr GizmoHandle planeHandles[] = {GizmoHandle::yz, GizmoHandle::zx, GizmoHandle::xy};

// What a gizmo is made with. Points are given in lengths of an axis from the origin.
struct Maker {
  const ViewProjection& projection;
  const GizmoFrame& frame;
  Gizmo gizmo;
  Direction view;  // at the origin
  double length;   // of an axis, scene units
  Pixel origin;

  const Direction& axis(int i) const { return frame.axes[static_cast<std::size_t>(i)]; }
  std::optional<Pixel> at(const Vector& offset) const {
    return projection.pixelOf(frame.origin + length * offset);
  }
  double pixels(double at100Percent) const { return at100Percent * gizmo.uiScale; }

  void add(GizmoHandle handle, std::vector<Pixel> points, bool filled, double depth, Emphasis emphasis) {
    gizmo.shapes.push_back({handle, std::move(points), filled, axisOf(handle), emphasis, depth});
  }
  // Nothing when a part of it is behind the eye.
  void addPath(GizmoHandle handle, const std::vector<Vector>& path, bool filled,
               Emphasis emphasis = Emphasis::normal) {
    std::vector<Pixel> points;
    double depth = 0;
    for (const Vector& offset : path) {
      const auto pixel = at(offset);
      if (!pixel) return;
      points.push_back(*pixel);
      depth += glm::dot(offset, view) / double(path.size());
    }
    add(handle, std::move(points), filled, depth, emphasis);
  }
  bool endOn(int i) const { return glm::length(glm::cross(axis(i), view)) < endOnSine; }
  bool edgeOn(int normal) const { return std::abs(glm::dot(axis(normal), view)) < endOnSine; }
};

std::vector<Pixel> square(const Pixel& centre, double half) {
  return {centre + Pixel(-half, -half), centre + Pixel(half, -half), centre + Pixel(half, half),
          centre + Pixel(-half, half)};
}

std::vector<Pixel> circle(const Pixel& centre, double radius) {
  std::vector<Pixel> points;
  for (int i = 0; i <= 24; ++i) {
    const double angle = 2 * pi * i / 24;
    points.push_back(centre + radius * Pixel(std::cos(angle), std::sin(angle)));
  }
  return points;
}

// A triangle with its tip at `tip`.
std::vector<Pixel> arrowHead(const Pixel& from, const Pixel& tip, double size) {
  const double distance = glm::length(tip - from);
  const Pixel along = distance > 1e-9 ? (tip - from) / distance : Pixel(0, -1);
  const Pixel across(-along.y, along.x), base = tip - size * along;
  return {tip, base + 0.42 * size * across, base - 0.42 * size * across};
}

void addAxes(Maker& maker, bool arrows) {
  for (int i = 0; i < 3; ++i) {
    const auto end = maker.at(maker.axis(i));
    if (maker.endOn(i) || !end) continue;
    const GizmoHandle handle = axisHandles[i];
    const double depth = glm::dot(maker.axis(i), maker.view);
    maker.addPath(handle, {axisStart * maker.axis(i), maker.axis(i)}, false);
    if (arrows) {
      const double distance = std::max(glm::length(*end - maker.origin), 1e-9), size = maker.pixels(15);
      const Pixel tip = *end + (*end - maker.origin) * (0.6 * size / distance);
      maker.add(handle, arrowHead(maker.origin, tip, size), true, depth, Emphasis::normal);
    } else {
      maker.add(handle, square(*end, maker.pixels(5.5)), true, depth, Emphasis::normal);
    }
  }
}

void addPlanes(Maker& maker) {
  for (int i = 0; i < 3; ++i) {
    if (maker.edgeOn(i)) continue;
    const Direction &a = maker.axis((i + 1) % 3), &b = maker.axis((i + 2) % 3);
    maker.addPath(planeHandles[i],
                  {planeStart * (a + b), planeEnd * a + planeStart * b, planeEnd * (a + b),
                   planeStart * a + planeEnd * b},
                  true);
  }
}

// A ring of the plane spanned by a and b, cut where it passes behind the ball that the rings lie on.
void addRing(Maker& maker, GizmoHandle handle, const Direction& a, const Direction& b) {
  std::vector<Vector> path;
  bool dim = false;
  const auto flush = [&] {
    if (path.size() > 1) maker.addPath(handle, path, false, dim ? Emphasis::dim : Emphasis::normal);
  };
  for (int i = 0; i <= ringSegments; ++i) {
    const double angle = 2 * pi * i / ringSegments;
    const Vector point = std::cos(angle) * a + std::sin(angle) * b;
    const bool behind = glm::dot(point, maker.view) > 1e-6;  // seen from its axis nothing is behind
    path.push_back(point);
    if (i > 0 && behind != dim) {
      flush();
      path = {point};
    }
    dim = behind;
  }
  flush();
}

void addRings(Maker& maker) {
  for (int i = 0; i < 3; ++i)
    addRing(maker, axisHandles[i], maker.axis((i + 1) % 3), maker.axis((i + 2) % 3));
  const Direction a = perpendicular(maker.view);
  addRing(maker, GizmoHandle::all, viewRing * a, viewRing * glm::cross(maker.view, a));
}

double distanceToSegment(const Pixel& p, const Pixel& a, const Pixel& b) {
  const Pixel along = b - a;
  const double square = glm::dot(along, along);
  const double t = square > 0 ? std::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0;
  return glm::length(p - (a + t * along));
}

bool isInside(const std::vector<Pixel>& polygon, const Pixel& p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Pixel &a = polygon[i], &b = polygon[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) * (b.x - a.x) / (b.y - a.y)) inside = !inside;
  }
  return inside;
}

double distanceTo(const GizmoShape& shape, const Pixel& pixel) {
  if (shape.filled && isInside(shape.points, pixel)) return 0;
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < shape.points.size(); ++i) {
    distance = std::min(distance, distanceToSegment(pixel, shape.points[i - 1], shape.points[i]));
  }
  if (shape.filled)
    distance = std::min(distance, distanceToSegment(pixel, shape.points.back(), shape.points.front()));
  return distance;
}

}  // namespace

int axisOf(GizmoHandle handle) {
  switch (handle) {
    case GizmoHandle::x:
    case GizmoHandle::yz:
      return 0;
    case GizmoHandle::y:
    case GizmoHandle::zx:
      return 1;
    case GizmoHandle::z:
    case GizmoHandle::xy:
      return 2;
    case GizmoHandle::none:
    case GizmoHandle::all:
      break;
  }
  return 3;
}

Direction viewDirection(const ViewProjection& projection, const Point& point) {
  const Vector v = point - projection.eye();
  const double distance = glm::length(v);
  return projection.orthographic() || !(distance > 0) ? projection.frame().forward : v / distance;
}

Gizmo makeGizmo(const ViewProjection& projection, const GizmoFrame& frame, GizmoMode mode, double uiScale,
                bool uniformOnly) {
  const auto origin = projection.pixelOf(frame.origin);
  const double length = gizmoPixels * uiScale * projection.unitsPerPixel(frame.origin);
  if (!origin || !std::isfinite(origin->x) || !std::isfinite(origin->y) || !std::isfinite(length)) return {};
  Maker maker{projection, frame, {{}, uiScale}, viewDirection(projection, frame.origin), length, *origin};
  if (mode == GizmoMode::rotate) {
    addRings(maker);
  } else {
    const bool move = mode == GizmoMode::move;
    if (move || !uniformOnly) {
      addPlanes(maker);
      addAxes(maker, move);
    }
    if (move) {
      maker.add(GizmoHandle::all, circle(*origin, maker.pixels(9)), false, 0, Emphasis::normal);
    } else {
      maker.add(GizmoHandle::all, square(*origin, maker.pixels(uniformOnly ? 9 : 6)), true, 0,
                Emphasis::normal);
    }
  }
  std::stable_sort(maker.gizmo.shapes.begin(), maker.gizmo.shapes.end(),
                   [](const GizmoShape& a, const GizmoShape& b) { return a.depth > b.depth; });
  return std::move(maker.gizmo);
}

Gizmo restricted(Gizmo gizmo, int freedom) {
  const auto isFree = [&](GizmoHandle handle) {
    switch (handle) {
      case GizmoHandle::x:
        return freedom >= 1;
      case GizmoHandle::y:
      case GizmoHandle::xy:
        return freedom >= 2;
      default:
        return freedom >= 3;
    }
  };
  auto& shapes = gizmo.shapes;
  shapes.erase(std::remove_if(shapes.begin(), shapes.end(),
                              [&](const GizmoShape& shape) { return !isFree(shape.handle); }),
               shapes.end());
  return gizmo;
}

GizmoHandle pickHandle(const Gizmo& gizmo, const Pixel& pixel) {
  GizmoHandle picked = GizmoHandle::none;
  std::tuple<bool, double, double> best;
  for (const GizmoShape& shape : gizmo.shapes) {
    const double distance = distanceTo(shape, pixel);
    if (!(distance <= pickPixels * gizmo.uiScale)) continue;
    const std::tuple score(shape.emphasis == Emphasis::dim, distance, shape.depth);
    if (picked == GizmoHandle::none || score < best) {
      picked = shape.handle;
      best = score;
    }
  }
  return picked;
}

Gizmo emphasised(Gizmo gizmo, GizmoHandle handle) {
  for (GizmoShape& shape : gizmo.shapes) {
    if (shape.handle == handle) shape.emphasis = Emphasis::strong;
  }
  return gizmo;
}

}  // namespace anamorph
