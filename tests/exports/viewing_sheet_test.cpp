// The viewing sheet is measured as a maker would measure it: in millimetres of the paper, in the SVG file.

#include "exports/viewing_sheet.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "error_text.h"
#include "exports/page_file.h"
#include "exports/sheet_plan.h"
#include "exports/sheet_words.h"
#include "exports/silhouette.h"
#include "finished.h"
#include "geometry/shapes.h"
#include "in_dutch.h"

namespace anamorph {
namespace {

using testing::finishedLevel;
using ::testing::HasSubstr;

ViewingSheet sheetOf(const std::string& name, double mm, Paper paper = Paper::a4,
                     std::optional<double> scale = {}) {
  const LevelResult& finished = finishedLevel(name);
  return makeViewingSheet(finished, makeArrangement(finished, mm), paper, scale);
}

// The boxes of all paths of an SVG file, in its unit. (std::regex overflows the stack on long paths.)
std::vector<Box> pathBoxes(const std::string& svg) {
  std::vector<Box> boxes;
  const std::string begin = "<path";
  for (std::size_t at = svg.find(begin, svg.find("</defs>")); at != std::string::npos;
       at = svg.find(begin, at + 1)) {
    const std::string element = svg.substr(at, svg.find('>', at) - at);
    EXPECT_EQ(element.find("transform"), std::string::npos) << "in the page's own unit";
    std::istringstream words(element.substr(element.find(" d=\"") + 4));
    std::vector<double> numbers;
    for (std::string word; words >> word;) {
      char* end = nullptr;
      const double number = std::strtod(word.c_str(), &end);
      if (end != word.c_str()) numbers.push_back(number);
    }
    Box box;
    for (std::size_t k = 0; k + 1 < numbers.size(); k += 2) box.extend({numbers[k], numbers[k + 1], 0});
    boxes.push_back(box);
  }
  return boxes;
}

int countSizes(const std::vector<Box>& boxes, double width, double height, double tolerance = 0.01) {
  int count = 0;
  for (const Box& box : boxes) {
    count += std::abs(box.size().x - width) < tolerance && std::abs(box.size().y - height) < tolerance;
  }
  return count;
}

TEST(ViewingSheet, HasARulerOfExactly100MillimetresAndTheMirrorAtItsSize) {
  for (const Paper paper : {Paper::a4, Paper::a3, Paper::letter}) {
    const ViewingSheet sheet = sheetOf("2-cylinder", 10, paper);
    EXPECT_EQ(sheet.scale, 1);
    const std::string svg = encodePage(sheet.page, PageFormat::svg);
    EXPECT_THAT(svg, HasSubstr(fmt::format("width=\"{:g}mm\" height=\"{:g}mm\" viewBox=\"0 0 {:g} {:g}\"",
                                           sheet.page.width, sheet.page.height, sheet.page.width,
                                           sheet.page.height)));
    const std::vector<Box> boxes = pathBoxes(svg);
    EXPECT_GE(countSizes(boxes, 100, 0), 1) << "the ruler";
    EXPECT_GE(countSizes(boxes, 60, 60), 1) << "the cylinder's circle: radius 3 at 10 mm per unit";
  }
  const std::vector<Box> twice = pathBoxes(encodePage(sheetOf("2-cylinder", 20).page, PageFormat::svg));
  EXPECT_GE(countSizes(twice, 120, 120), 1);
  EXPECT_GE(countSizes(twice, 100, 0), 1);
}

TEST(ViewingSheet, DrawsTheSculpturesFootprintAtItsSize) {
  const LevelResult& finished = finishedLevel("1-plane");
  const Box box = boundingBox(finished.sculpture.sculpture->mesh.positions);
  const std::vector<Box> boxes = pathBoxes(encodePage(sheetOf("1-plane", 10).page, PageFormat::svg));
  EXPECT_GE(countSizes(boxes, 10 * box.size().x, 10 * box.size().y, 0.15), 1);
}

TEST(ViewingSheet, OfHalfSizeKeepsItsRuler) {
  const ViewingSheet sheet = sheetOf("2-cylinder", 10, Paper::a4, 2.0);
  const std::vector<Box> boxes = pathBoxes(encodePage(sheet.page, PageFormat::svg));
  EXPECT_GE(countSizes(boxes, 30, 30), 1);
  EXPECT_GE(countSizes(boxes, 100, 0), 1);
}

TEST(ViewingSheet, SaysWhetherItIsSmallerOrLargerThanLife) {
  const Arrangement arrangement = makeArrangement(finishedLevel("2-cylinder"), 10);
  const std::pair<double, const char*> scales[] = {
      {0.5, "Larger than life"}, {1, "Print at 100 %"}, {2, "Smaller than life"}};
  for (const auto& [scale, words] : scales) {
    EXPECT_EQ(makeSheetSteps(arrangement, scale).front().text.rfind(words, 0), 0u) << scale;
  }
}

void expectOnPaper() {
  for (const char* name : {"1-plane", "2-cylinder", "3-sphere"}) {
    for (const double mm : {0.01, 1.0, 10.0, 20.0, 35.0, 1000.0}) {
      const ViewingSheet sheet = sheetOf(name, mm);
      EXPECT_GE(sheet.scale, 1) << name << mm;
      for (const Box& box : pathBoxes(encodePage(sheet.page, PageFormat::svg))) {
        EXPECT_GE(box.min.x, 4) << name << mm;
        EXPECT_GE(box.min.y, 4) << name << mm;
        EXPECT_LE(box.max.x, sheet.page.width - 4) << name << mm;
        EXPECT_LE(box.max.y, sheet.page.height - 4) << name << mm;
      }
    }
  }
}

TEST(ViewingSheet, StaysOnItsPaperWhateverIsExported) {
  expectOnPaper();
}

TEST(ViewingSheet, StaysOnItsPaperInALanguageOfLongerWords) {
  const testing::InDutch dutch;
  expectOnPaper();
  EXPECT_EQ(makeSheetSteps(makeArrangement(finishedLevel("1-plane"), 10), 1)[1].name, "Spiegel");
}

TEST(ViewingSheet, IsOnePdfPageOfThePapersSize) {
  const struct {
    Paper paper;
    const char* box;
  } papers[] = {{Paper::a4, "[ 0 0 595.275591 841.889764 ]"},
                {Paper::a3, "[ 0 0 841.889764 1190.551181 ]"},
                {Paper::letter, "[ 0 0 612 792 ]"}};
  for (const auto& [paper, box] : papers) {
    const std::string pdf = encodePage(sheetOf("2-cylinder", 10, paper).page, PageFormat::pdf);
    EXPECT_TRUE(pdf.starts_with("%PDF-"));
    EXPECT_THAT(pdf, HasSubstr(std::string("/MediaBox ") + box));
    std::size_t pages = 0;
    for (const std::string object : {"/Type /Page\n", "/Type /Page "})
      for (std::size_t at = pdf.find(object); at != std::string::npos; at = pdf.find(object, at + 1)) ++pages;
    EXPECT_EQ(pages, 1u);
  }
}

TEST(ViewingSheet, RefusesAScaleThatDoesNotFit) {
  EXPECT_THAT(errorOf([] { sheetOf("2-cylinder", 100, Paper::a4, 1.0); }),
              HasSubstr("the viewing sheet at 1 : 1 needs "));
  EXPECT_THAT(errorOf([] { sheetOf("2-cylinder", 100, Paper::a4, 1.0); }), HasSubstr("A4 has 190 x "));
}

TEST(ViewingSheet, ShowsTheEyeWhereItFits) {
  EXPECT_TRUE(sheetOf("2-cylinder", 10).showsEye);
  const ViewingSheet large = sheetOf("2-cylinder", 20);
  EXPECT_EQ(large.scale, 1);
  EXPECT_FALSE(large.showsEye) << "mirror and sculpture at 1:1 are worth more than the eye's place";
}

TEST(ViewingSheet, SaysHeightsAboveTheLowestPointWhereTheGroundIsHigher) {
  Level level = loadLevel(std::string(ANAMORPH_LEVELS) + "/2-cylinder.json").level;
  level.ground.height = 4;
  const LevelResult finished = testing::finish(level);
  const Arrangement arrangement = makeArrangement(finished, 10);
  EXPECT_FALSE(arrangement.onGround);
  EXPECT_DOUBLE_EQ(arrangement.table, 0);
  makeViewingSheet(finished, arrangement, Paper::a4);
}

TEST(Arrangement, LooksFromTheEyeToTheMirror) {
  const Arrangement arrangement = makeArrangement(finishedLevel("2-cylinder"), 10);
  const Point2 eye = arrangement.planOf(arrangement.eye);
  EXPECT_NEAR(eye.x, 0, 1e-9);
  EXPECT_LT(eye.y, 0);
  EXPECT_NEAR(arrangement.planOf(arrangement.middle).y, 0, 1e-9);
}

double areaOf(const Loop& loop) {
  double twice = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto &p = loop[i], &q = loop[(i + 1) % loop.size()];
    twice += p.x * q.y - p.y * q.x;
  }
  return twice / 2;
}

// A wave can be placed on it: what is drawn is the curve, not the band that holds it.
TEST(ViewingSheet, DrawsTheOutlineOfACurvedMirrorNotItsHull) {
  const struct {
    const char* level;
    double share;  // at most, of the hull
  } mirrors[] = {{"wavy-box", 0.3}, {"patch-box", 0.95}};
  for (const auto& [name, share] : mirrors) {
    SCOPED_TRACE(name);
    const LevelResult finished =
        testing::finish(loadLevel(std::string(ANAMORPH_TEST_DATA) + "/optics/" + name + ".json").level);
    const Arrangement arrangement = makeArrangement(finished, 10);
    const SheetPlan plan = makeSheetPlan(arrangement);
    std::vector<Point2> points;
    for (std::size_t i = 0; i < arrangement.mirrorSurface.positions.size(); ++i)
      points.push_back(arrangement.planOf(arrangement.mirrorSurface.positions[i]));
    double area = 0;
    for (const Loop& loop : plan.mirror) {
      area += areaOf(loop);
      for (const Point2& drawn : loop) {
        const bool isNear = std::any_of(points.begin(), points.end(),
                                        [&](const Point2& p) { return glm::length(p - drawn) < 3; });
        EXPECT_TRUE(isNear) << drawn.x << ", " << drawn.y << " mm: nothing of the mirror is there";
      }
    }
    EXPECT_GT(area, 0);
    EXPECT_LT(area, share * areaOf(convexHull(points)));
    EXPECT_THAT(makeSheetSteps(arrangement, 1)[1].text, HasSubstr("Upright on the blue outline"));
  }
}

TEST(Silhouette, OfABoxIsItsRectangleAndOfARingHasAHole) {
  const auto silhouette = [](const Mesh& mesh) {
    std::vector<glm::dvec2> points;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
      points.push_back({mesh.positions.x[i], mesh.positions.y[i]});
    return makeSilhouette(points, mesh.triangles);
  };
  const std::vector<Loop> box = silhouette(makeBox({30, 20, 5}, 3));
  ASSERT_EQ(box.size(), 1u);
  EXPECT_NEAR(areaOf(box[0]), 600, 3);
  const std::vector<Loop> ring = silhouette(makeTorusKnot(1, 0, 0.2, 64, 16));
  ASSERT_EQ(ring.size(), 2u);
  EXPECT_LT(areaOf(ring[0]) * areaOf(ring[1]), 0) << "the hole runs the other way around";
  EXPECT_TRUE(silhouette({}).empty());
}

}  // namespace
}  // namespace anamorph
