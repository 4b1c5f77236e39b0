#include "edit/depth_handle.h"

#include <gtest/gtest.h>

#include "edit/edit_levels.h"
#include "edit/gizmo_drag.h"
#include "pipeline/stages.h"

namespace anamorph {
namespace {

using namespace testing;

// S is dragged along its ray: it stays under the mouse, and k is what is said.
TEST(DepthHandle, KeepsTheSculptureUnderTheMouse) {
  int dragged = 0;
  for (const ShapeKind kind : allShapeKinds) {
    for (unsigned seed = 0; seed < 60; ++seed) {
      SCOPED_TRACE("mirror " + std::to_string(int(kind)) + ", seed " + std::to_string(seed));
      Random random(seed);
      Level level = makeRandomLevel(kind, random);
      level.sculpture.depthScale = random.uniform(0.3, 1.5);
      const Point original = level.original.placement.position;
      const VertexRay ray = makeVertexRay(makeVertexMap(level), original);
      const auto frame = depthFrame(ray);
      ASSERT_EQ(frame.has_value(), ray.mapped());
      if (!frame || ray.distance < 0.1) continue;
      // Seen from beside the ray.
      const ViewPose pose{ray.sculpture + 15.0 * frame->axes[1], ray.sculpture};
      const ViewProjection view(pose, 800, 600);
      const Gizmo gizmo = makeDepthHandle(view, *frame, ray.sculpture, 1);
      ASSERT_EQ(pickHandle(gizmo, *view.pixelOf(ray.sculpture)), GizmoHandle::x);
      const double wanted = level.sculpture.depthScale * random.uniform(0.7, 1.3);
      VertexMap map = makeVertexMap(level);
      map.depthScale = wanted;
      const VertexRay there = makeVertexRay(map, original);
      if (!there.mapped()) continue;
      GizmoDrag drag({level,
                      {Part::sculpture},
                      *frame,
                      GizmoMode::scale,
                      GizmoHandle::x,
                      view,
                      *view.pixelOf(ray.sculpture),
                      1});
      const Level after = drag.levelAt(*view.pixelOf(there.sculpture));
      EXPECT_NEAR(after.sculpture.depthScale, wanted, 1e-6 * wanted);
      EXPECT_EQ(drag.text(), fmt::format("k = {:.2f}", after.sculpture.depthScale));
      const Level snapped = drag.levelAt(*view.pixelOf(there.sculpture), {true, false, {}});
      const double steps = snapped.sculpture.depthScale / 0.05;
      EXPECT_NEAR(steps, std::round(steps), 1e-6);
      ++dragged;
    }
  }
  EXPECT_GT(dragged, 100);
}

TEST(DepthHandle, IsNotThereWhereNothingIsMapped) {
  VertexRay ray;
  EXPECT_FALSE(depthFrame(ray));
}

}  // namespace
}  // namespace anamorph
