// The walk through the tree. bvh_traverse.cpp includes this once for every instruction set that it supports,
// with ANAMORPH_TARGET (the attribute that chooses the set) and Lanes (eight floats) defined: a template cannot
// choose between attributes.

/// The walk ends at the first hit of all when any is wanted, else with the nearest one.
template <HitRule rule>
ANAMORPH_TARGET bool walk(const BvhData& bvh, const Ray& ray, BvhHit& hit, double tMin, double tMax) {
  const FloatRay r = makeFloatRay(ray, bvh.centre, bvh.radius);
  const ShearedRay sheared(ray, r);
  const Lanes originX = Lanes::splat(r.origin[0]), inverseX = Lanes::splat(r.inverse[0]);
  const Lanes originY = Lanes::splat(r.origin[1]), inverseY = Lanes::splat(r.inverse[1]);
  const Lanes originZ = Lanes::splat(r.origin[2]), inverseZ = Lanes::splat(r.inverse[2]);
  const Lanes begin = Lanes::splat(static_cast<float>(tMin - r.shift));
  float farthest = static_cast<float>(tMax - r.shift);
  Lanes end = Lanes::splat(farthest);

  bool found = false;
  Visit stack[stackSize];
  Visit* top = stack;
  std::uint32_t current = 0;
  for (;;) {
    if ((current & BvhWideNode::leaf) == 0) {
      const BvhWideNode& node = bvh.wideNodes[current];
      const Lanes nearX = (Lanes::load(node.bounds[0][r.nearSide[0]]) - originX) * inverseX;
      const Lanes nearY = (Lanes::load(node.bounds[1][r.nearSide[1]]) - originY) * inverseY;
      const Lanes nearZ = (Lanes::load(node.bounds[2][r.nearSide[2]]) - originZ) * inverseZ;
      const Lanes farX = (Lanes::load(node.bounds[0][1 - r.nearSide[0]]) - originX) * inverseX;
      const Lanes farY = (Lanes::load(node.bounds[1][1 - r.nearSide[1]]) - originY) * inverseY;
      const Lanes farZ = (Lanes::load(node.bounds[2][1 - r.nearSide[2]]) - originZ) * inverseZ;
      const Lanes enter = maximum(maximum(nearX, nearY), maximum(nearZ, begin));
      const Lanes leave = minimum(minimum(farX, farY), minimum(farZ, end));
      const unsigned children = lessEqualMask(enter, leave);
      if (children != 0) {
        alignas(32) float distances[BvhWideNode::width];
        enter.store(distances);
        current = chooseNearest(bvh, node, children, distances, top);
        continue;
      }
    } else if (testBlock<rule>(bvh, bvh.blocks[current ^ BvhWideNode::leaf], r, sheared, ray, hit, tMin, tMax)) {
      if constexpr (rule == HitRule::any) return true;
      found = true;
      farthest = static_cast<float>(tMax - r.shift);
      end = Lanes::splat(farthest);
    }
    do {
      if (top == stack) return found;
      --top;
    } while (top->distance > farthest);
    current = top->child;
  }
}
