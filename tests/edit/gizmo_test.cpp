#include "edit/gizmo.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "random_scene.h"

namespace anamorph {
namespace {

using testing::Random;
using Emphasis = GizmoShape::Emphasis;

constexpr GizmoMode everyMode[] = {GizmoMode::move, GizmoMode::rotate, GizmoMode::scale};

ViewProjection projectionOf(const ViewPose& pose) {
  return {pose, 800, 600};
}

const ViewPose oblique{{8, -10, 7}, {0, 0, 0}};

std::set<GizmoHandle> handlesOf(const Gizmo& gizmo) {
  std::set<GizmoHandle> handles;
  for (const GizmoShape& shape : gizmo.shapes) handles.insert(shape.handle);
  return handles;
}

double extentOf(const Gizmo& gizmo, const Pixel& centre) {
  double extent = 0;
  for (const GizmoShape& shape : gizmo.shapes) {
    for (const Pixel& p : shape.points) extent = std::max(extent, glm::length(p - centre));
  }
  return extent;
}

TEST(Gizmo, HasAllHandlesSeenObliquely) {
  using enum GizmoHandle;
  const ViewProjection projection = projectionOf(oblique);
  for (const GizmoMode mode : {GizmoMode::move, GizmoMode::scale}) {
    EXPECT_EQ(handlesOf(makeGizmo(projection, {}, mode, 1)), (std::set{x, y, z, yz, zx, xy, all}));
  }
  EXPECT_EQ(handlesOf(makeGizmo(projection, {}, GizmoMode::rotate, 1)), (std::set{x, y, z, all}));
  EXPECT_EQ(handlesOf(makeGizmo(projection, {}, GizmoMode::scale, 1, true)), std::set{all});
}

TEST(Gizmo, LeavesOutWhatIsSeenEndOnOrEdgeOn) {
  using enum GizmoHandle;
  const ViewProjection front = projectionOf({{0, -10, 0}, {0, 0, 0}});
  EXPECT_EQ(handlesOf(makeGizmo(front, {}, GizmoMode::move, 1)), (std::set{x, z, zx, all}));
}

TEST(Gizmo, HasTheSameSizeEverywhere) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    ViewPose pose{random.point(20), random.point(3)};
    pose.orthographic = random.integer(0, 1);
    const ViewProjection projection = projectionOf(pose);
    GizmoFrame frame;
    frame.origin = projection.rayThrough({400, 300}).at(random.uniform(1, 100));
    const double uiScale = random.uniform(0.75, 3);
    const Gizmo rings = makeGizmo(projection, frame, GizmoMode::rotate, uiScale);
    // In perspective the near side of a ball looks a little larger.
    EXPECT_NEAR(extentOf(rings, {400, 300}) / uiScale, 1.16 * gizmoPixels, 0.16 * gizmoPixels);
  }
}

TEST(Gizmo, TheHalfOfARingBehindIsDim) {
  const ViewProjection projection = projectionOf(oblique);
  const Gizmo gizmo = makeGizmo(projection, {}, GizmoMode::rotate, 1);
  for (const GizmoHandle ring : {GizmoHandle::x, GizmoHandle::y, GizmoHandle::z}) {
    std::size_t dim = 0, bright = 0;
    for (const GizmoShape& shape : gizmo.shapes) {
      if (shape.handle != ring) continue;
      (shape.emphasis == Emphasis::dim ? dim : bright) += shape.points.size() - 1;
      if (shape.emphasis == Emphasis::dim) {
        EXPECT_GT(shape.depth, 0);
      }
    }
    EXPECT_EQ(dim + bright, 72u);
    EXPECT_NEAR(double(dim), 36, 2);
  }
  for (const GizmoShape& shape : gizmo.shapes) {
    if (shape.handle == GizmoHandle::all) {
      EXPECT_EQ(shape.emphasis, Emphasis::normal);
    }
  }
}

TEST(PickHandle, FindsEveryHandleWhereItIsDrawn) {
  const ViewProjection projection = projectionOf(oblique);
  for (const GizmoMode mode : everyMode) {
    for (const double uiScale : {0.75, 1.0, 2.0}) {
      const Gizmo gizmo = makeGizmo(projection, {}, mode, uiScale);
      std::set<GizmoHandle> found;
      for (const GizmoShape& shape : gizmo.shapes) {
        Pixel middle(0);
        for (const Pixel& p : shape.points) middle += p / double(shape.points.size());
        found.insert(pickHandle(gizmo, shape.filled ? middle : shape.points[shape.points.size() / 2]));
      }
      EXPECT_EQ(found, handlesOf(gizmo)) << int(mode);
      EXPECT_EQ(pickHandle(gizmo, {5, 5}), GizmoHandle::none);
    }
  }
}

TEST(PickHandle, HasATolerance) {
  const ViewProjection front = projectionOf({{0, -10, 0}, {0, 0, 0}});
  const Gizmo gizmo = makeGizmo(front, {}, GizmoMode::move, 1);
  EXPECT_EQ(pickHandle(gizmo, {400 + 60, 300 + 6}), GizmoHandle::x);
  EXPECT_EQ(pickHandle(gizmo, {400 + 60, 300 + 8}), GizmoHandle::none);
  const Gizmo large = makeGizmo(front, {}, GizmoMode::move, 2);
  EXPECT_EQ(pickHandle(large, {400 + 120, 300 + 12}), GizmoHandle::x);
}

TEST(PickHandle, PartsInFrontWin) {
  const ViewProjection projection = projectionOf(oblique);
  const Gizmo gizmo = makeGizmo(projection, {}, GizmoMode::rotate, 1);
  for (const GizmoShape& shape : gizmo.shapes) {
    if (shape.emphasis == Emphasis::dim) continue;
    for (const Pixel& p : shape.points) {
      const GizmoHandle picked = pickHandle(gizmo, p);
      bool bright = false;  // some bright part of the picked ring passes here
      for (const GizmoShape& other : gizmo.shapes) {
        if (other.handle != picked || other.emphasis == Emphasis::dim) continue;
        for (const Pixel& q : other.points) bright |= glm::length(p - q) < 12;
      }
      EXPECT_TRUE(bright);
    }
  }
}

TEST(Emphasised, IsOneHandle) {
  const Gizmo gizmo = emphasised(makeGizmo(projectionOf(oblique), {}, GizmoMode::move, 1), GizmoHandle::y);
  for (const GizmoShape& shape : gizmo.shapes) {
    EXPECT_EQ(shape.emphasis == Emphasis::strong, shape.handle == GizmoHandle::y);
  }
}

TEST(Gizmo, AbsurdViewsDoNoHarm) {
  GizmoFrame behind, far, broken;
  behind.origin = {0, -100, 0};
  far.origin = {1e6, 1e6, 1e6};
  broken.origin = Point(std::numeric_limits<double>::quiet_NaN());
  ViewPose wide{{0, -10, 0}, {0, 0, 0}};
  wide.fovDegrees = 170;
  for (const GizmoMode mode : everyMode) {
    EXPECT_TRUE(makeGizmo(projectionOf({{0, -10, 0}, {0, 0, 0}}), behind, mode, 1).empty());
    EXPECT_TRUE(makeGizmo(projectionOf(oblique), broken, mode, 1).empty());
    for (const GizmoFrame& frame : {GizmoFrame{}, far}) {
      for (const ViewPose& pose : {wide, oblique, ViewPose{{0, 0, 0}, {0, 0, 0}}}) {
        const Gizmo gizmo = makeGizmo(projectionOf(pose), frame, mode, 1);
        for (const GizmoShape& shape : gizmo.shapes) {
          for (const Pixel& p : shape.points) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
        }
        pickHandle(gizmo, {400, 300});
      }
    }
  }
}

}  // namespace
}  // namespace anamorph
