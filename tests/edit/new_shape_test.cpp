// A shape that the program does not have, registered from here alone: a round, flat disc. It goes through level file,
// map, tracer, edits and viewing sheet, and no other file knows of it.

#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "anamorphosis/map_points.h"
#include "anamorphosis/vertex_ray.h"
#include "edit/level_edits.h"
#include "edit/level_repairs.h"
#include "error_text.h"
#include "exports/sheet_words.h"
#include "exports/viewing_sheet.h"
#include "level/level_json.h"
#include "level/mirror_kind.h"
#include "optics/shape_helpers.h"
#include "optics/shape_table.h"
#include "pipeline/evaluator.h"
#include "pipeline/original.h"
#include "pipeline/picture.h"
#include "random_scene.h"
#include "raytrace/tracer.h"

namespace anamorph {
namespace {

using ::testing::HasSubstr;
using testing::Random;

struct DiscMirror {
  static constexpr const char *name = "disc", *label = "Disc";

  Point centre{0};
  Point tip{0, -1, 0};  ///< where the normal from the centre ends; only its direction matters
  double radius = 1;
  bool operator==(const DiscMirror&) const = default;

  Direction normal() const { return glm::normalize(tip - centre); }

  void visitFields(ShapeFields& fields) {
    fields.point({"centre", "Centre"}, centre);
    fields.point({"tip", "Tip"}, tip);
    fields.length({"radius", "Radius"}, radius);
  }

  std::optional<SurfaceHit> intersect(const Ray& ray, double tMin) const {
    const double t = glm::dot(normal(), centre - ray.origin) / glm::dot(normal(), ray.direction);
    if (!(t > tMin) || !std::isfinite(t) || glm::length(ray.at(t) - centre) > radius) return std::nullopt;
    return SurfaceHit{t, ray.at(t), facing(normal(), ray.direction)};
  }

  std::optional<std::string> findProblem() const { return findRadiusProblem(radius); }
  std::optional<std::string> findEyeProblem(const Point& eye) const {
    if (std::abs(glm::dot(eye - centre, normal())) > shapeTolerance * radius) return std::nullopt;
    return "the eye lies in the plane of the disc";
  }
  Point eyeOutside(const Point& eye, const Point&) const { return eye + radius * normal(); }

  Box box() const { return boxOfDiscs(centre, radius, centre + 1e-9 * normal(), radius); }
  Point middle() const { return centre; }
  Axes axes() const { return axesAlong(normal()); }
  ShapeExtent extent() const { return {centre, {0, 0, 1}, 2 * radius, 2 * radius}; }
  static DiscMirror filling(const ShapeExtent& room, const Point& eye) {
    const Vector towards = eye - room.middle;
    return {room.middle, room.middle + towards, 0.5 * std::min(room.width, room.height)};
  }
  void map(const ShapeMap& map) {
    radius = map.size(radius, {map.factors.x, map.factors.y});
    tip = map.point(tip);
    centre = map.point(centre);
  }
  void carryOn() { radius *= 1e3; }

  Point pointAt(double u, double v) const {
    const Axes a = axes();
    return centre + v * radius * (std::cos(2 * pi * u) * a[0] + std::sin(2 * pi * u) * a[1]);
  }
  std::array<int, 2> gridFor(int segments) const { return {segments, 1}; }
  SurfaceLines lines() const { return {16, 4, true, 48, 1, {}, {1}}; }
  double borderDistance(const Point& p) const { return (radius - glm::length(p - centre)) / (2 * radius); }
  PackedShape packed(const Point& origin) const {
    return {glm::dvec4(centre - origin, radius), glm::dvec4(normal(), 0)};
  }
  ShapeWords words(LengthText text) const {
    return {fmt::format("A disc of {} mm diameter. ", text(2 * radius)), "Upright on the blue line"};
  }
};

// Registered for as long as this program runs.
class NewShape : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    static const bool once = (registerShape(shapeType<DiscMirror>()), true);
    ASSERT_TRUE(once);
  }

  // A box behind a disc that stands upright on the ground.
  static Level discLevel() {
    Level level;
    level.optic.shape() = DiscMirror{{0, 0, 4}, {0, -1, 4}, 4};
    level.original.shape = BoxShape{{2, 1, 1}, 3};
    level.original.placement = {.position = {0, 2.5, 3}};
    level.camera.eye = {0, -10, 7};
    level.camera.target = {0, 2.5, 3};
    return level;
  }
  static LevelResult resultOf(const Level& level) {
    const auto shape = loadOriginal(level.original.shape, "").mesh;
    return *finishLevel(level, placeOriginal(*shape, level.original.unitize, level.original.placement), 2);
  }
};

TEST_F(NewShape, IsOffered) {
  EXPECT_STREQ(shapeNames().back(), "disc");
  EXPECT_EQ(shapeIndex(DiscMirror{}), shapeTypes().size() - 1);
  EXPECT_STREQ(shapeTypes().back().label, "Disc");
}

TEST_F(NewShape, GoesThroughLevelFiles) {
  const Level level = discLevel();
  const std::string text = formatLevel(level);
  EXPECT_THAT(text,
              HasSubstr(R"("shape": {"type": "disc", "centre": [0, 0, 4], "tip": [0, -1, 4], "radius": 4})"));
  const LoadedLevel loaded = parseLevel(text, "disc.json");
  EXPECT_EQ(loaded.level, level);
  EXPECT_TRUE(loaded.warnings.empty());
  std::string broken = text;
  broken.replace(broken.find("\"radius\": 4"), 11, "\"radius\": 0");
  EXPECT_EQ(withoutPlaces(errorOf([&] { parseLevel(broken, "disc.json"); })),
            "disc.json: /optic/shape/radius: expected a number from 0.000001 to 1000000, got 0");
}

TEST_F(NewShape, IsMappedThrough) {
  const Level level = discLevel();
  const VertexMap map = makeVertexMap(level);
  const LevelResult result = resultOf(level);
  ASSERT_EQ(result.problem, std::nullopt);
  const Sculpture& sculpture = *result.sculpture.sculpture;
  EXPECT_EQ(sculpture.originalStatus[0], result.original.mesh->positions.size()) << "all of them";
  for (std::size_t i = 0; i < sculpture.original.size(); ++i) {
    const Point p = sculpture.original[i], mirrored(p.x, -p.y, p.z);
    EXPECT_LT(glm::length(sculpture.mesh.positions[i] - mirrored), 1e-12) << "fact F3: the mirror image";
  }
  MappedPoints mapped;
  mapPointsThrough(map, sculpture.original, mapped, 2);
  EXPECT_EQ(mapped.points, sculpture.mesh.positions);
  EXPECT_EQ(mapPoint(map, {40, 3, 3}).status, PathStatus::missesMirror);
  EXPECT_EQ(mapPoint(map, {0, -3, 4}).status, PathStatus::inFrontOfMirror);
  const VertexRay ray = makeVertexRay(map, {0, 3, 4});
  ASSERT_TRUE(ray.mapped() && ray.bends);
  EXPECT_EQ(ray.legs.size(), 1u);
  EXPECT_GT(matchLevel(result, 128, 128, 2).report.silhouetteIou, 0.999);
}

TEST_F(NewShape, IsTraced) {
  Level round = discLevel(), square = round;
  square.optic.shape() = mirrorOfKind(0, round.optic.shape(), round.camera.eye);
  const PreparedSculpture sculpture = resultOf(round).sculpture;
  const RenderScene disc = buildScene(makeReflectionScene(round, sculpture)),
                    plane = buildScene(makeReflectionScene(square, sculpture));
  Random random(1);
  int inside = 0;
  for (int i = 0; i < 500; ++i) {
    const Point aim(random.uniform(-4, 4), 0, random.uniform(0.1, 8));
    const double out = glm::length(aim - Point(0, 0, 4));
    if (std::abs(out - 4) < 0.2) continue;  // the bright border
    const Ray ray{round.camera.eye, glm::normalize(aim - round.camera.eye)};
    const Color seen = traceColor(disc, ray, {}), wanted = traceColor(plane, ray, {});
    if (out > 4) continue;
    ++inside;
    EXPECT_LT(glm::length(seen - wanted), 1e-6) << aim.x << ", " << aim.z;
  }
  EXPECT_GT(inside, 300);
  EXPECT_EQ(objectName(disc, {ObjectKind::optic, 0}), "mirror");
}

TEST_F(NewShape, IsEdited) {
  const Level level = discLevel();
  const Selection mirror{Part::mirror};
  const auto disc = [](const Level& made) { return *made.optic.shape().as<DiscMirror>(); };
  EXPECT_EQ(disc(moved(level, mirror, {1, 2, 3})), (DiscMirror{{1, 2, 7}, {1, 1, 7}, 4}));
  const DiscMirror turned = disc(rotated(level, mirror, {0, 0, 4}, {0, 0, 1}, pi / 2));
  EXPECT_LT(glm::length(turned.normal() - Vector(1, 0, 0)), 1e-12);
  EXPECT_EQ(disc(scaled(level, mirror, {0, 0, 4}, {0.5, 1, 1})).radius, 2);
  EXPECT_TRUE(allows(level, mirror, GizmoMode::rotate));
  EXPECT_LT(glm::length(boxOf(level, mirror, {}, {}).size() - Vector(8, 0, 8)), 1e-6);
  const std::size_t kind = shapeIndex(level.optic.shape());
  for (std::size_t other = 0; other < shapeTypes().size(); ++other) {
    const Shape made = mirrorOfKind(other, level.optic.shape(), level.camera.eye);
    EXPECT_EQ(findShapeProblem(made), std::nullopt);
    EXPECT_EQ(shapeIndex(mirrorOfKind(kind, made, level.camera.eye)), kind) << "and back";
  }
  Level flat = level;
  flat.optic.shape() = DiscMirror{{0, 0, 4}, {0, -1, 4}, 0};
  EXPECT_THAT(findProblem(flat, {{0, 0, 0}, {1, 1, 1}}).value_or(""),
              HasSubstr("the disc mirror cannot be used"));
}

TEST_F(NewShape, IsOnTheSheet) {
  const LevelResult result = resultOf(discLevel());
  const Arrangement arrangement = makeArrangement(result, 10);
  std::string words;
  for (const SheetStep& step : makeSheetSteps(arrangement, 1)) words += step.text + "\n";
  EXPECT_THAT(words, HasSubstr("A disc of 80.0 mm diameter."));
  EXPECT_GT(makeViewingSheet(result, arrangement, Paper::a3).scale, 0);
}

}  // namespace
}  // namespace anamorph
