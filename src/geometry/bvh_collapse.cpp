#include <algorithm>
#include <array>

#include "geometry/bvh_build.h"

namespace anamorph {
namespace {

float halfArea(const BvhNode& node) {
  const float x = node.max[0] - node.min[0], y = node.max[1] - node.min[1], z = node.max[2] - node.min[2];
  return x * y + y * z + z * x;
}

/// Up to eight descendants of a node that together cover it: the largest is opened as long as there is room.
struct Family {
  std::array<std::uint32_t, BvhWideNode::width> members{};
  int count = 0;
};

Family openNode(const std::vector<BvhNode>& nodes, std::uint32_t root) {
  Family family{{root}, 1};
  while (family.count < BvhWideNode::width) {
    int largest = -1;
    for (int i = 0; i < family.count; ++i) {
      const BvhNode& node = nodes[family.members[i]];
      if (node.count > 0) continue;
      if (largest < 0 || halfArea(node) > halfArea(nodes[family.members[largest]])) largest = i;
    }
    if (largest < 0) break;
    const std::uint32_t left = nodes[family.members[largest]].link;
    family.members[largest] = left;
    family.members[family.count++] = left + 1;
  }
  return family;
}

BvhWideNode makeEmptyNode() {
  BvhWideNode node{};
  std::fill(std::begin(node.source), std::end(node.source), BvhWideNode::noSource);
  return node;
}

std::uint32_t collapse(const std::vector<BvhNode>& nodes, std::uint32_t root, BvhWideTree& tree) {
  const auto self = static_cast<std::uint32_t>(tree.nodes.size());
  tree.nodes.push_back(makeEmptyNode());
  const Family family = openNode(nodes, root);
  for (int i = 0; i < family.count; ++i) {
    const std::uint32_t member = family.members[i];
    std::uint32_t child = 0;
    if (nodes[member].count > 0) {
      child = BvhWideNode::leaf | static_cast<std::uint32_t>(tree.leaves.size());
      tree.leaves.push_back(member);
    } else {
      child = collapse(nodes, member, tree);
    }
    tree.nodes[self].child[i] = child;
    tree.nodes[self].source[i] = member;
  }
  return self;
}

}  // namespace

BvhWideTree collapseTree(const std::vector<BvhNode>& nodes) {
  BvhWideTree tree;
  tree.nodes.reserve(nodes.size() / 4);
  tree.leaves.reserve(nodes.size() / 2 + 1);
  collapse(nodes, 0, tree);
  return tree;
}

}  // namespace anamorph
