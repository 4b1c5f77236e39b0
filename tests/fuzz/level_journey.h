// What must hold for any level that the reader accepts: it goes all the way, through its lesson, its sculpture, match and
// pictures into files, and nothing on the way crashes, takes for ever or gives a number that is none. Shared by the fuzz
// target and by the short regression in ctest (edit/level_journey_test.cpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include "base/check.h"
#include "base/error.h"
#include "base/file.h"
#include "cli/program.h"
#include "edit/lesson_run.h"
#include "exports/export_formats.h"
#include "exports/export_level.h"
#include "level/level_json.h"
#include "pipeline/evaluator.h"
#include "pipeline/original.h"

namespace anamorph::testing {

/// How far a level came.
struct Journey {
  bool read = false;
  bool hasSculpture = false;
  std::size_t exports = 0;  ///< files that were written, without base plates
};

// As it is, but small: how fine and large things are is limited elsewhere.
inline Level madeSmall(Level level) {
  const auto atMost = [](auto& value, auto most) {
    value = std::min<std::decay_t<decltype(value)>>(value, most);
  };
  struct Coarse {
    void operator()(BoxShape& s) const { s.segments = std::min(s.segments, 3); }
    void operator()(SphereShape& s) const { s.segments = std::min(s.segments, 12); }
    void operator()(TorusKnotShape& s) const {
      s.segments = std::min(s.segments, 24);
      s.sides = std::min(s.sides, 5);
    }
    void operator()(LetterFShape& s) const { s.segments = std::min(s.segments, 2); }
    void operator()(PawnShape& s) const { s.segments = std::min(s.segments, 12); }
    void operator()(FileShape&) const {}
  };
  std::visit(Coarse{}, level.original.shape);
  atMost(level.sculpture.maxTriangles, 2000);
  atMost(level.sculpture.imageSize, 64);
  atMost(level.grid.columns, 6);
  atMost(level.grid.rows, 6);
  atMost(level.tracing.samplesPerAxis, 1);
  level.text.edit([](LevelText& words) { words.title.clear(); });  // it stands in the files
  return level;
}

inline void checkFinite(const PointArray& points) {
  for (const auto* axis : {&points.x, &points.y, &points.z})
    CHECK(std::all_of(axis->begin(), axis->end(), [](double value) { return std::isfinite(value); }));
}

inline void checkFinite(const Image& image) {
  for (const glm::vec3& pixel : image.pixels)
    CHECK(std::isfinite(pixel.x) && std::isfinite(pixel.y) && std::isfinite(pixel.z));
}

// Every move that "do it" makes: what is left is a level that can be saved.
inline Level afterItsLesson(const Level& level) {
  Editor editor({}, 1);
  editor.session.startNew(level);
  lookAfresh(editor);
  advanceLesson(editor);
  for (std::size_t step = 0; step < editor.lesson.lesson.steps.size(); ++step) {
    openStep(editor, step);
    playStep(editor);
    finishPlay(editor);
    advanceLesson(editor);
  }
  const Level after = editor.session.level();
  CHECK(parseLevel(formatLevel(after), "after its lesson").level == after);
  return after;
}

// A number that is none has one of these names in the files.
inline void checkText(const std::filesystem::path& path) {
  const std::string text = readAll(path);
  CHECK(!text.empty());
  for (const char* none : {"nan", "-nan", "inf", "-inf"}) {
    for (const char* before : {" ", ": ", "\"", ",", "("}) {
      for (const char* after : {" ", "\n", "\"", ",", ")"})
        CHECK(text.find(std::string(before) + none + after) == std::string::npos);
    }
  }
}

// Whether the file was written; a refusal is an Error.
inline bool isExported(const LevelResult& finished, const ExportRequest& request) {
  try {
    exportLevel(finished, request);
  } catch (const Error& error) {
    CHECK(!error.message.empty());
    return false;
  }
  const std::string ending = request.path.extension();
  const bool isBinary = ending == ".pdf" || ending == ".png" || ending == ".stl" || ending == ".ply";
  if (!isBinary) checkText(request.path);
  return true;
}

// As every kind of file, with a base plate and without one.
inline std::size_t exportAll(const LevelResult& finished, const std::filesystem::path& folder) {
  std::size_t written = 0;
  for (const ExportFormat& format : exportFormats()) {
    for (const char* ending : format.endings) {
      ExportRequest request;
      request.kind = format.kind;
      request.path = folder / (std::string("file") + ending);
      request.size = 16;
      request.vertexRays = 5;
      request.picture = PictureKind::difference;
      written += isExported(finished, request);
      request.basePlate = BasePlateSettings{};
      if (format.has(ExportOption::basePlate)) isExported(finished, request);
    }
  }
  return written;
}

// The level in a text, made small; nothing for one that is refused. A mesh inside that is none is refused here.
inline std::optional<Level> readSmall(std::string_view text) {
  try {
    LoadedLevel loaded = parseLevel(text, "level.json");
    OriginalShape& shape = loaded.level.original.shape;
    if (loaded.isThesisScene) shape = BoxShape{};
    const auto* file = std::get_if<FileShape>(&shape);
    if (file && file->obj->empty()) shape = PawnShape{};  // there are no files here
    Level level = madeSmall(std::move(loaded.level));
    loadOriginal(level.original.shape, {}, {.maxBytes = 1 << 20, .maxVertices = 2000});
    return level;
  } catch (const Error& error) {
    CHECK(!error.message.empty());
    return std::nullopt;
  }
}

/// Sends the level in `text` on its way. Throws ProgrammingError where something on it is wrong.
inline Journey journeyOf(std::string_view text, const std::filesystem::path& folder) {
  Journey journey;
  const std::optional<Level> first = readSmall(text);
  if (!first) return journey;
  journey.read = true;
  const Level level = madeSmall(afterItsLesson(*first));
  const auto shape = loadOriginal(level.original.shape, {}).mesh;
  const PlacedOriginal original = placeOriginal(*shape, level);
  checkFinite(original.mesh->positions);
  const LevelResult finished = *finishLevel(level, original);
  checkFinite(finished.sculpture.sculpture->mesh.positions);
  const ImageRequest request = makeImageRequest(level, 16, 16, 1);
  checkFinite(*makePicture(finished, PictureKind::reflection, request));
  checkFinite(*makePicture(finished, PictureKind::original, request));
  if (finished.problem) return journey;
  journey.hasSculpture = true;
  const MatchReport report = matchLevel(finished, 16, 16).report;
  CHECK(report.silhouetteIou >= 0 && report.silhouetteIou <= 1);
  journey.exports = exportAll(finished, folder);
  return journey;
}

}  // namespace anamorph::testing
