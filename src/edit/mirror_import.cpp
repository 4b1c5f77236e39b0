#include "edit/mirror_import.h"

#include <algorithm>

#include "base/check.h"
#include "base/error.h"
#include "base/language.h"
#include "base/text.h"
#include "edit/level_edits.h"
#include "edit/replacements.h"
#include "level/limits.h"
#include "optics/shape_table.h"
#include "pipeline/mirror_files.h"

namespace anamorph {
namespace {

// One that is made of a file, which it has not got yet.
Shape shapeOfFile(const ShapeExtent& room, const Point& eye) {
  const auto type =
      std::find_if(shapeTypes().begin(), shapeTypes().end(), [](const ShapeType& t) { return t.needsFile; });
  CHECK(type != shapeTypes().end());
  return type->filling(room, eye);
}

// Whether it waits for its file: what it says of it is that it could not be read.
bool isWithoutFile(Shape shape) {
  return shapeTypes()[shapeIndex(shape)].needsFile && findShapeProblem(shape);
}

// With another file, which has not been read yet.
void nameFile(Shape& shape, const std::string& name) {
  struct Files : SomeShapeFields {
    explicit Files(const std::string& file) : name(file) {}
    void file(const FieldName&, SurfaceFile& value) override {
      value = {.path = name, .mesh = nullptr, .problem = {}};
    }
    const std::string& name;
  } files(name);
  visitFields(shape, files);
}

Shape fitted(const Shape& shape, const Box& room) {
  const Box own = boxOf(shape);
  const double factor = scaleInto(own, room);
  ShapeMap map;
  map.point = [&](const Point& p) { return clampedPoint(room.centre() + factor * (p - own.centre())); };
  map.factors = Vector(factor);
  map.minSize = limits::lengths.min;
  map.maxSize = limits::lengths.max;
  return mapShape(shape, map);
}

}  // namespace

EditResult importMirror(const MirrorImport& import, const Level& level, const Progress& progress) {
  const Shape& old = level.optic.shape();
  Level result = level;
  Shape& mirror = result.optic.shape();
  if (!isWithoutFile(old)) mirror = shapeOfFile(extentOf(old), level.camera.eye);
  nameFile(mirror, import.name);
  const auto warnings = readMirrorFiles(result, import.levelPath, {}, &progress.token);
  if (const auto problem = findShapeProblem(mirror)) throw Error(*problem);
  if (!findShapeProblem(old)) mirror = fitted(mirror, boxOf(old));
  const std::string name = std::filesystem::path(import.name).filename().string();
  return {result, withRemarks(trFormat("The mirror is {}; Ctrl+Z takes it back.", name), warnings)};
}

}  // namespace anamorph
