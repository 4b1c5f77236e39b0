// The rooms of src/ and the direction of their #includes: a room includes only rooms above it, and
// third-party headers appear only where they belong.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

struct Room {
  Names rooms;       // it may include these rooms
  Names thirdParty;  // and headers that begin with these
};

const std::map<std::string, Room> rooms{
    {"base", {{}, {}}},
    {"math", {{"base"}, {"glm/"}}},
    {"geometry", {{"base", "math"}, {"glm/", "fmt/", "tiny_obj_loader.h"}}},
    {"optics", {{"base", "math", "geometry"}, {"glm/", "fmt/"}}},
    {"level", {{"base", "math", "geometry", "optics"}, {"glm/", "fmt/", "nlohmann/"}}},
    {"anamorphosis", {{"base", "math", "geometry", "optics"}, {"glm/", "fmt/"}}},
    {"raytrace", {{"base", "math", "geometry", "optics"}, {"glm/", "fmt/", "stb_"}}},
    {"pipeline",
     {{"base", "math", "geometry", "optics", "level", "anamorphosis", "raytrace"}, {"glm/", "fmt/"}}},
    {"exports",
     {{"base", "math", "geometry", "optics", "level", "anamorphosis", "raytrace", "pipeline"},
      {"glm/", "fmt/", "cairo"}}},
    {"edit",
     {{"base", "math", "geometry", "optics", "level", "anamorphosis", "raytrace", "pipeline", "exports"},
      {"glm/", "fmt/"}}},
    {"gl", {{"base", "math"}, {"glm/", "fmt/", "glad/", "EGL/"}}},
    {"viewport",
     {{"base", "math", "geometry", "optics", "level", "anamorphosis", "raytrace", "pipeline", "edit", "gl"},
      {"glm/", "fmt/", "glad/"}}},
    {"panels",
     {{"base", "math", "geometry", "optics", "level", "anamorphosis", "raytrace", "pipeline", "exports", "edit"},
      {"glm/", "fmt/", "imgui"}}},
    {"app",
     {{"base", "math", "geometry", "optics", "level", "anamorphosis", "raytrace", "pipeline", "exports", "edit", "cli",
       "gl", "viewport", "panels"},
      {"glm/", "fmt/", "CLI/", "imgui", "backends/imgui", "glad/", "GLFW/", "fontconfig/"}}},
    {"cli",
     {{"base", "math", "geometry", "optics", "level", "anamorphosis", "raytrace", "pipeline", "exports"},
      {"glm/", "fmt/", "CLI/"}}},
};
const Names wrappedInOneFile{"tiny_obj_loader.h", "nlohmann/", "stb_", "EGL/", "fontconfig/", "cairo"};
const Names otherLibraries{"glm/",      "fmt/", "CLI/",   "tiny_obj_loader.h",
                           "nlohmann/", "stb_", "imgui",  "GLFW/",
                           "glad/",     "EGL/", "embree", "gtest/",
                           "backends/imgui", "fontconfig/", "cairo"};

bool startsWithOne(const std::string& text, const Names& beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](const std::string& beginning) { return text.starts_with(beginning); });
}

struct Include {
  fs::path file;
  std::string room;
  std::string header;
  bool own;  // in quotes
};

std::vector<Include> allIncludes() {
  std::vector<Include> includes;
  const fs::path src = fs::path(ANAMORPH_SOURCE_DIR) / "src";
  const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  for (const auto& [room, allowed] : rooms) {
    for (const auto& entry : fs::recursive_directory_iterator(src / room)) {
      if (!entry.is_regular_file()) continue;
      std::ifstream file(entry.path());
      for (std::string line; std::getline(file, line);) {
        std::smatch match;
        if (std::regex_search(line, match, pattern)) {
          includes.push_back({entry.path(), room, match[2], match[1] == "\""});
        }
      }
    }
  }
  return includes;
}

TEST(Architecture, EveryFolderOfSrcIsAKnownRoom) {
  for (const auto& entry : fs::directory_iterator(fs::path(ANAMORPH_SOURCE_DIR) / "src")) {
    EXPECT_TRUE(!entry.is_directory() || rooms.count(entry.path().filename()) > 0) << entry.path();
  }
}

TEST(Architecture, RoomsIncludeOnlyRoomsAboveThem) {
  std::size_t seen = 0;
  for (const Include& include : allIncludes()) {
    if (!include.own) continue;
    ++seen;
    const std::string target = include.header.substr(0, include.header.find('/'));
    EXPECT_TRUE(target == include.room || rooms.at(include.room).rooms.count(target))
        << include.file << " includes " << include.header;
  }
  EXPECT_GT(seen, 100u);
}

TEST(Architecture, ThirdPartyHeadersStayWhereTheyBelong) {
  std::map<std::string, Names> filesOfWrapped;
  for (const Include& include : allIncludes()) {
    if (include.own || !startsWithOne(include.header, otherLibraries)) continue;
    EXPECT_TRUE(startsWithOne(include.header, rooms.at(include.room).thirdParty))
        << include.file << " includes " << include.header;
    for (const std::string& wrapped : wrappedInOneFile) {
      if (include.header.starts_with(wrapped)) filesOfWrapped[wrapped].insert(include.file);
    }
  }
  for (const auto& [wrapped, files] : filesOfWrapped) {
    EXPECT_EQ(files.size(), 1u) << wrapped << " is to be known to one file only";
    EXPECT_EQ(fs::path(*files.begin()).extension(), ".cpp") << *files.begin();
  }
  EXPECT_EQ(filesOfWrapped.size(), wrappedInOneFile.size());
}

TEST(Architecture, FilesStaySmall) {
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(ANAMORPH_SOURCE_DIR) / "src")) {
    if (!entry.is_regular_file()) continue;
    std::ifstream file(entry.path());
    const auto lines = std::count(std::istreambuf_iterator<char>(file), {}, '\n');
    EXPECT_LE(lines, 400) << entry.path();
  }
}

}  // namespace
