#include "optics/cut_mesh.h"

#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace anamorph {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

// Numbers for pairs, in the order in which they come: a short list for every first number.
class PairNumbers {
 public:
  explicit PairNumbers(std::size_t firsts) : heads_(firsts, none) {}

  /// The pair's number, and whether it is new.
  std::pair<std::uint32_t, bool> add(std::uint32_t first, std::uint32_t second) {
    for (std::uint32_t i = heads_[first]; i != none; i = entries_[i].next) {
      if (entries_[i].second == second) return {i, false};
    }
    const auto number = static_cast<std::uint32_t>(entries_.size());
    entries_.push_back({second, std::exchange(heads_[first], number)});
    return {number, true};
  }

 private:
  struct Entry {
    std::uint32_t second, next;
  };
  std::vector<std::uint32_t> heads_;
  std::vector<Entry> entries_;
};

// One plane. A triangle is cut into at most two; corners and the new points on edges are shared, as they were.
class PlaneCut {
 public:
  PlaneCut(const SmoothMesh& surface, const HalfSpace& plane)
      : from_(surface), plane_(plane), kept_(surface.mesh.positions.size(), none), crossings_(kept_.size()) {}

  SmoothMesh cut() {
    for (const Triangle& triangle : from_.mesh.triangles) cut(triangle);
    return std::move(to_);
  }

 private:
  double side(std::uint32_t corner) const {
    return glm::dot(from_.mesh.positions[corner] - plane_.point, plane_.normal);
  }

  std::uint32_t add(const Point& point, const Vector& normal) {
    to_.mesh.positions.push_back(point);
    if (!from_.normals.empty()) to_.normals.push_back(normal);
    return static_cast<std::uint32_t>(to_.mesh.positions.size() - 1);
  }

  Vector normalOf(std::uint32_t corner) const {
    return from_.normals.empty() ? Vector(0) : from_.normals[corner];
  }

  std::uint32_t keep(std::uint32_t corner) {
    if (kept_[corner] == none) kept_[corner] = add(from_.mesh.positions[corner], normalOf(corner));
    return kept_[corner];
  }

  std::uint32_t between(std::uint32_t a, std::uint32_t b) {
    if (a > b) std::swap(a, b);
    const auto [number, isNew] = crossings_.add(a, b);
    if (isNew) {
      const double share = side(a) / (side(a) - side(b));
      const Vector normal = glm::mix(normalOf(a), normalOf(b), share);
      const double length = glm::length(normal);
      points_.push_back(add(glm::mix(from_.mesh.positions[a], from_.mesh.positions[b], share),
                            length > 0 ? normal / length : normal));
    }
    return points_[number];
  }

  void cut(const Triangle& triangle) {
    std::array<std::uint32_t, 4> polygon;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
      const bool aIn = side(a) >= 0, bIn = side(b) >= 0;
      if (aIn) polygon[count++] = keep(a);
      if (aIn != bIn) polygon[count++] = between(a, b);
    }
    if (count >= 3) to_.mesh.triangles.push_back({polygon[0], polygon[1], polygon[2]});
    if (count == 4) to_.mesh.triangles.push_back({polygon[0], polygon[2], polygon[3]});
  }

  const SmoothMesh& from_;
  const HalfSpace& plane_;
  SmoothMesh to_;
  std::vector<std::uint32_t> kept_;
  PairNumbers crossings_;
  std::vector<std::uint32_t> points_;  // of the crossings
};

// One normal for each corner, so that a corner is one number.
SmoothMesh withOwnCorners(const SmoothMesh& surface) {
  if (surface.corners.empty()) return surface;
  SmoothMesh own;
  PairNumbers numbers(surface.mesh.positions.size());
  for (std::size_t t = 0; t < surface.mesh.triangles.size(); ++t) {
    Triangle triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t position = surface.mesh.triangles[t][i], normal = surface.corners[t][i];
      const auto [number, isNew] = numbers.add(position, normal);
      if (isNew) {
        own.mesh.positions.push_back(surface.mesh.positions[position]);
        own.normals.push_back(surface.normals[normal]);
      }
      triangle[i] = number;
    }
    own.mesh.triangles.push_back(triangle);
  }
  return own;
}

}  // namespace

SmoothMesh cutMesh(const SmoothMesh& surface, const std::vector<HalfSpace>& planes) {
  SmoothMesh result = withOwnCorners(surface);
  for (const HalfSpace& plane : planes) result = PlaneCut(result, plane).cut();
  return result;
}

}  // namespace anamorph
