// Whether docs/architecture.md and README.md are true where they name files.

#include <algorithm>
#include <filesystem>
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

// The names in `...` of a page that are files of this project, with what has to be in them: `file: anchor`.
struct Mention {
  std::string file, anchor;
};

std::vector<Mention> mentionsIn(const std::string& page) {
  std::vector<Mention> mentions;
  const std::string text = textOf(sourceFolder / page);
  const std::regex pattern(
      "`((?:src|shaders|tests|docs|assets|levels|third_party)/[^`:\\n]*|README\\.md|\\w+\\.(?:h|cpp))"
      "(?:: ([^`\\n]+))?`");
  for (std::sregex_iterator each(text.begin(), text.end(), pattern), end; each != end; ++each) {
    mentions.push_back({(*each)[1], (*each)[2]});
  }
  return mentions;
}

// The files of the shapes, without ending: what NAME stands for.
Names shapeFiles() {
  Names names;
  const std::string table = textOf(sourceFolder / "src/optics/shape_table.cpp");
  const std::regex include(R"(#include "optics/(\w+)\.h")");
  for (std::sregex_iterator each(table.begin(), table.end(), include), end; each != end; ++each) {
    names.insert((*each)[1]);
  }
  names.erase("shape_table");
  return names;
}

std::string withName(std::string text, const std::string& name) {
  const std::size_t placeholder = text.find("NAME");
  if (placeholder != std::string::npos) text.replace(placeholder, 4, name);
  return text;
}

// Of the file of a shape: what it is called, and whether it has numbers for a shader of its own.
std::string typeOf(const std::string& file) {
  if (file.empty()) return file;
  const std::string code = textOf(sourceFolder / "src/optics" / (file + ".h"));
  const std::regex name(R"re(\*name = "(\w+)")re");
  std::smatch match;
  return std::regex_search(code, match, name) ? match[1].str() : file;
}
bool hasShader(const std::string& file) {
  return textOf(sourceFolder / "src/optics" / (file + ".h")).find("PackedShape packed(") != std::string::npos;
}
bool isOfShader(const std::string& mention) {
  return mention.find("shapes/NAME") != std::string::npos ||
         mention.find("SHAPE_FUNCTIONS") != std::string::npos;
}

// A path, or a mere name of a file somewhere in src/.
bool isThere(const std::string& file) {
  if (file.find('.') != std::string::npos && file.find('/') == std::string::npos && file != "README.md") {
    const fs::recursive_directory_iterator entries(sourceFolder / "src");
    return std::any_of(begin(entries), end(entries),
                       [&](const auto& entry) { return entry.path().filename() == file; });
  }
  return fs::exists(sourceFolder / file);
}

TEST(Documents, NameFilesThatExistAndSayWhatIsSaid) {
  for (const std::string page : {"docs/architecture.md", "README.md"}) {
    const std::vector<Mention> mentions = mentionsIn(page);
    EXPECT_GT(mentions.size(), 15u) << page;
    for (const auto& [file, anchor] : mentions) {
      const bool ofShapes = (file + anchor).find("NAME") != std::string::npos;
      const Names names = ofShapes ? shapeFiles() : Names{""};
      EXPECT_FALSE(names.empty()) << page << ": " << file;
      for (const std::string& name : names) {
        if (isOfShader(file + anchor) && !hasShader(name)) continue;
        const std::string path = withName(file, name), wanted = withName(anchor, typeOf(name));
        EXPECT_TRUE(isThere(path)) << page << " names " << path;
        if (wanted.empty() || !fs::exists(sourceFolder / path)) continue;
        EXPECT_NE(textOf(sourceFolder / path).find(wanted), std::string::npos)
            << page << ": \"" << wanted << "\" is not in " << path;
      }
    }
  }
}

}  // namespace
}  // namespace anamorph
