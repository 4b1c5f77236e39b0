// The match agrees with the picture: where the tracer sees the sculpture by way of the optic, and nowhere else, the
// match says so, whatever stands in the way.

#include <gtest/gtest.h>

#include "geometry/shapes.h"
#include "pipeline/evaluator.h"
#include "pipeline/original.h"
#include "pipeline/picture.h"
#include "random_scene.h"
#include "raytrace/tracer.h"

namespace anamorph {
namespace {

using namespace testing;

constexpr int size = 24;  // pixels

// A mesh that hides things as a base plate does: a box of random size near the sculpture's way.
MeshSurface randomPlate(const LevelResult& finished, Random& random) {
  const Box box = finished.sculpture.prepared.box;
  const Vector half(random.uniform(0.2, 2), random.uniform(0.2, 2), random.uniform(0.05, 0.3));
  const Point middle =
      glm::mix(box.centre(), middleOf(finished.level.optic.shape()), random.uniform(-0.2, 0.9));
  Mesh mesh = makeBox(2.0 * half, 1);
  mesh.positions = mapPoints(mesh.positions, [&](const Point& p) { return middle + p; });
  return makeSurface("plate", std::move(mesh), {});
}

Level randomLevel(int number, Random& random) {
  constexpr auto kinds = std::size(allShapeKinds);
  const RandomScene scene = makeRandomScene(allShapeKinds[number % kinds], random);
  Level level;
  level.optic = scene.optic;
  if (number / kinds % 4 == 3) level.optic.parts.front().kind = OpticKind::canvas;
  level.camera.eye = scene.eye;
  level.original.placement.position = makeRandomOriginal(scene, random, 0.3);
  level.camera.target = level.original.placement.position;
  level.camera.fovDegrees = random.uniform(15, 60);
  level.original.shape = BoxShape{Vector(random.uniform(0.2, 1.5)), 3};
  level.sculpture.depthScale = random.uniform(0.1, 2);
  level.sculpture.tolerancePixels = 0;
  level.ground.visible = random.integer(0, 3) > 0;
  level.ground.height = glm::mix(scene.onMirror.z, scene.eye.z, random.uniform(-0.6, 0.6));
  return level;
}

// What the first way through the optic ends at; the sculpture is surface 0.
struct Seen {
  bool sculpture = false;
  bool obstacle = false;  // something solid, or the sculpture before the optic
};
Seen look(const RenderScene& scene, const Ray& ray) {
  const RayTree tree = tracePath(scene, ray, {1, false, 0});
  const auto isSculpture = [](const ObjectId& id) { return id == ObjectId{ObjectKind::mesh, 0}; };
  ObjectId end = tree.segments.front().object;
  if (!scene.input.optic) return {isSculpture(end), end.kind != ObjectKind::none};
  if (end.kind != ObjectKind::optic) return {false, end.kind != ObjectKind::none};
  for (const RaySegment& segment : tree.segments) {
    if (segment.parent == 0) end = segment.object;
  }
  if (end == tree.segments.front().object) end = {};  // the same mirror again
  return {isSculpture(end), end.kind == ObjectKind::mesh || end.kind == ObjectKind::ground};
}

TEST(MatchAndPicture, AgreePixelByPixelWhateverStandsInTheWay) {
  std::size_t compared = 0, shown = 0, hidden = 0, wrong = 0;
  for (int number = 0; number < 500; ++number) {
    SCOPED_TRACE(number);
    Random random(static_cast<unsigned>(number));
    const Level level = randomLevel(number, random);
    const auto mesh = std::make_shared<const Mesh>(makeBox(std::get<BoxShape>(level.original.shape).size, 3));
    const auto finished = finishLevel(level, placeOriginal(*mesh, false, level.original.placement));
    ASSERT_TRUE(finished);
    if (finished->problem) continue;
    SceneInput input = makeReflectionScene(level, finished->sculpture);
    std::shared_ptr<const Bvh> plate;
    if (number % 2 == 1) {
      // After the measure of the scene was taken: the floor fades by what a level has.
      input.surfaces.push_back(randomPlate(*finished, random));
      plate = input.surfaces.back().bvh;
    }
    RenderScene scene{measureScene(boxOf(makeReflectionScene(level, finished->sculpture))), std::move(input)};
    const Match match = matchLevel(*finished, size, size, 1, {}, plate);
    const Projection projection(level.camera, size, size);
    for (int i = 0; i < size * size; ++i) {
      const PixelClass kind = match.classes[static_cast<std::size_t>(i)];
      const Seen seen = look(scene, projection.rayThrough(matchSample(i % size, i / size)));
      ++compared;
      shown += seen.sculpture;
      hidden += kind == PixelClass::hidden;
      const bool agrees =
          showsReflection(kind) == seen.sculpture && (kind != PixelClass::hidden || seen.obstacle);
      if (agrees) continue;
      ++wrong;
      if (wrong <= 20) {
        std::printf("scene %d, pixel (%d, %d): class %d, the tracer sees %s\n", number, i % size, i / size,
                    static_cast<int>(kind),
                    seen.sculpture  ? "the sculpture"
                    : seen.obstacle ? "something else"
                                    : "nothing");
      }
    }
  }
  std::printf("%zu pixels, %zu show the sculpture, %zu hidden, %zu wrong\n", compared, shown, hidden, wrong);
  EXPECT_GT(shown, compared / 100);
  EXPECT_GT(hidden, compared / 200);
  EXPECT_LE(wrong, compared / 50000);  // rays along an edge may go either way
}

TEST(MatchAndPicture, ASculptureBelowTheFloorIsHidden) {
  Level level;  // the plane mirror's
  level.original.placement.position.z = -2;
  level.sculpture.depthScale = 1;
  const auto mesh = std::make_shared<const Mesh>(makeBox({6, 2, 2}, 8));
  const auto original = placeOriginal(*mesh, false, level.original.placement);
  level.ground.visible = false;
  EXPECT_EQ(matchLevel(*finishLevel(level, original), 128, 128).report.hiddenShare, 0);
  level.ground.visible = true;
  const MatchReport report = matchLevel(*finishLevel(level, original), 128, 128).report;
  EXPECT_GT(report.hiddenShare + report.missedShare, 0.9);
  EXPECT_NE(gradeOf(report), MatchGrade::excellent);
}

}  // namespace
}  // namespace anamorph
