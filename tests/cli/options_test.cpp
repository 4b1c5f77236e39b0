// Options that mean the same wherever they are: --size, --picture, --json, --language, and `check` and `schema`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "level/json.h"
#include "level/level_json.h"
#include "level/level_library.h"
#include "program.h"
#include "raytrace/png.h"

namespace anamorph {
namespace {

using namespace anamorph::testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

JsonValue jsonOf(const Result& result) {
  return parseJson(result.out, result.err);
}

const JsonValue& at(const JsonValue& json, const std::string& path) {
  const JsonValue* value = findByPath(json, path);
  if (!value) throw Error("nothing there", "", path);
  return *value;
}

TEST(SizeOption, TakesOneNumberOrTwoEverywhere) {
  const TemporaryFolder folder;
  const std::string picture = folder / "p.png";
  struct Case {
    std::string arguments;
    int width, height;
  };
  for (const Case& c :
       {Case{"render 1-plane --samples 1 --size 40", 40, 40},
        Case{"render 1-plane --samples 1 --size 40x30", 40, 30}, Case{"export 1-plane --size 40x24", 40, 24},
        Case{"export 1-plane --size 40", 40, 40}}) {
    ASSERT_EQ(run(c.arguments + " -o " + picture).exitCode, 0) << c.arguments;
    const Bitmap bitmap = loadPng(picture);
    EXPECT_EQ(bitmap.width, c.width) << c.arguments;
    EXPECT_EQ(bitmap.height, c.height) << c.arguments;
  }
  const JsonValue match = jsonOf(run("match 1-plane --json --size 64x48"));
  EXPECT_EQ(at(match, "/width").number, 64);
  EXPECT_EQ(at(match, "/height").number, 48);
  EXPECT_EQ(at(jsonOf(run("match 1-plane --json --size 64")), "/width").number, 64);
  EXPECT_THAT(run("match 1 --size 64y").err,
              HasSubstr("--size: expected N or WIDTHxHEIGHT with sides from 1 to 8192, got 64y"));
}

TEST(PictureOption, HasAnOldName) {
  const TemporaryFolder folder;
  for (const std::string command : {"render 2-cylinder --size 48 -o ", "export 2-cylinder --size 48 -o "}) {
    for (const char* name : {"new", "old", "other"}) {
      const char* option = name[0] == 'n' ? " --picture original" : name[1] == 'l' ? " --view original" : "";
      ASSERT_EQ(run(command + (folder / name) + ".png" + option).exitCode, 0);
    }
    EXPECT_EQ(readAll(folder / "new.png"), readAll(folder / "old.png"));
    EXPECT_NE(readAll(folder / "new.png"), readAll(folder / "other.png"));
  }
}

TEST(JsonOption, IsOneObjectOfEveryCommand) {
  const TemporaryFolder folder;
  const JsonValue render =
      jsonOf(run("render 1-plane --samples 1 --size 40x30 --json -o " + (folder / "p.png")));
  EXPECT_THAT(render.keys, ElementsAre("path", "picture", "width", "height"));
  EXPECT_EQ(at(render, "/height").number, 30);
  EXPECT_EQ(at(render, "/picture").text, "reflection");

  const JsonValue levels = jsonOf(run("levels --json"));
  EXPECT_EQ(at(levels, "/levels/1/name").text, "1-plane");
  EXPECT_EQ(at(levels, "/levels/1/title").text, "The plane mirror");
  const JsonValue drawn = jsonOf(run("levels --json --size 64 -o " + (folder / "out")));
  EXPECT_EQ(at(drawn, "/levels/2/match/grade").text, "excellent");
  EXPECT_TRUE(std::filesystem::exists(at(drawn, "/levels/2/picture").text));

  const Result checked = run("check --json 1-plane nothing.obj " ANAMORPH_TEST_DATA "/meshes/cube.obj");
  EXPECT_EQ(checked.exitCode, 1);
  const JsonValue check = jsonOf(checked);
  EXPECT_THAT(at(check, "/files/0/summary").text, HasSubstr("match excellent"));
  EXPECT_THAT(at(check, "/files/1/faults/0/message").text, HasSubstr("cannot open"));
  EXPECT_THAT(at(check, "/files/2/summary").text, HasSubstr("8 vertices"));
  EXPECT_EQ(at(check, "/withFaults").number, 1);
  EXPECT_EQ(run("render 1-plane --json -o -").exitCode, 2) << "standard output is taken";
}

TEST(LanguageOption, IsOfSheetAndReport) {
  const TemporaryFolder folder;
  for (const char* language : {"en", "nl"}) {
    ASSERT_EQ(run("export 1-plane --size 32 --language " + std::string(language) + " -o " +
                  (folder / language) + ".html")
                  .exitCode,
              0);
  }
  EXPECT_NE(readAll(folder / "en.html"), readAll(folder / "nl.html"));
  EXPECT_THAT(readAll(folder / "nl.html"), HasSubstr("uitstekend"));
  const Result unknown = run("export 1-plane --check --language xx");
  EXPECT_EQ(unknown.exitCode, 2);
  EXPECT_THAT(unknown.err, HasSubstr("--language: expected en or nl, got xx"));
}

TEST(CheckCommand, TellsAllFaultsWithTheirPlaces) {
  const TemporaryFolder folder;
  std::string level = readAll(std::string(ANAMORPH_LEVELS) + "/1-plane.json");
  const auto replace = [&](const std::string& from, const std::string& to) {
    ASSERT_NE(level.find(from), std::string::npos) << from;
    level.replace(level.find(from), from.size(), to);
  };
  replace("\"widget\": \"Eye\"", "\"widget\": \"Eie\"");
  replace("\"vertex\": ", "\"vertex\": 9");
  writeText(folder / "lesson.json", level);
  const Result lesson = run("check " + (folder / "lesson.json"));
  EXPECT_EQ(lesson.exitCode, 1);
  EXPECT_THAT(lesson.err,
              HasSubstr("/show/widget: expected the English name of a control, got \"Eie\"; did you mean "
                        "\"Eye\"?\n"));
  EXPECT_THAT(lesson.err,
              HasSubstr("/show/play/vertex: expected one of the original's vertices, 0 to 6145, got 9"));
  EXPECT_THAT(lesson.err, HasSubstr("lesson.json: line "));
  EXPECT_EQ(std::count(lesson.err.begin(), lesson.err.end(), '\n'), 3) << lesson.err;
  EXPECT_EQ(run("match --size 32 " + (folder / "lesson.json")).exitCode, 0) << "it can be used all the same";

  replace("\"type\": \"plane\"", "\"type\": \"plain\"");
  replace("\"fovDegrees\": ", "\"fovDegrees\": 9");
  writeText(folder / "level.json", level);
  for (const char* command : {"check ", "match "}) {
    const Result faults = run(command + (folder / "level.json"));
    EXPECT_EQ(faults.exitCode, 1);
    EXPECT_THAT(faults.err, HasSubstr("got \"plain\"; did you mean \"plane\"?\n"));
    EXPECT_THAT(faults.err, HasSubstr("fovDegrees: expected a number from 1 to 170, got 9"));
  }
  const JsonValue json = jsonOf(run("check --json " + (folder / "level.json")));
  EXPECT_THAT(at(json, "/files/0/faults/0/where").text, HasSubstr("line "));
}

TEST(CheckCommand, FindsNoFaultInTheInstalledLevels) {
  for (const LevelEntry& entry : listLevels(ANAMORPH_LEVELS)) {
    const Result result = run("check " + entry.name);
    EXPECT_EQ(result.exitCode, 0) << result.err;
  }
}

TEST(SchemaCommand, PrintsWhatTheReaderTakes) {
  const Result result = run("schema");
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.out, formatLevelSchema());
  EXPECT_EQ(result.err, "");
}

}  // namespace
}  // namespace anamorph
