#include "exports/export_level.h"

#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "anamorphosis/vertex_ray.h"
#include "base/error.h"
#include "cli/program.h"
#include "error_text.h"
#include "exports/export_formats.h"
#include "exports/match_report_files.h"
#include "exports/printable.h"
#include "exports/ray_file.h"
#include "finished.h"
#include "geometry/mesh_files.h"
#include "in_dutch.h"
#include "math/palette.h"
#include "pipeline/stages.h"
#include "raytrace/png.h"

namespace anamorph {
namespace {

using namespace anamorph::testing;
using ::testing::HasSubstr;
using ::testing::Not;

ExportRequest requestFor(const std::string& path) {
  ExportRequest request;
  request.kind = *findExportKind(path);
  request.path = path;
  request.size = 48;
  return request;
}

// Points and lines of an OBJ file.
struct ObjLineFile {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> lines;
};

ObjLineFile parse(const std::string& text) {
  ObjLineFile file;
  std::istringstream rows(text);
  for (std::string row; std::getline(rows, row);) {
    std::istringstream words(row);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      Point p;
      words >> p.x >> p.y >> p.z;
      file.points.push_back(p);
    } else if (kind == "l") {
      file.lines.emplace_back();
      for (std::size_t index; words >> index;) file.lines.back().push_back(index);
    } else {
      EXPECT_TRUE(kind == "o" || kind == "#") << row;
    }
  }
  return file;
}

TEST(Export, VertexRaysAreThoseOfTheMap) {
  for (const char* name : {"1-plane", "2-cylinder", "3-sphere"}) {
    const LevelResult& finished = finishedLevel(name);
    const Level& level = finished.level;
    const PointArray& vertices = finished.original.mesh->positions;
    constexpr std::size_t count = 100;
    const ObjLineFile file = parse(*makeVertexRayObj(finished, count, 12.5));
    ASSERT_EQ(file.lines.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      const VertexRay ray =
          makeVertexRay(makeVertexMap(level), vertices[(2 * i + 1) * vertices.size() / (2 * count)]);
      const Point expected[] = {ray.eye, ray.legs.back().start, ray.sculpture};
      ASSERT_EQ(file.lines[i].size(), 3u);
      for (int k = 0; k < 3; ++k) {
        const Point got = file.points.at(file.lines[i][k] - 1);
        EXPECT_LT(glm::length(got - 12.5 * expected[k]), 1e-9 * glm::length(got)) << name << i;
      }
    }
  }
}

TEST(Export, PixelRaysBeginAtTheEyeAndJoin) {
  const LevelResult& finished = finishedLevel("2-cylinder");
  const std::string text = *makePixelRayObj(finished, 10);
  const ObjLineFile file = parse(text);
  EXPECT_THAT(text, HasSubstr("o camera_rays\n"));
  EXPECT_THAT(text, HasSubstr("o reflected_rays\n"));
  int fromEye = 0;
  for (const auto& line : file.lines) {
    ASSERT_EQ(line.size(), 2u);
    fromEye += file.points.at(line[0] - 1) == 10.0 * finished.level.camera.eye;
  }
  EXPECT_EQ(fromEye, finished.level.grid.columns * finished.level.grid.rows);
}

TEST(Export, SculptureIsInMillimetresInEveryFormat) {
  const LevelResult& finished = finishedLevel("2-cylinder");
  const TemporaryFolder folder;
  const Box box = boundingBox(makePrintable(finished.sculpture.sculpture->mesh, 10).positions);
  for (const char* name : {"a.obj", "a.stl", "a.ply", "A.STL"}) {
    const auto summary = exportLevel(finished, requestFor(folder / name));
    ASSERT_TRUE(summary) << name;
    const Box got = boundingBox(loadMesh(folder / name).mesh.positions);
    EXPECT_LT(glm::length(got.min - box.min) + glm::length(got.max - box.max), 1e-4) << name;
    EXPECT_THAT(summary->description, HasSubstr("52.1 x 14.8 x 14.6 mm"));
  }
}

TEST(Export, BasePlateComesAlong) {
  const LevelResult& finished = finishedLevel("2-cylinder");
  const TemporaryFolder folder;
  ExportRequest request = requestFor(folder / "a.stl");
  request.basePlate = BasePlateSettings{};
  ASSERT_TRUE(exportLevel(finished, request));
  const Mesh mesh = loadMesh(folder / "a.stl").mesh;
  EXPECT_NEAR(boundingBox(mesh.positions).min.z, 0, 1e-6) << "down to the table";
  const PrintCheck check = *checkPrint(mesh);
  EXPECT_TRUE(check.topology.isSound()) << "closed shells";
  EXPECT_GT(check.parts, 3u);
}

TEST(Export, MatchPageHoldsThreePicturesOfItsSize) {
  const LevelResult& finished = finishedLevel("3-sphere");
  const TemporaryFolder folder;
  ASSERT_TRUE(exportLevel(finished, requestFor(folder / "m.html")));
  const std::string html = readAll(folder / "m.html");
  const std::string begin = "src=\"data:image/png;base64,";
  int pictures = 0;
  for (std::size_t at = html.find(begin); at != std::string::npos;
       at = html.find(begin, at + 1), ++pictures) {
    const std::size_t from = at + begin.size();
    const std::string encoded = html.substr(from, html.find('"', from) - from);
    std::string bytes;
    std::uint32_t bits = 0;
    int count = 0;
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (const char c : encoded) {
      if (c == '=') break;
      bits = bits << 6 | static_cast<std::uint32_t>(letters.find(c));
      count += 6;
      if (count >= 8) bytes += static_cast<char>(bits >> (count -= 8));
    }
    writeText(folder / "picture.png", bytes);
    const Bitmap bitmap = loadPng(folder / "picture.png");
    EXPECT_EQ(bitmap.width, 48);
    EXPECT_EQ(bitmap.height, 48);
  }
  EXPECT_EQ(pictures, 3);
  EXPECT_THAT(html, HasSubstr("silhouette IoU"));
  EXPECT_THAT(html, HasSubstr("height: auto")) << "pictures keep their proportions in narrow columns";
  EXPECT_EQ(html.find("http"), std::string::npos) << "nothing from elsewhere";
}

TEST(Export, MatchPageEscapesTheTitle) {
  LevelResult finished = finishedLevel("1-plane");
  finished.level.text.edit([&](LevelText& text) { text.title = "<b>\"A & B\"</b>"; });
  const Image pixel(1, 1);
  {
    const InDutch dutch;
    const std::string page = makeMatchPage(finished, {}, {pixel, pixel, pixel});
    EXPECT_THAT(page, HasSubstr("<html lang=\"nl\">"));
    for (const char* english :
         {"seen", "original<", "the eye", "share", "grey", "report", "Compared", "pixels"}) {
      EXPECT_THAT(page, Not(HasSubstr(english)));
    }
  }
  const std::string html = makeMatchPage(finished, {}, {pixel, pixel, pixel});
  EXPECT_THAT(html, HasSubstr("<h1>&lt;b&gt;&quot;A &amp; B&quot;&lt;/b&gt;</h1>"));
}

TEST(Export, MatchPageExplainsTheColoursOfItsPicture) {
  const std::pair<PixelClass, Rgb> marked[] = {{PixelClass::onlyOriginal, palette::onlyOriginal},
                                               {PixelClass::onlyReflection, palette::onlyReflection},
                                               {PixelClass::hidden, palette::hiddenReflection},
                                               {PixelClass::missed, palette::noMirror}};
  const Image pixel(1, 1);
  const std::string page = makeMatchPage(finishedLevel("1-plane"), {}, {pixel, pixel, pixel});
  for (const auto& [kind, color] : marked) {
    Match match;
    match.classes = {kind};
    const Bitmap bitmap = toBitmap(markDifferences(Image(1, 1), match));
    for (int c = 0; c < 3; ++c) EXPECT_EQ(bitmap.bytes[static_cast<std::size_t>(c)], channelOf(color, c));
    EXPECT_THAT(page, HasSubstr(fmt::format("background:#{:06x}", static_cast<std::uint32_t>(color))));
  }
}

TEST(Export, Base64IsThatOfItsStandard) {
  const char* pairs[][2] = {{"", ""}, {"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}, {"foob", "Zm9vYg=="}};
  for (const auto& [bytes, text] : pairs) EXPECT_EQ(encodeBase64(bytes), text);
}

TEST(Export, GoesWithoutAMirror) {
  Level level = finishedLevel("1-plane").level;
  level.optic.parts.front().kind = OpticKind::canvas;
  level.sculpture.depthScale = 0.3;
  const LevelResult finished = finish(level);
  const TemporaryFolder folder;
  for (const char* name : {"a.stl", "a.pdf", "a.svg", "a.html"}) {
    ExportRequest request = requestFor(folder / name);
    request.basePlate = BasePlateSettings{};
    EXPECT_TRUE(exportLevel(finished, request)) << name;
  }
  EXPECT_THAT(readAll(folder / "a.html"), HasSubstr("A plane canvas, seen from the eye"));
}

TEST(Export, PicturesHaveTheAskedSize) {
  const TemporaryFolder folder;
  for (const PictureKind kind : {PictureKind::reflection, PictureKind::original, PictureKind::difference}) {
    ExportRequest request = requestFor(folder / "p.png");
    request.picture = kind;
    ASSERT_TRUE(exportLevel(finishedLevel("2-cylinder"), request));
    EXPECT_EQ(loadPng(folder / "p.png").width, 48);
  }
}

TEST(Export, CancelledWritesNothing) {
  const TemporaryFolder folder;
  const LevelResult& finished = finishedLevel("2-cylinder");
  for (const char* name : {"a.stl", "a.obj", "a.pdf", "a.svg", "a.html", "a.json", "a.png"}) {
    const Progress before;
    before.token.cancel();
    EXPECT_FALSE(exportLevel(finished, requestFor(folder / name), 1, before)) << name;
    // Cancelled on the way, at the first report of some progress.
    Progress progress;
    progress.report = [token = progress.token](double fraction) {
      if (fraction > 0) token.cancel();
    };
    EXPECT_FALSE(exportLevel(finished, requestFor(folder / name), 1, progress)) << name;
  }
  EXPECT_EQ(folder.fileCount(), 0u);
}

TEST(Export, AFailureLeavesWhatWasThere) {
  const TemporaryFolder folder;
  LevelResult finished = finishedLevel("2-cylinder");
  writeText(folder / "a.stl", "older");
  ExportRequest request = requestFor(folder / "a.stl");
  request.millimetresPerUnit = 1e300;
  EXPECT_NE(errorOf([&] { exportLevel(finished, request); }), "no error");
  EXPECT_EQ(readAll(folder / "a.stl"), "older");
  EXPECT_EQ(folder.fileCount(), 1u);
  EXPECT_THAT(errorOf([&] { exportLevel(finished, requestFor(folder / "none/a.stl")); }),
              HasSubstr("cannot write"));
  request = requestFor(folder / "a.pdf");
  request.kind = ExportKind::sculpture;
  EXPECT_THAT(errorOf([&] { exportLevel(finished, request); }),
              HasSubstr("expected a file name that ends in .obj, .stl or .ply"));
}

}  // namespace
}  // namespace anamorph
