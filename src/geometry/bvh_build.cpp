#include "geometry/bvh_build.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "base/parallel_for.h"
#include "geometry/bvh_simd.h"

namespace anamorph {
namespace {

constexpr int binCount = 16;
// Subtrees of this size are built as one task each.
constexpr std::uint32_t taskSize = 4096;

/// The three coordinates that begin at `from`; the fourth lane is 0, for what lies there is no number.
Float4 loadPoint(const float* from) {
  Float4 p = load(from);
  p[3] = 0;
  return p;
}

struct FloatBox {
  Float4 min = broadcast(std::numeric_limits<float>::infinity());
  Float4 max = broadcast(-std::numeric_limits<float>::infinity());

  void extend(Float4 lower, Float4 upper) {
    min = minimum(min, lower);
    max = maximum(max, upper);
  }
  float halfArea() const {
    const Float4 size = max - min;
    return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  }
};

/// Primitives [first, first + count) and what is known of them.
struct Range {
  std::uint32_t first = 0, count = 0;
  FloatBox box, centroids;  // centroids are doubled: min + max
};

Range measure(const BvhPrimitive* primitives, std::uint32_t first, std::uint32_t count) {
  Range range{first, count, {}, {}};
  for (const BvhPrimitive* p = primitives + first; p != primitives + first + count; ++p) {
    const Float4 lower = loadPoint(p->min), upper = loadPoint(p->max);
    range.box.extend(lower, upper);
    range.centroids.extend(lower + upper, lower + upper);
  }
  return range;
}

/// Maps doubled centroids to bins, for all three axes at once.
class Binning {
 public:
  explicit Binning(const FloatBox& centroids) : origin_(centroids.min) {
    const Float4 extent = centroids.max - centroids.min;
    // Slightly less than binCount, so that the largest centroid falls into the last bin.
    for (int axis = 0; axis < 3; ++axis) {
      scale_[axis] = extent[axis] > 0 ? static_cast<float>(binCount) * 0.99999f / extent[axis] : 0;
    }
  }
  Int4 operator()(const BvhPrimitive& p) const {
    const Int4 bin = __builtin_convertvector((loadPoint(p.min) + loadPoint(p.max) - origin_) * scale_, Int4);
    const Int4 none{}, last = none + (binCount - 1);
    const Int4 atLeast = bin > none ? bin : none;
    return atLeast < last ? atLeast : last;
  }
  bool canSplit(int axis) const { return scale_[axis] > 0; }

 private:
  Float4 origin_;
  Float4 scale_{};
};

struct Bin {
  FloatBox box;
  std::uint32_t count = 0;
};
using Bins = std::array<std::array<Bin, binCount>, 3>;

struct Split {
  float cost = std::numeric_limits<float>::infinity();
  int axis = -1;
  int bin = 0;  // the first bin of the right side
};

/// A leaf costs one test however full it is.
float costOf(const Bin& side) {
  return side.box.halfArea() * static_cast<float>((side.count + bvhLeafSize - 1) / bvhLeafSize);
}

void add(Bin& sum, const Bin& bin) {
  sum.box.extend(bin.box.min, bin.box.max);
  sum.count += bin.count;
}

void findBestSplit(const std::array<Bin, binCount>& bins, int axis, Split& best) {
  std::array<float, binCount> rightCost;
  Bin right, left;
  for (int i = binCount - 1; i > 0; --i) {
    add(right, bins[i]);
    rightCost[i] = right.count > 0 ? costOf(right) : std::numeric_limits<float>::infinity();
  }
  for (int i = 1; i < binCount; ++i) {
    add(left, bins[i - 1]);
    if (left.count == 0) continue;
    const float cost = costOf(left) + rightCost[i];
    if (cost < best.cost) best = {cost, axis, i};
  }
}

class Builder {
 public:
  Builder(std::vector<BvhPrimitive>& primitives, int maxDepth)
      : primitives_(primitives.data()), maxDepth_(maxDepth) {}

  /// Splits the range and returns where its right part begins.
  std::uint32_t split(const Range& range, int depth) const;

  /// Appends the tree over the range below nodes[root], which exists.
  void buildBelow(std::vector<BvhNode>& nodes, std::uint32_t root, const Range& range, int depth) const;

  Range measure(std::uint32_t first, std::uint32_t count) const {
    return anamorph::measure(primitives_, first, count);
  }

 private:
  std::uint32_t halve(const Range& range) const;

  BvhPrimitive* primitives_;
  int maxDepth_;
};

BvhNode makeLeaf(const Range& range) {
  const FloatBox& box = range.box;
  return {
      {box.min[0], box.min[1], box.min[2]}, range.first, {box.max[0], box.max[1], box.max[2]}, range.count};
}

BvhNode makeInner(const Range& range, std::size_t left) {
  BvhNode node = makeLeaf(range);
  node.link = static_cast<std::uint32_t>(left);
  node.count = 0;
  return node;
}

/// How deep the tree over `count` primitives is when every split halves.
int halvingDepth(std::uint32_t count) {
  return std::bit_width((count - 1) / bvhLeafSize);
}

std::uint32_t Builder::halve(const Range& range) const {
  const Float4 extent = range.centroids.max - range.centroids.min;
  const int axis = extent[0] >= extent[1] && extent[0] >= extent[2] ? 0 : extent[1] >= extent[2] ? 1 : 2;
  const std::uint32_t half = range.count / 2;
  BvhPrimitive* begin = primitives_ + range.first;
  std::nth_element(begin, begin + half, begin + range.count,
                   [axis](const BvhPrimitive& a, const BvhPrimitive& b) {
                     const float x = a.min[axis] + a.max[axis], y = b.min[axis] + b.max[axis];
                     return x != y ? x < y : a.triangle < b.triangle;
                   });
  return range.first + half;
}

std::uint32_t Builder::split(const Range& range, int depth) const {
  if (depth + 1 + halvingDepth(range.count) > maxDepth_) return halve(range);
  const Binning binning(range.centroids);
  BvhPrimitive* begin = primitives_ + range.first;
  BvhPrimitive* end = begin + range.count;
  Bins bins{};
  for (const BvhPrimitive* p = begin; p != end; ++p) {
    const Float4 lower = loadPoint(p->min), upper = loadPoint(p->max);
    const Int4 bin = binning(*p);
    for (int axis = 0; axis < 3; ++axis) {
      Bin& b = bins[axis][bin[axis]];
      b.box.extend(lower, upper);
      ++b.count;
    }
  }
  Split best;
  for (int axis = 0; axis < 3; ++axis) {
    if (binning.canSplit(axis)) findBestSplit(bins[axis], axis, best);
  }
  if (best.axis < 0) return halve(range);
  BvhPrimitive* middle =
      std::partition(begin, end, [&](const BvhPrimitive& p) { return binning(p)[best.axis] < best.bin; });
  return static_cast<std::uint32_t>(middle - primitives_);
}

void Builder::buildBelow(std::vector<BvhNode>& nodes, std::uint32_t root, const Range& range,
                         int depth) const {
  if (range.count <= bvhLeafSize) {
    nodes[root] = makeLeaf(range);
    return;
  }
  const std::uint32_t middle = split(range, depth);
  const auto left = static_cast<std::uint32_t>(nodes.size());
  nodes[root] = makeInner(range, left);
  nodes.resize(nodes.size() + 2);
  buildBelow(nodes, left, measure(range.first, middle - range.first), depth + 1);
  buildBelow(nodes, left + 1, measure(middle, range.first + range.count - middle), depth + 1);
}

struct Task {
  std::uint32_t root;  // the node whose subtree is missing
  Range range;
  int depth;
  std::vector<BvhNode> nodes;  // the subtree; nodes[0] takes the place of `root`
};

/// Splits until every part is small enough for a task.
std::vector<Task> buildTop(const Builder& builder, std::vector<BvhNode>& nodes, std::uint32_t count) {
  std::vector<Task> open, tasks;
  nodes.resize(1);
  open.push_back({0, builder.measure(0, count), 0, {}});
  while (!open.empty()) {
    const Task task = std::move(open.back());
    open.pop_back();
    const Range& range = task.range;
    if (range.count <= taskSize) {
      tasks.push_back(task);
      continue;
    }
    const std::uint32_t middle = builder.split(range, task.depth);
    const auto left = static_cast<std::uint32_t>(nodes.size());
    nodes[task.root] = makeInner(range, left);
    nodes.resize(nodes.size() + 2);
    open.push_back(
        {left + 1, builder.measure(middle, range.first + range.count - middle), task.depth + 1, {}});
    open.push_back({left, builder.measure(range.first, middle - range.first), task.depth + 1, {}});
  }
  return tasks;
}

/// Appends a finished subtree: its node i > 0 becomes node i + shift.
void append(std::vector<BvhNode>& nodes, const Task& task) {
  const auto shift = static_cast<std::uint32_t>(nodes.size()) - 1;
  const auto moved = [shift](BvhNode node) {
    if (node.count == 0) node.link += shift;
    return node;
  };
  nodes[task.root] = moved(task.nodes[0]);
  for (std::size_t i = 1; i < task.nodes.size(); ++i) nodes.push_back(moved(task.nodes[i]));
}

}  // namespace

std::vector<BvhNode> buildBinaryTree(std::vector<BvhPrimitive>& primitives, int threads, int maxDepth) {
  const Builder builder(primitives, maxDepth);
  std::vector<BvhNode> nodes;
  nodes.reserve(primitives.size());
  std::vector<Task> tasks = buildTop(builder, nodes, static_cast<std::uint32_t>(primitives.size()));
  parallelFor(tasks.size(), 1, threads, [&](std::size_t begin, std::size_t end) {
    for (Task* task = &tasks[begin]; task != tasks.data() + end; ++task) {
      task->nodes.reserve(task->range.count);
      task->nodes.resize(1);
      builder.buildBelow(task->nodes, 0, task->range, task->depth);
    }
  });
  for (const Task& task : tasks) append(nodes, task);
  return nodes;
}

}  // namespace anamorph
