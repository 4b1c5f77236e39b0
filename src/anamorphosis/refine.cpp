#include "anamorphosis/refine.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <utility>

#include "anamorphosis/edge_error.h"
#include "anamorphosis/edge_table.h"
#include "base/parallel_for.h"

namespace anamorph {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
// An edge may use this part of the tolerance: inside a triangle the errors of its edges add up, and along a
// silhouette on a convex mirror they all bend the same way, so none cancels in the picture.
constexpr double edgePart = 0.4;
constexpr double blindStepPixels = 16;  // a mirror smaller than this may be overlooked
constexpr int maxRounds = 24;           // 2^24 pieces of one edge: more than any image has pixels

struct Barycentrics {
  double u = 0, v = 0;
};
using CornerBarycentrics = std::array<Barycentrics, 3>;

Barycentrics midway(const Barycentrics& a, const Barycentrics& b) {
  return {(a.u + b.u) / 2, (a.v + b.v) / 2};
}

class Refiner {
 public:
  Refiner(const Mesh& welded, const DeformInput& input, int threads)
      : input_(input), projection_(input.camera, input.imageSize, input.imageSize), threads_(threads) {
    state_.original = welded.positions;
    state_.triangles = welded.triangles;
    state_.sourceTriangle.resize(welded.triangles.size());
    std::iota(state_.sourceTriangle.begin(), state_.sourceTriangle.end(), 0u);
    corners_.assign(welded.triangles.size(), {Barycentrics{0, 0}, Barycentrics{1, 0}, Barycentrics{0, 1}});
    state_.source.resize(welded.positions.size());
    for (std::uint32_t t = 0; t < welded.triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        state_.source[welded.triangles[t][i]] = {t, corners_[t][i].u, corners_[t][i].v};
      }
    }
    mapPointsThrough(input.map, state_.original, state_.mapped, threads);
    active_ = state_.sourceTriangle;
  }

  Refinement run(const Progress& progress) {
    for (int round = 0; round < maxRounds && !active_.empty() && !state_.budgetHit; ++round) {
      if (!progress.update(1 - 1.0 / (round + 1))) return {};
      const EdgeTable edges = makeEdgeTable(state_.triangles, active_);
      std::vector<double> errors = judge(edges);
      wakeBlindTriangles(edges, errors);
      splitTriangles(edges, addMidpoints(edges, chooseSplits(errors)));
    }
    if (state_.budgetHit) state_.remainingErrorPixels = largestError();
    return std::move(state_);
  }

 private:
  EdgeEnd end(std::uint32_t vertex) const {
    return {state_.original[vertex], state_.mapped.points[vertex], state_.mapped.status[vertex]};
  }
  bool mapped(std::uint32_t vertex) const { return state_.mapped.status[vertex] == PathStatus::mapped; }
  MappedPoint map(const Point& p) const { return mapPoint(input_.map, p); }

  // Of the edges that come into the sculpture.
  double largestError() const {
    std::vector<std::uint32_t> all(state_.triangles.size());
    std::iota(all.begin(), all.end(), 0u);
    const EdgeTable edges = makeEdgeTable(state_.triangles, all);
    const std::vector<double> errors = judge(edges);
    double largest = 0;
    for (std::size_t i = 0; i < errors.size(); ++i) {
      if (mapped(edges.ends[i][0]) && mapped(edges.ends[i][1])) largest = std::max(largest, errors[i]);
    }
    return largest;
  }

  std::vector<double> judge(const EdgeTable& edges) const {
    std::vector<double> errors(edges.ends.size());
    const EdgeJudge judge{input_.map, projection_};
    parallelFor(errors.size(), 256, threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        errors[i] = edgeErrorPixels(judge, end(edges.ends[i][0]), end(edges.ends[i][1]));
      }
    });
    return errors;
  }

  // A triangle can have all its edges beside the mirror and the mirror in its middle. Then its edges are
  // split (other triangles of an edge with unmapped ends are left out anyway, so no crack can open).
  void wakeBlindTriangles(const EdgeTable& edges, std::vector<double>& errors) const {
    for (std::size_t i = 0; i < active_.size(); ++i) {
      const Triangle& t = state_.triangles[active_[i]];
      if (mapped(t[0]) || mapped(t[1]) || mapped(t[2])) continue;
      const double size = imageSize(t);
      if (size < 1 || !seesMirror(t, size)) continue;
      for (const std::uint32_t edge : edges.ofTriangle[i]) errors[edge] = std::max(errors[edge], size);
    }
  }

  // The longest edge in pixels, about.
  double imageSize(const Triangle& t) const {
    double size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point p = state_.original[t[i]], q = state_.original[t[(i + 1) % 3]];
      const double away = std::max(glm::length(p - projection_.eye()), std::numeric_limits<double>::min());
      size = std::max(size, glm::length(q - p) / away * projection_.pixelsPerTangent());
    }
    return size;
  }

  // Whether any point of a grid over the triangle, blindStepPixels apart, is mapped.
  bool seesMirror(const Triangle& t, double size) const {
    const int steps = static_cast<int>(std::clamp(size / blindStepPixels, 1.0, 64.0));
    const Point a = state_.original[t[0]];
    const Vector ab = state_.original[t[1]] - a, ac = state_.original[t[2]] - a;
    for (int u = 0; u < steps; ++u) {
      for (int v = 0; u + v < steps; ++v) {
        const Point p = a + ((u + 1.0 / 3) / steps) * ab + ((v + 1.0 / 3) / steps) * ac;
        if (map(p).status == PathStatus::mapped) return true;
      }
    }
    return false;
  }

  // 1 for every edge to split. Each split adds about two triangles, so the budget allows only so many; then
  // the worst are taken.
  std::vector<char> chooseSplits(const std::vector<double>& errors) {
    std::vector<std::uint32_t> wanted;
    for (std::uint32_t i = 0; i < errors.size(); ++i) {
      if (errors[i] > edgePart * input_.tolerancePixels) wanted.push_back(i);
    }
    const std::size_t room = input_.maxTriangles > state_.triangles.size()
                                 ? (input_.maxTriangles - state_.triangles.size()) / 2
                                 : 0;
    if (wanted.size() > room) {
      std::stable_sort(wanted.begin(), wanted.end(),
                       [&](std::uint32_t a, std::uint32_t b) { return errors[a] > errors[b]; });
      state_.budgetHit = true;
      wanted.resize(room);
    }
    std::vector<char> split(errors.size(), 0);
    for (const std::uint32_t edge : wanted) split[edge] = 1;
    return split;
  }

  // The new vertex of every edge that is split, else `none`.
  std::vector<std::uint32_t> addMidpoints(const EdgeTable& edges, const std::vector<char>& split) {
    std::vector<std::uint32_t> midpoint(edges.ends.size(), none);
    std::uint32_t next = static_cast<std::uint32_t>(state_.original.size());
    for (std::size_t i = 0; i < split.size(); ++i) {
      if (!split[i]) continue;
      midpoint[i] = next++;
      state_.original.push_back(0.5 *
                                (state_.original[edges.ends[i][0]] + state_.original[edges.ends[i][1]]));
    }
    state_.mapped.points.resize(next);
    state_.mapped.status.resize(next);
    state_.source.resize(next);
    parallelFor(midpoint.size(), 1024, threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        if (midpoint[i] == none) continue;
        const MappedPoint mapped = map(state_.original[midpoint[i]]);
        state_.mapped.points.set(midpoint[i], mapped.point);
        state_.mapped.status[midpoint[i]] = mapped.status;
      }
    });
    return midpoint;
  }

  void splitTriangles(const EdgeTable& edges, const std::vector<std::uint32_t>& midpoint) {
    const std::vector<std::uint32_t> active = std::move(active_);
    active_.clear();
    for (std::size_t i = 0; i < active.size(); ++i) {
      const auto& e = edges.ofTriangle[i];
      const std::array<std::uint32_t, 3> m{midpoint[e[0]], midpoint[e[1]], midpoint[e[2]]};
      const int splits = (m[0] != none) + (m[1] != none) + (m[2] != none);
      if (splits > 0) splitTriangle(active[i], m, splits);
    }
  }

  // m[i] is the midpoint between corners i and i + 1. Corners are turned so that the patterns below need no
  // cases.
  void splitTriangle(std::uint32_t triangle, const std::array<std::uint32_t, 3>& m, int splits) {
    std::size_t turn = 0;
    if (splits == 1) {
      while (m[turn] == none) ++turn;  // the split edge is the first
    } else if (splits == 2) {
      while (m[(turn + 2) % 3] != none) ++turn;  // the whole edge is the last
    }
    struct Corner {
      std::uint32_t vertex;
      Barycentrics at;
    };
    std::array<Corner, 3> c, h;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t from = (turn + i) % 3, to = (from + 1) % 3;
      c[i] = {state_.triangles[triangle][from], corners_[triangle][from]};
      h[i] = {m[from], midway(corners_[triangle][from], corners_[triangle][to])};
      if (m[from] != none) {
        state_.source[m[from]] = {state_.sourceTriangle[triangle], h[i].at.u, h[i].at.v};
      }
    }
    const std::uint32_t source = state_.sourceTriangle[triangle];
    bool first = true;
    const auto emit = [&](const Corner& p, const Corner& q, const Corner& r) {
      const Triangle t{p.vertex, q.vertex, r.vertex};
      const CornerBarycentrics at{p.at, q.at, r.at};
      std::uint32_t slot = triangle;  // the first piece takes the old one's place
      if (!std::exchange(first, false)) {
        slot = static_cast<std::uint32_t>(state_.triangles.size());
        state_.triangles.emplace_back();
        state_.sourceTriangle.push_back(source);
        corners_.emplace_back();
      }
      state_.triangles[slot] = t;
      corners_[slot] = at;
      active_.push_back(slot);
    };
    if (splits == 1) {
      emit(c[0], h[0], c[2]);
      emit(h[0], c[1], c[2]);
    } else if (splits == 2) {
      emit(h[0], c[1], h[1]);
      const bool firstDiagonal = distance(h[0].vertex, c[2].vertex) <= distance(c[0].vertex, h[1].vertex);
      if (firstDiagonal) {
        emit(c[0], h[0], c[2]);
        emit(h[0], h[1], c[2]);
      } else {
        emit(c[0], h[0], h[1]);
        emit(c[0], h[1], c[2]);
      }
    } else {
      emit(c[0], h[0], h[2]);
      emit(h[0], c[1], h[1]);
      emit(h[2], h[1], c[2]);
      emit(h[0], h[1], h[2]);
    }
  }

  double distance(std::uint32_t a, std::uint32_t b) const {
    return lengthSquared(state_.original[a] - state_.original[b]);
  }

  const DeformInput& input_;
  Projection projection_;
  int threads_;
  Refinement state_;
  std::vector<CornerBarycentrics> corners_;  // of every triangle, on its source: exact, they are dyadic
  std::vector<std::uint32_t> active_;        // triangles whose edges are not judged yet
};

}  // namespace

Refinement refine(const Mesh& welded, const DeformInput& input, int threads, const Progress& progress) {
  return Refiner(welded, input, threads).run(progress);
}

}  // namespace anamorph
