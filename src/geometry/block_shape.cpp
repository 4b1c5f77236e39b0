#include "geometry/block_shape.h"

#include <cstdint>
#include <unordered_map>
#include <utility>

#include "base/check.h"

namespace anamorph {
namespace {

using Cell = std::array<int, 3>;  // a block, or a vertex of the grid that is `segments` times as fine

class BlockShape {
 public:
  BlockShape(const std::array<std::vector<double>, 3>& planes, int segments)
      : planes_(planes), segments_(segments) {}

  // The face of the block on its lower (side 0) or upper (side 1) end of the axis.
  void addFace(const Cell& block, int axis, int side) {
    const int right = (axis + 1) % 3, up = (axis + 2) % 3;
    for (int i = 0; i < segments_; ++i) {
      for (int j = 0; j < segments_; ++j) {
        Cell corner{block[0] * segments_, block[1] * segments_, block[2] * segments_};
        corner[axis] += side * segments_;
        corner[right] += i;
        corner[up] += j;
        addQuad(corner, side == 1 ? right : up, side == 1 ? up : right);
      }
    }
  }

  Mesh mesh;

 private:
  // Counter-clockwise seen from where `right` x `up` points to.
  void addQuad(const Cell& corner, int right, int up) {
    Cell b = corner, c = corner, d = corner;
    ++b[right];
    ++c[right], ++c[up];
    ++d[up];
    const std::uint32_t first = vertex(corner), third = vertex(c);
    mesh.triangles.push_back({first, vertex(b), third});
    mesh.triangles.push_back({first, third, vertex(d)});
  }

  std::uint32_t vertex(const Cell& at) {
    std::uint64_t key = 0;
    for (const int coordinate : at) key = key << 21 | static_cast<std::uint64_t>(coordinate);
    const auto [entry, isNew] = vertices_.try_emplace(key, static_cast<std::uint32_t>(mesh.positions.size()));
    if (isNew) mesh.positions.push_back({place(0, at[0]), place(1, at[1]), place(2, at[2])});
    return entry->second;
  }

  // Weighted from both ends, so that mirrored blocks get exactly mirrored vertices.
  double place(int axis, int fine) const {
    const auto block = static_cast<std::size_t>(fine / segments_);
    const int step = fine % segments_;
    if (step == 0) return planes_[axis][block];
    return (planes_[axis][block] * (segments_ - step) + planes_[axis][block + 1] * step) / segments_;
  }

  const std::array<std::vector<double>, 3>& planes_;
  int segments_;
  std::unordered_map<std::uint64_t, std::uint32_t> vertices_;
};

}  // namespace

Mesh makeBlockShape(const std::array<std::vector<double>, 3>& planes,
                    const std::function<bool(const std::array<int, 3>&)>& isSolid, int segments) {
  CHECK(segments >= 1);
  Cell blocks;
  for (int axis = 0; axis < 3; ++axis) {
    blocks[axis] = static_cast<int>(planes[axis].size()) - 1;
    CHECK(blocks[axis] >= 1 &&
          std::int64_t{blocks[axis]} * segments < 1 << 21);  // what vertex() can tell apart
  }
  BlockShape shape(planes, segments);
  const auto isInside = [&](const Cell& block) {
    for (int axis = 0; axis < 3; ++axis) {
      if (block[axis] < 0 || block[axis] >= blocks[axis]) return false;
    }
    return isSolid(block);
  };
  for (Cell block{}; block[2] < blocks[2]; ++block[2]) {
    for (block[1] = 0; block[1] < blocks[1]; ++block[1]) {
      for (block[0] = 0; block[0] < blocks[0]; ++block[0]) {
        if (!isInside(block)) continue;
        for (int axis = 0; axis < 3; ++axis) {
          for (int side = 0; side < 2; ++side) {
            Cell neighbour = block;
            neighbour[axis] += side == 1 ? 1 : -1;
            if (!isInside(neighbour)) shape.addFace(block, axis, side);
          }
        }
      }
    }
  }
  return std::move(shape.mesh);
}

}  // namespace anamorph
