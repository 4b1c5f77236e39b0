// Control points of spline mirrors: where they are, what moving one does, and another number of them.

#include "edit/control_points.h"

#include <gtest/gtest.h>

#include "edit/level_edits.h"
#include "edit/pick.h"
#include "edit/session.h"
#include "optics/extrusion.h"
#include "optics/patch.h"
#include "optics/revolution.h"
#include "random_scene.h"

namespace anamorph {
namespace {

Level levelWith(Shape mirror) {
  Level level;
  level.optic.shape() = std::move(mirror);
  return level;
}

const std::vector<Shape> splines{PatchMirror{}, RevolutionMirror{}, ExtrusionMirror{}};

TEST(ControlPoints, AreOfSplinesOnly) {
  EXPECT_TRUE(controlPointsOf(SphereMirror{}).empty());
  EXPECT_EQ(controlPointsOf(PatchMirror{}).size(), 36u);
  EXPECT_EQ(controlPointsOf(RevolutionMirror{}).size(), RevolutionMirror{}.radii.size());
  EXPECT_EQ(controlPointsOf(ExtrusionMirror{}).size(), ExtrusionMirror{}.points.size());
}

// Moved by any vector, a point goes as far as its free axes let it, and no other moves.
TEST(ControlPoints, MoveAloneAndAlongTheirAxes) {
  for (const Shape& mirror : splines) {
    const Level level = levelWith(mirror);
    for (unsigned seed = 0; seed < 40; ++seed) {
      SCOPED_TRACE(std::string(shapeName(mirror)) + " seed " + std::to_string(seed));
      testing::Random random(seed);
      const auto before = controlPointsOf(mirror);
      const int number = random.integer(0, static_cast<int>(before.size()) - 1);
      const ControlPoint& control = before[static_cast<std::size_t>(number)];
      const Vector motion = random.point(0.2);
      const Level after = moved(level, {Part::controlPoint, number}, motion);
      const auto now = controlPointsOf(after.optic.shape());
      Point expected = control.at;
      for (int i = 0; i < control.freedom; ++i) {
        const Direction& axis = control.axes[static_cast<std::size_t>(i)];
        expected += glm::dot(motion, axis) * axis;
      }
      for (std::size_t i = 0; i < now.size(); ++i) {
        const Point& wanted = static_cast<int>(i) == number ? expected : before[i].at;
        EXPECT_LT(glm::length(now[i].at - wanted), 1e-12) << i;
      }
    }
  }
}

TEST(ControlPoints, OfARadiusStayAboveNothing) {
  const Level level = levelWith(RevolutionMirror{});
  const auto control = controlPointsOf(level.optic.shape())[3];
  const Level after = moved(level, {Part::controlPoint, 3}, -1000.0 * control.axes[0]);
  EXPECT_GT(after.optic.shape().as<RevolutionMirror>()->radii[3], 0);
}

TEST(ControlPoints, AreMovedOnlyAndUndone) {
  Session session;
  session.startNew(levelWith(PatchMirror{}));
  const Selection selection{Part::controlPoint, 14};
  EXPECT_TRUE(allows(session.level(), selection, GizmoMode::move));
  EXPECT_FALSE(allows(session.level(), selection, GizmoMode::rotate));
  EXPECT_FALSE(allows(session.level(), selection, GizmoMode::scale));
  for (const int none : {-1, 36, 1000}) {
    EXPECT_FALSE(allows(session.level(), {Part::controlPoint, none}, GizmoMode::move)) << none;
  }
  const Level before = session.level();
  session.change(moved(session.level(), selection, {0, -1, 0}));
  session.change(moved(session.level(), selection, {0, -1, 0}));
  session.finishChange();
  EXPECT_FALSE(session.level() == before);
  session.undo();
  EXPECT_EQ(session.level(), before) << "one drag is one step";
}

TEST(ControlPoints, ArePickedWhileTheMirrorIsSelected) {
  const Level level = levelWith(PatchMirror{});
  ViewPose pose;
  pose.eye = {0, -25, 6};
  pose.target = {0, 0, 4};
  const ViewProjection projection(pose, 800, 600);
  const ControlPoint control = controlPointsOf(level.optic.shape())[14];
  const auto pixel = projection.pixelOf(control.at);
  ASSERT_TRUE(pixel);
  for (const Part part : {Part::none, Part::mirror, Part::controlPoint}) {
    const DisplaySettings display;
    const Pick picked = pick({projection, level, {}, {}, display, {part}}, *pixel);
    const bool isPoint = picked.selection == Selection{Part::controlPoint, 14};
    EXPECT_EQ(isPoint, part != Part::none) << int(part);
  }
}

// What the panel offers is what the shape takes.
TEST(ControlPoints, AreAsFewAsTheirFieldSays) {
  struct Count : SomeShapeFields {
    explicit Count(std::size_t less) : fewer(less) {}
    void radii(const FieldName& name, std::vector<double>& values) override {
      values.resize(name.fewest - fewer, 1);
    }
    void curve(const FieldName& name, std::vector<CurvePoint>& values) override {
      values = {{0, 0}, {3, 0}, {1, 2}, {0, 4}};
      values.resize(name.fewest - fewer);
    }
    std::size_t fewer;
  } fewest(0), fewer(1);
  ExtrusionMirror pillar;
  pillar.closed = true;
  for (const Shape& mirror : {Shape(RevolutionMirror{}), Shape(ExtrusionMirror{}), Shape(pillar)}) {
    Shape least = mirror, tooFew = mirror;
    visitFields(least, fewest);
    visitFields(tooFew, fewer);
    EXPECT_EQ(findShapeProblem(least), std::nullopt) << shapeName(mirror);
    EXPECT_NE(findShapeProblem(tooFew), std::nullopt) << shapeName(mirror);
  }
  Shape triangle = pillar;
  visitFields(triangle, fewest);
  EXPECT_EQ(controlPointsOf(triangle).size(), 3u);
}

TEST(Resampled, KeepsEndsAndStraightLines) {
  const std::vector<double> line{1, 2, 3, 4};
  EXPECT_EQ(resampled(line, 7), (std::vector<double>{1, 1.5, 2, 2.5, 3, 3.5, 4}));
  EXPECT_EQ(resampled(resampled(line, 7), 4), line);
  HeightGrid grid{4, {}};
  for (int i = 0; i < 20; ++i) grid.heights.push_back(i % 4 + 10.0 * (i / 4));
  const HeightGrid finer = resampled(grid, 9, 7);
  EXPECT_EQ(finer.rows(), 9u);
  EXPECT_EQ(finer.columns, 7u);
  EXPECT_DOUBLE_EQ(finer.at(0, 0), 0);
  EXPECT_DOUBLE_EQ(finer.at(8, 6), 43);
  EXPECT_DOUBLE_EQ(finer.at(1, 1), 5.5);
  EXPECT_EQ(resampled(finer, 5, 4), grid);
}

}  // namespace
}  // namespace anamorph
