// The table of export formats: complete, unambiguous, and what README says.

#include "exports/export_formats.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/folder.h"
#include "base/text.h"
#include "geometry/mesh_files.h"

namespace anamorph {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string readme() {
  std::ifstream file(ANAMORPH_SOURCE_DIR "/README.md");
  return {std::istreambuf_iterator<char>(file), {}};
}

// What stands between ` and `, up to its first blank or =: "--page", ".stl", ".obj".
std::vector<std::string> codeWords(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream parts(text);
  bool inside = false;
  for (std::string part; std::getline(parts, part, '`'); inside = !inside) {
    std::istringstream code(part);
    for (std::string word; inside && code >> word;) {
      if (word.starts_with(".") || word.starts_with("--")) words.push_back(word);
    }
  }
  return words;
}

struct ReadmeRow {
  std::vector<std::string> endings;
  std::string what;
  std::set<std::string> options;
};

// The rows of README's table of exports.
std::vector<ReadmeRow> readmeRows() {
  std::istringstream text(readme());
  std::string line;
  while (std::getline(text, line) && line != "| ending | what | options |") {
  }
  std::getline(text, line);  // |---|---|---|
  std::vector<ReadmeRow> rows;
  while (std::getline(text, line) && line.starts_with("|")) {
    for (std::size_t at; (at = line.find("\\|")) != std::string::npos;) line.replace(at, 2, "/");
    std::istringstream cells(line);
    std::string none, endings, what, options;
    std::getline(cells, none, '|');
    std::getline(cells, endings, '|');
    std::getline(cells, what, '|');
    std::getline(cells, options, '|');
    const auto words = codeWords(options);
    rows.push_back({codeWords(endings), what, {words.begin(), words.end()}});
  }
  return rows;
}

// The options of the command line that README names in a format's row. The scale is explained below the table, the
// print check needs no option.
std::vector<std::string> flagsOf(ExportOption option) {
  switch (option) {
    case ExportOption::basePlate:
      return {"--base-plate", "--plate-margin"};
    case ExportOption::page:
      return {"--page", "--scale"};
    case ExportOption::raysOf:
      return {"--rays"};
    case ExportOption::picture:
      return {"--picture"};
    case ExportOption::pictureSize:
    case ExportOption::comparedSize:
      return {"--size"};
    case ExportOption::millimetres:
    case ExportOption::printCheck:
      break;
  }
  return {};
}

TEST(ExportFormats, AreOneForEachKindInOrder) {
  const auto& formats = exportFormats();
  ASSERT_EQ(formats.size(), static_cast<std::size_t>(ExportKind::picture) + 1);
  std::set<std::string> names, titles, fileNames;
  for (std::size_t i = 0; i < formats.size(); ++i) {
    const ExportFormat& format = formats[i];
    EXPECT_EQ(format.kind, static_cast<ExportKind>(i));
    EXPECT_EQ(&formatOf(format.kind), &format);
    EXPECT_TRUE(format.write && *format.help && !format.options.empty()) << format.name;
    EXPECT_TRUE(hasEnding(format, format.fileName)) << format.fileName;
    names.insert(format.name);
    titles.insert(format.title);
    fileNames.insert(format.fileName);
  }
  EXPECT_EQ(names.size(), formats.size());
  EXPECT_EQ(titles.size(), formats.size()) << "the file browser knows them by it";
  EXPECT_EQ(fileNames.size(), formats.size());
}

TEST(ExportFormats, AnEndingAsksForOne) {
  for (const ExportFormat& format : exportFormats()) {
    for (const char* ending : format.endings) {
      const auto found = findExportKind(std::string("a") + ending);
      ASSERT_TRUE(found) << ending;
      EXPECT_EQ(*found == format.kind, format.askedBy == nullptr) << ending;
    }
  }
  EXPECT_EQ(findExportKind("a.OBJ"), ExportKind::sculpture);
  EXPECT_EQ(findExportKind("a.xyz"), std::nullopt);
  EXPECT_EQ(findExportKind("pdf"), std::nullopt);
  for (const char* ending : formatOf(ExportKind::sculpture).endings) {
    EXPECT_TRUE(isMeshFile(std::string("a") + ending)) << ending;
  }
}

TEST(ExportFormats, ListTheirEndingsInWords) {
  EXPECT_EQ(exportEndings(ExportKind::sculpture), ".obj, .stl or .ply");
  EXPECT_EQ(exportEndings(ExportKind::viewingSheet), ".pdf or .svg");
  EXPECT_EQ(exportEndings(ExportKind::picture), ".png");
  EXPECT_EQ(alternatives({}), "");
}

TEST(ExportFormats, AreReadmesTable) {
  const std::vector<ReadmeRow> rows = readmeRows();
  const auto& formats = exportFormats();
  ASSERT_EQ(rows.size(), formats.size());
  for (std::size_t i = 0; i < formats.size(); ++i) {
    const ExportFormat& format = formats[i];
    SCOPED_TRACE(format.name);
    std::vector<std::string> endings(format.endings.begin(), format.endings.end());
    if (format.askedBy) endings.emplace_back(format.askedBy);
    EXPECT_EQ(rows[i].endings, endings);
    EXPECT_THAT(rows[i].what, HasSubstr(lowerCase(format.name)));
    std::set<std::string> flags;
    for (const ExportOption option : format.options) {
      for (const std::string& flag : flagsOf(option)) flags.insert(flag);
    }
    EXPECT_EQ(rows[i].options, flags);
  }
}

TEST(ExportFormats, HaveTheirScaleWhereReadmeSaysSo) {
  std::vector<std::string> scaled;
  for (const ExportFormat& format : exportFormats()) {
    if (format.has(ExportOption::millimetres)) scaled.emplace_back(lowerCase(format.name));
  }
  ASSERT_THAT(scaled, ElementsAre("sculpture", "viewing sheet", "rays"));
  EXPECT_THAT(readme(), HasSubstr("`--mm-per-unit N` (10) holds for sculpture, sheet and rays."));
}

}  // namespace
}  // namespace anamorph
