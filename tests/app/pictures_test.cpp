// The pictures of the documentation are what the program draws today: each is made anew by the command in
// docs/pictures.txt and compared.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cannot_run_here.h"
#include "cli/program.h"
#include "level/level_library.h"
#include "raytrace/png.h"

namespace anamorph {
namespace {

using namespace anamorph::testing;

struct Picture {
  std::string file, arguments;
};

void PrintTo(const Picture& picture, std::ostream* out) {
  *out << picture.file;
}

std::vector<Picture> pictures() {
  std::vector<Picture> all;
  std::ifstream list(std::string(ANAMORPH_SOURCE_DIR) + "/docs/pictures.txt");
  for (std::string line; std::getline(list, line);) {
    std::istringstream words(line);
    Picture picture;
    words >> picture.file >> std::ws;
    std::getline(words, picture.arguments);
    if (!picture.file.empty() && picture.file[0] != '#') all.push_back(picture);
  }
  return all;
}

const std::filesystem::path root = ANAMORPH_SOURCE_DIR;

// What is shown in README.md or the guide, or lies where pictures lie, is in the list; every level has a picture.
TEST(DocumentPictures, AreAllInTheList) {
  std::set<std::string> listed, wanted;
  for (const Picture& picture : pictures()) EXPECT_TRUE(listed.insert(picture.file).second) << picture.file;
  for (const char* folder : {"assets/pictures", "docs/pictures"}) {
    for (const auto& entry : std::filesystem::directory_iterator(root / folder)) {
      wanted.insert(folder + ("/" + entry.path().filename().string()));
    }
  }
  for (const LevelEntry& level : listLevels(root / "levels"))
    wanted.insert("assets/pictures/" + level.name + ".png");
  for (const char* page : {"README.md", "docs/guide.md"}) {
    const std::string text = readAll(root / page);
    const std::regex picture(R"(\]\(([^)]*\.png)\))");
    for (std::sregex_iterator each(text.begin(), text.end(), picture), end; each != end; ++each) {
      const std::filesystem::path path = (root / page).parent_path() / each->str(1);
      wanted.insert(path.lexically_normal().lexically_relative(root).generic_string());
    }
  }
  EXPECT_EQ(listed, wanted);
}

class DocumentPicture : public ::testing::TestWithParam<Picture> {};

TEST_P(DocumentPicture, IsWhatTheProgramDraws) {
  const Picture& picture = GetParam();
  const TemporaryFolder folder;
  const std::string made = folder / "made.png";
  std::filesystem::current_path(root);  // as docs/make_pictures.sh, for levels that are named by their path
  const Result result = run(picture.arguments + " -o " + made);
  if (result.err.find("no picture can be drawn here") != std::string::npos) return cannotRunHere(result.err);
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const Bitmap now = loadPng(made), kept = loadPng(root / picture.file);
  ASSERT_EQ(now.width, kept.width);
  ASSERT_EQ(now.height, kept.height);
  ASSERT_EQ(now.bytes.size(), kept.bytes.size());
  double sum = 0;
  std::size_t far = 0;
  for (std::size_t i = 0; i < now.bytes.size(); ++i) {
    const int difference = std::abs(int(now.bytes[i]) - int(kept.bytes[i]));
    sum += difference;
    far += difference > 32;
  }
  const auto count = static_cast<double>(now.bytes.size());
  EXPECT_LT(sum / count, 1.0) << "docs/make_pictures.sh makes them anew; look at them then";
  EXPECT_LT(static_cast<double>(far) / count, 0.005);
}

INSTANTIATE_TEST_SUITE_P(Documents, DocumentPicture, ::testing::ValuesIn(pictures()), [](const auto& each) {
  std::string name = each.param.file;
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
});

}  // namespace
}  // namespace anamorph
