#include "pipeline/evaluator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/error.h"
#include "pipeline/changing_levels.h"
#include "shapes.h"

namespace anamorph {
namespace {

using namespace testing;

EvaluationInput inputOf(const Level& level, int previewSize = 48) {
  return {level, "level.json", previewSize};
}

bool isSound(const Image& image) {
  for (const glm::vec3& pixel : image.pixels) {
    for (int i = 0; i < 3; ++i) {
      if (!(std::isfinite(pixel[i]) && pixel[i] >= 0)) return false;
    }
  }
  return true;
}

void expectSameReport(const MatchReport& a, const MatchReport& b) {
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.height, b.height);
  EXPECT_EQ(a.silhouetteIou, b.silhouetteIou);
  EXPECT_EQ(a.comparedPixels, b.comparedPixels);
  EXPECT_EQ(a.p99Px, b.p99Px);
  EXPECT_EQ(a.triangleAgreement, b.triangleAgreement);
}

/// By value: what was made anew has other pointers.
void expectSame(const LevelResult& a, const LevelResult& b) {
  EXPECT_EQ(a.level, b.level);
  EXPECT_EQ(*a.shape, *b.shape);
  EXPECT_EQ(*a.original.mesh, *b.original.mesh);
  EXPECT_EQ(a.sculpture.sculpture->mesh, b.sculpture.sculpture->mesh);
  EXPECT_EQ(a.problem, b.problem);
  EXPECT_EQ(a.warnings, b.warnings);
  ASSERT_EQ(a.match == nullptr, b.match == nullptr);
  if (a.match) {
    expectSameReport(a.match->report, b.match->report);
    EXPECT_EQ(a.match->classes, b.match->classes);
  }
  ASSERT_TRUE(a.previews.reflection && b.previews.reflection);
  EXPECT_EQ(*a.previews.reflection, *b.previews.reflection);
  EXPECT_EQ(*a.previews.original, *b.previews.original);
  ASSERT_EQ(a.previews.difference == nullptr, b.previews.difference == nullptr);
  if (a.previews.difference) {
    EXPECT_EQ(*a.previews.difference, *b.previews.difference);
  }
  EXPECT_TRUE(a.complete && b.complete);
}

LevelResult evaluateAlone(const EvaluationInput& input) {
  Evaluator evaluator;
  return *evaluator.evaluate(input, 2);
}

TEST(Evaluator, MakesWhatTheCommandsMake) {
  for (const Level& level : quickLevels()) {
    SCOPED_TRACE(level.text->title);
    Evaluator evaluator;
    const LevelResult settled = *evaluator.evaluate(inputOf(level), 2);
    EXPECT_EQ(settled.problem, std::nullopt);
    EXPECT_TRUE(settled.complete);
    const LevelResult finished = *finishLevel(level, placedOriginal(level), 1);
    EXPECT_EQ(*settled.original.mesh, *finished.original.mesh);
    EXPECT_EQ(settled.sculpture.sculpture->mesh, finished.sculpture.sculpture->mesh);
    EXPECT_EQ(settled.warnings, findWarnings(level, finished.sculpture));
    const auto [matchWidth, matchHeight] = pictureSize(level.grid, matchSize);
    expectSameReport(settled.match->report, matchLevel(finished, matchWidth, matchHeight, 1).report);
    const auto [width, height] = pictureSize(level.grid, 48);
    const ImageRequest request = makeImageRequest(level, width, height, 1);
    EXPECT_EQ(*settled.previews.reflection, *makePicture(finished, PictureKind::reflection, request));
    EXPECT_EQ(*settled.previews.original, *makePicture(finished, PictureKind::original, request));
    const Match match = matchLevel(finished, width, height);
    EXPECT_EQ(*settled.previews.difference, *makePicture(finished, PictureKind::difference, request, &match));
  }
}

TEST(Evaluator, KeepsEachStageWhoseInputStays) {
  Level level = quickLevels()[1];
  Evaluator evaluator;
  const LevelResult first = *evaluator.evaluate(inputOf(level), 2);

  level.text.edit([&](LevelText& text) { text.title = "another one"; });
  const LevelResult retitled = *evaluator.evaluate(inputOf(level), 2);
  EXPECT_EQ(retitled.shape, first.shape);
  EXPECT_EQ(retitled.original, first.original);
  EXPECT_EQ(retitled.sculpture, first.sculpture);
  EXPECT_EQ(retitled.match, first.match);
  EXPECT_EQ(retitled.previews.reflection, first.previews.reflection);
  EXPECT_EQ(retitled.previews.original, first.previews.original);

  level.lights[0].position.x += 5;
  const LevelResult lit = *evaluator.evaluate(inputOf(level), 2);
  EXPECT_EQ(lit.shape, first.shape);
  EXPECT_EQ(lit.original, first.original);
  EXPECT_EQ(lit.sculpture, first.sculpture);
  EXPECT_EQ(lit.match, first.match);
  EXPECT_NE(*lit.previews.reflection, *first.previews.reflection);
  expectSame(lit, evaluateAlone(inputOf(level)));

  level.sculpture.material.color = Color(0, 1, 0);  // the original's picture does not depend on it
  const LevelResult painted = *evaluator.evaluate(inputOf(level), 2);
  EXPECT_EQ(painted.sculpture, first.sculpture);
  EXPECT_EQ(painted.previews.original, lit.previews.original);
  EXPECT_NE(*painted.previews.reflection, *lit.previews.reflection);

  const LevelResult larger = *evaluator.evaluate(inputOf(level, 64), 2);
  EXPECT_EQ(larger.match, first.match);
  EXPECT_EQ(larger.previews.reflection->width, 64);

  level.sculpture.depthScale *= 0.9;
  const LevelResult deeper = *evaluator.evaluate(inputOf(level), 2);
  EXPECT_EQ(deeper.original, first.original);
  EXPECT_NE(deeper.sculpture, first.sculpture);
  expectSame(deeper, evaluateAlone(inputOf(level)));
}

TEST(Evaluator, RandomEditsGiveWhatAFreshOneGives) {
  for (unsigned seed = 0; seed < 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Level start = quickLevels()[seed];
    Evaluator evaluator;
    for (int i = 0; i < 5; ++i) {
      EvaluationInput input = inputOf(changed(start, random, random.uniform(0, 3)), random.integer(0, 40));
      if (random.integer(0, 2) == 0) input.level.original.shape = SphereShape{1, 12};
      const auto settled = evaluator.evaluate(input, 2);
      ASSERT_TRUE(settled);
      expectSame(*settled, evaluateAlone(input));
    }
  }
}

/// Everything that `before` has, `after` has too.
void expectGrown(const LevelResult& before, const LevelResult& after) {
  EXPECT_EQ(after.level, before.level);
  EXPECT_EQ(after.shape, before.shape);
  EXPECT_EQ(after.original, before.original);
  EXPECT_EQ(after.sculpture, before.sculpture);
  EXPECT_EQ(after.problem, before.problem);
  EXPECT_EQ(after.warnings, before.warnings);
  EXPECT_TRUE(!before.match || after.match == before.match);
  EXPECT_TRUE(after.previews.reflection || !before.previews.reflection);
  EXPECT_TRUE(after.previews.original || !before.previews.original);
  EXPECT_TRUE(after.previews.difference || !before.previews.difference);
  EXPECT_FALSE(before.complete) << "nothing comes after all";
}

TEST(Evaluator, PartsOnlyEverGainThings) {
  std::vector<Level> levels = quickLevels();
  levels.push_back(levels[2]);
  levels.back().camera.eye = pointAt(levels[2].optic.shape(), 0.2, 0.6);
  for (const Level& level : levels) {
    Evaluator evaluator;
    for (int run = 0; run < 2; ++run) {
      SCOPED_TRACE(level.text->title + ", run " + std::to_string(run));
      std::vector<LevelResult> parts;
      double reported = 0;
      Progress progress;
      progress.report = [&](double fraction) {
        EXPECT_GE(fraction, reported);
        EXPECT_LE(fraction, 1);
        reported = fraction;
      };
      const LevelResult settled = *evaluator.evaluate(
          inputOf(level), 2, [&](const LevelResult& part) { parts.push_back(part); }, progress);
      ASSERT_GE(parts.size(), 3u);
      EXPECT_TRUE(run > 0 || parts.size() >= 8) << "coarse pictures first";
      ASSERT_TRUE(parts.front().sculpture.sculpture);
      for (std::size_t i = 1; i < parts.size(); ++i) expectGrown(parts[i - 1], parts[i]);
      EXPECT_TRUE(parts.back().complete);
      expectSame(parts.back(), settled);
    }
  }
}

TEST(Evaluator, CancelledAnywhereTheNextRunIsRight) {
  const Level level = quickLevels()[1];
  Level other = level;
  other.camera.eye.z += 0.5;
  const LevelResult wanted = evaluateAlone(inputOf(level)), otherWanted = evaluateAlone(inputOf(other));
  int cancelled = 0;
  bool done = false;
  Evaluator kept;  // the same one through all cancellations
  for (int steps = 0; !done; steps += 1 + steps / 6) {
    SCOPED_TRACE("cancelled at report " + std::to_string(steps));
    const bool even = cancelled % 2 == 0;
    Evaluator fresh;
    Evaluator& evaluator = steps % 3 == 0 ? fresh : kept;
    Progress progress;
    int reports = 0;
    const auto tick = [&] {
      if (reports++ == steps) progress.token.cancel();
    };
    progress.report = [&](double) { tick(); };
    const auto settled = evaluator.evaluate(
        inputOf(even ? level : other), 1, [&](const LevelResult&) { tick(); }, progress);
    done = !progress.cancelled();
    if (settled) {
      expectSame(*settled, even ? wanted : otherWanted);
    } else {
      EXPECT_TRUE(progress.cancelled());
      ++cancelled;
    }
    if (steps % 4 == 0) {
      const auto next = evaluator.evaluate(inputOf(level), 2);
      ASSERT_TRUE(next);
      expectSame(*next, wanted);
    }
    ASSERT_LT(steps, 100000);
  }
  EXPECT_GT(cancelled, 8);
}

TEST(Evaluator, CancelledBeforeItBeginsGivesNothing) {
  Evaluator evaluator;
  Progress progress;
  progress.token.cancel();
  int parts = 0;
  const EvaluationInput input = inputOf(quickLevels()[0]);
  EXPECT_FALSE(evaluator.evaluate(
      input, 1, [&](const LevelResult&) { ++parts; }, progress));
  EXPECT_EQ(parts, 0);
  ASSERT_TRUE(evaluator.evaluate(input, 1));
  EXPECT_FALSE(evaluator.evaluate(input, 1, {}, progress)) << "also when all is known already";
}

struct Trouble {
  std::string name;
  Level level;
  std::string sentence;  // a part of it
};

std::vector<Trouble> troubles() {
  const std::vector<Level> levels = quickLevels();
  std::vector<Trouble> all{
      {"eye on the sphere", levels[2], "on the surface of the mirror"},
      {"sphere without radius", levels[2], "sphere mirror cannot be used"},
      {"cylinder without radius", levels[1], "cylinder mirror cannot be used"},
      {"plane without area", levels[0], "plane mirror cannot be used"},
      {"original without size", levels[0], "area"},
      {"original without size, unrefined", levels[1], "area"},
      {"eye in the original", levels[0], "the eye is inside the original's box"},
      {"original beside the mirror", levels[0], "no triangle of the original can be mapped"},
      {"original before the mirror", levels[2], "between the eye and the mirror"}};
  all[0].level.camera.eye = pointAt(levels[2].optic.shape(), 0.2, 0.6);
  changeShape<SphereMirror>(all[1].level.optic.shape(), [](auto& s) { s.radius = 0; });
  changeShape<CylinderMirror>(all[2].level.optic.shape(), [](auto& s) { s.radius = 0; });
  changeShape<PlaneMirror>(all[3].level.optic.shape(), [](auto& s) { s.corners.fill(Point(1)); });
  all[4].level.original.placement.scale = Vector(0);
  all[5].level.original.placement.scale = Vector(0);
  all[5].level.sculpture.tolerancePixels = 0;
  all[6].level.camera.eye = all[6].level.original.placement.position;
  all[7].level.original.placement.position.x = 100;
  all[8].level.original.placement.position = 0.5 * (all[8].level.camera.eye + Point(0, 0, 4));
  all[8].level.original.placement.scale = Vector(0.2);
  return all;
}

TEST(Evaluator, ProblemsAreSentencesAndPicturesStaySound) {
  Evaluator kept;
  for (const Trouble& trouble : troubles()) {
    SCOPED_TRACE(trouble.name);
    Evaluator fresh;
    for (Evaluator* evaluator : {&fresh, &kept}) {
      const auto settled = evaluator->evaluate(inputOf(trouble.level), 2, [](const LevelResult& part) {
        for (const auto& picture :
             {part.previews.reflection, part.previews.original, part.previews.difference}) {
          EXPECT_TRUE(!picture || isSound(*picture));
        }
      });
      ASSERT_TRUE(settled);
      ASSERT_TRUE(settled->problem);
      EXPECT_NE(settled->problem->find(trouble.sentence), std::string::npos) << *settled->problem;
      EXPECT_TRUE(settled->complete);
      EXPECT_TRUE(settled->sculpture.sculpture->mesh.triangles.empty());
      EXPECT_TRUE(settled->warnings.empty());
      EXPECT_EQ(settled->match, nullptr);
      EXPECT_EQ(settled->previews.difference, nullptr);
      ASSERT_TRUE(settled->previews.reflection && settled->previews.original);
    }
  }
  const Level level = quickLevels()[2];
  expectSame(*kept.evaluate(inputOf(level), 2), evaluateAlone(inputOf(level)));
}

TEST(Evaluator, PartlyUnmappedIsAWarningOnly) {
  Level level = quickLevels()[0];
  level.original.placement.position.x += 4;
  const LevelResult settled = evaluateAlone(inputOf(level));
  EXPECT_EQ(settled.problem, std::nullopt);
  ASSERT_FALSE(settled.warnings.empty());
  EXPECT_NE(settled.warnings[0].find("vertices mapped"), std::string::npos);
  EXPECT_TRUE(settled.match && settled.previews.difference);
}

TEST(Evaluator, PreviewSizeZeroIsThePixelGrid) {
  for (const auto& [columns, rows] : {std::pair{8, 8}, {1, 1}, {64, 1}, {1, 64}, {13, 7}, {64, 64}}) {
    SCOPED_TRACE(std::to_string(columns) + " x " + std::to_string(rows));
    Level level = quickLevels()[0];
    level.grid.columns = columns;
    level.grid.rows = rows;
    const LevelResult settled = evaluateAlone(inputOf(level, 0));
    for (const auto& picture :
         {settled.previews.reflection, settled.previews.original, settled.previews.difference}) {
      ASSERT_TRUE(picture);
      EXPECT_EQ(picture->width, columns);
      EXPECT_EQ(picture->height, rows);
      EXPECT_TRUE(isSound(*picture));
    }
    ASSERT_TRUE(settled.match);
    const LevelResult sized = evaluateAlone(inputOf(level, 40));
    EXPECT_EQ(std::max(sized.previews.reflection->width, sized.previews.reflection->height), 40);
  }
}

TEST(PictureSize, HasTheGridsSidesAndAtLeastAPixel) {
  const auto size = [](int columns, int rows, int longer) {
    PixelGrid grid;
    grid.columns = columns;
    grid.rows = rows;
    return pictureSize(grid, longer);
  };
  EXPECT_EQ(size(8, 8, 256), std::pair(256, 256));
  EXPECT_EQ(size(16, 9, 256), std::pair(256, 144));
  EXPECT_EQ(size(9, 16, 256), std::pair(144, 256));
  EXPECT_EQ(size(64, 1, 48), std::pair(48, 1));
  EXPECT_EQ(size(64, 1, 10), std::pair(10, 1));
  EXPECT_EQ(size(1, 1, 512), std::pair(512, 512));
  EXPECT_EQ(size(5, 3, 0), std::pair(5, 3));
  EXPECT_EQ(size(5, 3, 1), std::pair(1, 1));
}

TEST(Evaluator, FileThatCannotBeReadIsAnErrorAndTheNextOneIsFine) {
  Level level = quickLevels()[0];
  Evaluator evaluator;
  const EvaluationInput good = inputOf(level);
  ASSERT_TRUE(evaluator.evaluate(good, 2));
  level.original.shape = FileShape{"nothing.obj"};
  EXPECT_THROW(evaluator.evaluate(inputOf(level), 2), Error);
  EXPECT_THROW(evaluator.evaluate(inputOf(level), 2), Error) << "and again";
  expectSame(*evaluator.evaluate(good, 2), evaluateAlone(good));
  level.original.shape = FileShape{"cube.obj"};
  EvaluationInput file = inputOf(level);
  file.levelPath = std::string(ANAMORPH_TEST_DATA) + "/meshes/level.json";
  const auto settled = evaluator.evaluate(file, 2);
  ASSERT_TRUE(settled);
  EXPECT_EQ(settled->shape->positions.size(), 8u);
}

}  // namespace
}  // namespace anamorph
