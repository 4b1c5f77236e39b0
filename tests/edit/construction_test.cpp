#include "edit/construction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "edit/edit_levels.h"
#include "pipeline/stages.h"
#include "shapes.h"

namespace anamorph {
namespace {

using namespace testing;
using Kind = ConstructionSegment::Kind;

const Point* find(const Construction& made, const std::string& letter) {
  for (const ConstructionLabel& label : made.points) {
    if (label.text == letter) return &label.at;
  }
  return nullptr;
}

bool allFinite(const Construction& made) {
  bool finite = true;
  const auto label = [&](const ConstructionLabel& l) {
    finite &= isFinite(l.at) && l.text.find("nan") == std::string::npos;
  };
  for (const auto& point : made.points) label(point);
  for (const auto& distance : made.distances) label(distance);
  for (const auto& segment : made.segments) finite &= isFinite(segment.from) && isFinite(segment.to);
  for (const auto& arc : made.arcs) {
    label(arc.label);
    for (const Point& p : arc.points) finite &= isFinite(p);
  }
  for (const auto& row : made.rows) finite &= row.value.find("nan") == std::string::npos;
  return finite;
}

TEST(Construction, ShowsTheVertexRay) {
  for (const ShapeKind kind : allShapeKinds) {
    for (unsigned seed = 0; seed < 300; ++seed) {
      SCOPED_TRACE("mirror " + std::to_string(int(kind)) + ", seed " + std::to_string(seed));
      Random random(seed);
      const RandomScene scene = makeRandomScene(kind, random);
      const double k = random.uniform(0.1, 3);
      const Construction made =
          makeConstruction({scene.optic, scene.eye, k, {}}, makeRandomOriginal(scene, random, 0.02));
      ASSERT_EQ(made.ray.status, PathStatus::mapped);
      EXPECT_TRUE(allFinite(made));
      EXPECT_TRUE(made.explanation.empty());
      for (const char* letter : {"E", "P", "Q", "N", "S"}) ASSERT_TRUE(find(made, letter)) << letter;
      EXPECT_EQ(*find(made, "S"), made.ray.sculpture);
      EXPECT_EQ(made.segments.size(), 4u);
      for (const ConstructionSegment& segment : made.segments) {
        const bool touches =
            segment.from == made.ray.legs.back().start || segment.to == made.ray.legs.back().start;
        EXPECT_TRUE(touches) << "all meet in Q";
      }
      ASSERT_EQ(made.arcs.size(), 2u);
      for (const ConstructionArc& arc : made.arcs) {
        const Vector first = arc.points.front() - made.ray.legs.back().start,
                     last = arc.points.back() - made.ray.legs.back().start;
        const double angle = std::acos(
            std::clamp(glm::dot(first, last) / (glm::length(first) * glm::length(last)), -1.0, 1.0));
        EXPECT_NEAR(degrees(angle), made.ray.legs.back().angleOutDegrees, 1e-4);
        const Direction across =
            glm::normalize(glm::cross(made.ray.legs.back().normal, made.ray.legs.back().direction));
        for (const Point& p : arc.points) {
          EXPECT_NEAR(glm::length(p - made.ray.legs.back().start), glm::length(first), 1e-9);
          EXPECT_NEAR(glm::dot(p - made.ray.legs.back().start, across), 0, 1e-9)
              << "in the plane of incidence";
        }
      }
      EXPECT_LT(glm::length(made.arcs[0].points.back() - made.arcs[1].points.front()), 1e-12)
          << "at the normal";
    }
  }
}

TEST(Construction, HasTheNumbersOfTheLesson) {
  Level level;
  level.camera.eye = {0, -3, 0.5};
  level.sculpture.depthScale = 0.5;
  const Construction made =
      makeConstruction(makeVertexMap(level), {4, 1, 0.5});  // the mirror is y = 0; tan = 1
  ASSERT_EQ(made.ray.status, PathStatus::mapped);
  EXPECT_EQ(made.arcs[0].label.text, "α = 45.0°");
  ASSERT_EQ(made.distances.size(), 2u);
  EXPECT_EQ(made.distances[0].text, "d = 1.41");
  EXPECT_EQ(made.distances[1].text, "k·d = 0.71");
  std::map<std::string, std::string> rows;
  for (const ConstructionRow& row : made.rows) rows[row.name] = row.value;
  EXPECT_EQ(rows["Q  mirror point"], "(3.00, 0.00, 0.50)");
  EXPECT_EQ(rows["S = Q + k·d R"], "(3.50, -0.50, 0.50)");
  level.sculpture.depthScale = 1;
  EXPECT_EQ(makeConstruction(makeVertexMap(level), {4, 1, 0.5}).distances[1].text, "d = 1.41");
}

TEST(Construction, ExplainsEveryOtherStatus) {
  Optic plane{OpticKind::mirror, Level{}.optic.shape()};
  Optic sphere{OpticKind::mirror, SphereMirror{{0, 0, 0}, 2}};
  struct Case {
    Optic optic;
    Point eye, original;
    PathStatus status;
    bool hitsMirror;
  };
  const Case cases[] = {
      {plane, {0, -10, 5}, {0, 5, 100}, PathStatus::missesMirror, false},
      {plane, {0, -10, 5}, {0, -3, 5}, PathStatus::inFrontOfMirror, true},
      {plane, {0, -10, 5}, {0, -10, 5}, PathStatus::inFrontOfMirror, false},  // the eye itself
      {plane, {-7, -0.01, 5}, {7, 0.01, 5}, PathStatus::grazing, true},
      {sphere, {0, 0, 0.5}, {0.5, 50, 0.2}, PathStatus::hitsMirrorAgain, true},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(pathStatusName(c.status));
    const Construction made = makeConstruction({c.optic, c.eye, 1, {}}, c.original);
    ASSERT_EQ(made.ray.status, c.status);
    EXPECT_TRUE(allFinite(made));
    EXPECT_FALSE(made.explanation.empty());
    EXPECT_FALSE(find(made, "S"));
    EXPECT_EQ(find(made, "Q") != nullptr, c.hitsMirror);
    EXPECT_FALSE(made.segments.empty());
    if (c.status != PathStatus::hitsMirrorAgain) continue;
    for (const ConstructionSegment& segment : made.segments) {
      if (segment.kind == Kind::reflected) {
        EXPECT_NEAR(glm::length(segment.to), 2, 1e-9) << "it ends where the mirror is met again";
      }
    }
  }
}

TEST(Construction, AbsurdLevelsStayFinite) {
  for (const Level& level : makeAbsurdLevels()) {
    Random random(1);
    for (int i = 0; i < 50; ++i) {
      EXPECT_TRUE(
          allFinite(makeConstruction(makeVertexMap(level), i == 0 ? level.camera.eye : random.point(5))));
    }
  }
}

}  // namespace
}  // namespace anamorph
