// What the compiler does not ask for: the rooms of src/ and the direction of their #includes (a room includes only
// rooms above it, no two files include each other in a ring, third-party headers appear only where they belong), who
// may name a mirror shape, how tests are skipped.

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

#include "source_text.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

struct Room {
  Names rooms;       // it may include these rooms
  Names thirdParty;  // and headers that begin with these
};

const std::map<std::string, Room> rooms{
    {"base", {{}, {"fmt/"}}},
    {"math", {{"base"}, {"glm/", "fmt/"}}},
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
     {{"base", "math", "geometry", "optics", "level", "anamorphosis", "raytrace", "pipeline", "exports",
       "edit"},
      {"glm/", "fmt/", "imgui"}}},
    {"app",
     {{"base", "math", "geometry", "optics", "level", "anamorphosis", "raytrace", "pipeline", "exports",
       "edit", "cli", "gl", "viewport", "panels"},
      {"glm/", "fmt/", "CLI/", "imgui", "backends/imgui", "glad/", "GLFW/", "fontconfig/"}}},
    {"cli",
     {{"base", "math", "geometry", "optics", "level", "anamorphosis", "raytrace", "pipeline", "exports"},
      {"glm/", "fmt/", "CLI/"}}},
};
const Names wrappedInOneFile{"tiny_obj_loader.h", "nlohmann/", "stb_", "EGL/", "fontconfig/", "cairo"};
const Names otherLibraries{
    "glm/", "fmt/",   "CLI/",   "tiny_obj_loader.h", "nlohmann/",   "stb_", "imgui", "GLFW/", "glad/",
    "EGL/", "embree", "gtest/", "backends/imgui",    "fontconfig/", "cairo"};

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
  const fs::path src = sourceFolder / "src";
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
  for (const auto& entry : fs::directory_iterator(sourceFolder / "src")) {
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

// A file is a unit with its header: edit/session.h and edit/session.cpp are edit/session.
std::string unitOf(const fs::path& file) {
  return fs::path(file).replace_extension().generic_string();
}

using Graph = std::map<std::string, Names>;

Graph unitsAndTheirIncludes() {
  Graph graph;
  const fs::path src = sourceFolder / "src";
  for (const Include& include : allIncludes()) {
    if (!include.own) continue;
    const std::string unit = unitOf(include.file.lexically_relative(src)), target = unitOf(include.header);
    if (unit != target) graph[unit].insert(target);
  }
  return graph;
}

Names reachableFrom(const std::string& unit, const Graph& graph) {
  Names reached;
  std::vector<std::string> next{unit};
  while (!next.empty()) {
    const auto found = graph.find(next.back());
    next.pop_back();
    if (found == graph.end()) continue;
    for (const std::string& target : found->second) {
      if (reached.insert(target).second) next.push_back(target);
    }
  }
  return reached;
}

// The groups of units that all include each other, directly or by way of others.
std::vector<Names> ringsIn(const Graph& graph) {
  Graph reachable;
  for (const auto& [unit, targets] : graph) reachable[unit] = reachableFrom(unit, graph);
  const auto reaches = [&](const std::string& from, const std::string& to) {
    const auto found = reachable.find(from);
    return found != reachable.end() && found->second.count(to) != 0;
  };
  std::vector<Names> rings;
  Names seen;
  for (const auto& [unit, targets] : reachable) {
    if (!reaches(unit, unit) || seen.count(unit) != 0) continue;
    Names ring;
    for (const std::string& target : targets) {
      if (reaches(target, unit)) ring.insert(target);
    }
    seen.insert(ring.begin(), ring.end());
    rings.push_back(ring);
  }
  return rings;
}

TEST(Rings, AreFoundWhereTheyAre) {
  EXPECT_TRUE(ringsIn({{"a", {"b", "c"}}, {"b", {"c"}}}).empty());
  EXPECT_EQ(ringsIn({{"a", {"b"}}, {"b", {"c"}}, {"c", {"b", "d"}}, {"d", {}}, {"e", {"f"}}, {"f", {"e"}}}),
            (std::vector<Names>{{"b", "c"}, {"e", "f"}}));
}

TEST(Architecture, NoFilesIncludeEachOtherInARing) {
  const Graph graph = unitsAndTheirIncludes();
  EXPECT_GT(graph.size(), 100u);
  for (const Names& ring : ringsIn(graph)) {
    std::string text;
    for (const std::string& unit : ring) {
      for (const std::string& target : graph.at(unit)) {
        if (ring.count(target) != 0) text += "\n  " + unit + " includes " + target;
      }
    }
    ADD_FAILURE() << ring.size() << " files in a ring:" << text;
  }
}

// Whoever asks which shape a mirror has would have to be changed for every new one: they ask the shape instead.
TEST(Architecture, OnlyOpticsNamesAMirrorShape) {
  const fs::path src = sourceFolder / "src";
  Names shapes;
  const std::string table = textOf(src / "optics/shape_table.cpp");
  const std::regex line(R"(shapeType<(\w+)>)");
  for (std::sregex_iterator each(table.begin(), table.end(), line), end; each != end; ++each) {
    shapes.insert((*each)[1]);
  }
  EXPECT_GE(shapes.size(), 3u) << "they stand in the table as shapeType<Name>()";
  shapes.insert(
      {"PlaneMirror", "CylinderMirror", "SphereMirror", "ConeMirror"});  // even if they are not in it
  // The default level is a certain one, and scenes of the thesis know three.
  const Names allowed{"level/level.h", "level/scene_file.cpp"};
  const std::regex word(R"(\w+)");
  for (const auto& entry : fs::recursive_directory_iterator(src)) {
    const std::string file = entry.path().lexically_relative(src).generic_string();
    if (!entry.is_regular_file() || file.starts_with("optics/") || allowed.count(file) != 0) continue;
    const std::string code = textOf(entry.path());
    Names named;
    for (std::sregex_iterator each(code.begin(), code.end(), word), end; each != end; ++each) {
      if (shapes.count(each->str()) != 0) named.insert(each->str());
    }
    EXPECT_EQ(named, Names{}) << "src/" << file;
  }
}

// The same for their files and names: #include "optics/cylinder.h", "cylinder", shaders/shapes/cylinder.glsl.
TEST(Architecture, OnlyOpticsKnowsTheNamesOfShapes) {
  Names shapes;
  for (const auto& entry : fs::directory_iterator(sourceFolder / "shaders/shapes")) {
    const std::string name = entry.path().stem().string();
    if (name != "none") shapes.insert(name);
  }
  EXPECT_GE(shapes.size(), 3u);
  const Names allowed{"src/level/level.h", "src/level/scene_file.cpp",
                      "src/panels/figures.cpp"};  // whose drawings have names
  const std::regex comment("//[^\n]*");
  for (const char* folder : {"src", "shaders"}) {
    for (const auto& entry : fs::recursive_directory_iterator(sourceFolder / folder)) {
      const std::string file = entry.path().lexically_relative(sourceFolder).generic_string();
      const bool home = file.starts_with("src/optics/") || file.starts_with("shaders/shapes/");
      if (!entry.is_regular_file() || home || allowed.count(file) != 0) continue;
      const std::string code = std::regex_replace(textOf(entry.path()), comment, "");
      for (const std::string& shape : shapes) {
        EXPECT_EQ(code.find("optics/" + shape + ".h"), std::string::npos) << file;
        EXPECT_EQ(code.find("shapes/" + shape + ".glsl"), std::string::npos) << file;
        const bool alsoAnOriginal = shape == "sphere";
        EXPECT_TRUE(alsoAnOriginal || code.find('"' + shape + '"') == std::string::npos)
            << file << ": " << shape;
      }
    }
  }
}

// Whatever is to last goes through AtomicFile: a second way would lose what a full disk or a power cut meets.
TEST(Architecture, FilesAreWrittenOneWay) {
  const fs::path src = sourceFolder / "src";
  const Names allowed{"base/atomic_file.cpp",  "base/temporary_file.cpp",  // the way itself
                      "base/file.cpp",         "base/folder.cpp",          // they open to read, and to flush
                      "app/file_lock.cpp",                                 // locks, which hold nothing
                      "app/crash_handler.cpp",                             // may not allocate
                      "app/state_log.h"};  // a log for those who watch; nobody's work
  const std::regex writing(
      R"(\b(ofstream|fstream|fopen|freopen|creat|open64|renameat|copy_file|resize_file)\b|\W::open\(|\brename\()");
  for (const auto& entry : fs::recursive_directory_iterator(src)) {
    const std::string file = entry.path().lexically_relative(src).generic_string();
    if (!entry.is_regular_file() || allowed.count(file) != 0) continue;
    const std::string code = std::regex_replace(textOf(entry.path()), std::regex("#include <fstream>"), "");
    std::smatch found;
    EXPECT_FALSE(std::regex_search(code, found, writing)) << "src/" << file << ": " << found.str();
  }
}

TEST(Architecture, TestsAreSkippedByOneFunction) {
  const fs::path tests = sourceFolder / "tests";
  const std::regex skip(R"(\bGTEST_SKIP\(\)(.*))");
  for (const auto& entry : fs::recursive_directory_iterator(tests)) {
    const fs::path name = entry.path().filename();
    if (!entry.is_regular_file() || name == "cannot_run_here.h" || name == "architecture_test.cpp") continue;
    const std::string code = textOf(entry.path());
    for (std::sregex_iterator each(code.begin(), code.end(), skip), end; each != end; ++each) {
      EXPECT_NE(each->str(1).find("\"root may "), std::string::npos)
          << entry.path() << ": return cannotRunHere(...) instead, which fails where CI=true";
    }
  }
}

TEST(Architecture, FilesStaySmall) {
  for (const auto& entry : fs::recursive_directory_iterator(sourceFolder / "src")) {
    if (!entry.is_regular_file()) continue;
    std::ifstream file(entry.path());
    const auto lines = std::count(std::istreambuf_iterator<char>(file), {}, '\n');
    EXPECT_LE(lines, 400) << entry.path();
  }
}

}  // namespace
}  // namespace anamorph
