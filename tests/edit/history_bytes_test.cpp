// What a long history takes: counted, not guessed from the process.

#include "edit/history_bytes.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/program.h"
#include "edit/session.h"
#include "geometry/normals.h"
#include "geometry/shapes.h"
#include "level/level_json.h"
#include "long_lesson.h"
#include "optics/mesh_mirror.h"
#include "optics/patch.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;
using namespace testing;

constexpr std::size_t mebibyte = std::size_t{1} << 20;

Level withLesson(std::size_t bytes, char letter = 'x') {
  Level level;
  level.text.edit([&](LevelText& text) { text.lesson = std::string(bytes, letter); });
  return level;
}

Level withDepth(Level level, int number) {
  level.sculpture.depthScale = 1 + number;
  return level;
}

TEST(HistoryBytes, CountWhatIsSharedOnce) {
  const Level a = withLesson(mebibyte);
  const std::vector<Level> copies(10, a);
  EXPECT_GE(bytesOf(copies), mebibyte);
  EXPECT_LT(bytesOf(copies), mebibyte + 20000);
  std::vector<Level> apart;
  for (int i = 0; i < 10; ++i) apart.push_back(withLesson(mebibyte));
  EXPECT_GE(bytesOf(apart), 10 * mebibyte);
  for (Level& level : apart) shareText(level, {apart.data(), 1});
  EXPECT_LT(bytesOf(apart), mebibyte + 20000);
}

TEST(HistoryBytes, TellHowManyOfTheNewestFit) {
  std::vector<Level> levels;
  for (char letter = 'a'; letter < 'k'; ++letter) levels.push_back(withLesson(mebibyte, letter));
  EXPECT_EQ(countWithin(levels, 100 * mebibyte), 10u);
  EXPECT_EQ(countWithin(levels, 3 * mebibyte + mebibyte / 2), 3u);
  EXPECT_EQ(countWithin(levels, 0), 1u);
  EXPECT_EQ(countWithin({}, 0), 0u);
}

// A lesson of a megabyte, and a mesh of some: the history has neither of them sixty times.
TEST(HistoryBytes, OfSixtyDragsAreThoseOfOneLessonAndNoMesh) {
  const TemporaryFolder folder;
  std::string mesh;
  for (int i = 0; i < 60000; ++i) {
    const std::string n = std::to_string(i);
    mesh += "v " + n + " 0 0\nv " + n + " 1 0\nv " + n + " 0 1\nf -3 -2 -1\n";
  }
  writeText(folder / "mesh.obj", mesh);
  Level level = withLesson(0);
  level.text.edit([](LevelText& text) { text.lesson = testing::longLesson(); });
  level.original.shape = FileShape{"mesh.obj"};
  saveLevel(folder / "level.json", level);
  Session session;
  session.open(folder / "level.json");
  for (int drag = 0; drag < 60; ++drag) {
    for (int frame = 0; frame < 20; ++frame) {
      session.change(withDepth(session.level(), 20 * drag + frame));
    }
    session.finishChange();
  }
  EXPECT_GE(session.historyBytes(), testing::longLesson().size());
  EXPECT_LT(session.historyBytes(), mebibyte + 60 * 10000);
}

TEST(HistoryBytes, OfEqualWordsThatComeFromElsewhereAreOnce) {
  Session session;
  session.startNew(withLesson(mebibyte));
  for (int i = 0; i < 40; ++i) session.edit(withDepth(withLesson(mebibyte, i % 2 ? 'x' : 'y'), i));  // pasted
  EXPECT_LT(session.historyBytes(), 2 * mebibyte + 40 * 10000);
}

TEST(HistoryBytes, CountTheMirrorsThatAreNotShared) {
  PatchMirror patch;
  patch.heights = {64, std::vector<double>(64 * 64, 0.0)};
  Level level;
  level.optic.shape() = patch;
  const std::size_t one = bytesOf(std::vector<Level>{level});
  EXPECT_GT(one, 64 * 64 * sizeof(PatchMirror::Cell));
  EXPECT_LT(bytesOf(std::vector<Level>(10, level)), 2 * one) << "they are the same one";
  std::vector<Level> apart;
  for (int i = 0; i < 10; ++i) {
    patch.heights.heights[0] = i;
    level.optic.shape() = patch;
    apart.push_back(level);
  }
  EXPECT_GT(bytesOf(apart), 9 * one);

  level.optic.shape() =
      MeshMirror{{"a.obj", std::make_shared<const SmoothMesh>(withSmoothNormals(makeSphere(1, 96))), {}}, {}};
  std::vector<Level> moved;
  for (int i = 0; i < 10; ++i) {
    moved.push_back(level);
    level.optic.shape() = mapShape(level.optic.shape(), {[](const Point& p) { return p + Vector(1, 0, 0); }});
  }
  const std::size_t first = bytesOf(std::span(moved).first(1));
  EXPECT_GT(first, 96 * 48 * sizeof(Point));
  EXPECT_LT(bytesOf(moved), 2 * first) << "all have the mesh of the file";
}

TEST(HistoryBytes, HaveALimit) {
  Session session;
  for (int i = 0; i < 300; ++i) {
    Level level = withDepth(withLesson(2 * mebibyte), i);
    level.text.edit([&](LevelText& text) { text.title = std::to_string(i); });
    session.edit(level);
    ASSERT_LE(session.historyBytes(), Session::maxHistoryBytes) << i;
  }
  int steps = 0;
  for (; session.canUndo(); session.undo()) ++steps;
  EXPECT_GT(steps, 100) << "as many as there is room for";
  EXPECT_LT(steps, 128);
  EXPECT_LE(session.historyBytes(), Session::maxHistoryBytes + 3 * mebibyte) << "one is the level itself";
  for (; session.canRedo(); session.redo()) --steps;
  EXPECT_EQ(steps, 0);
  EXPECT_EQ(session.level().sculpture.depthScale, 300) << "the newest are kept";
}

}  // namespace
}  // namespace anamorph
