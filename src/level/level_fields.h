// The level file, said once: names, order, ranges and which keys are needed. FieldReader and FieldWriter both
// walk these functions, so what is read and what is written cannot drift apart. levels/README.md explains the
// same for people.
//
// To add a field: a member in level.h with its default, a line here, a line in levels/README.md.
#pragma once

#include <array>
#include <numeric>
#include <span>
#include <utility>
#include <vector>
#include <variant>

#include "level/field_reader.h"
#include "level/level.h"
#include "optics/shape_table.h"

namespace anamorph {

constexpr Range coordinates{-1e6, 1e6};
constexpr Range lengths{1e-6, 1e6};
constexpr Range fractions{0, 1};
constexpr Range fieldsOfView{1, 170};

constexpr std::array opticKinds{"mirror", "none"};
constexpr std::array originalShapes{"box", "sphere", "torusKnot", "letterF", "pawn", "file"};
static_assert(originalShapes.size() == std::variant_size_v<OriginalShape>);

/// The keys of a shape.
struct ShapeKeys : ShapeFields {
  std::vector<const char*> keys;
  void point(const FieldName& name, Point&) override { keys.push_back(name.key); }
  void length(const FieldName& name, double&) override { keys.push_back(name.key); }
  void points(const FieldName& name, std::span<Point>) override { keys.push_back(name.key); }
};

template <typename At>
struct ShapeInFile : ShapeFields {
  explicit ShapeInFile(At& file) : at(file) {}
  void point(const FieldName& name, Point& value) override { at.field(name.key, value, coordinates); }
  void length(const FieldName& name, double& value) override {
    at.field(name.key, value, name.mayBeZero ? Range{0, lengths.max} : lengths);
  }
  void points(const FieldName& name, std::span<Point> values) override {
    at.field(name.key, values, coordinates);
  }
  At& at;
};

template <typename At>
void fields(At& at, Shape& shape) {
  std::size_t index = shapeIndex(shape);
  at.choice("type", index, shapeNames());
  if (index != shapeIndex(shape)) shape = shapeTypes()[index].standard;
  ShapeKeys keys;
  visitFields(shape, keys);
  at.need(keys.keys);
  ShapeInFile<At> file(at);
  visitFields(shape, file);
}

template <typename At>
void fields(At& at, MirrorLook& look) {
  at.field("tint", look.tint, fractions);
  at.field("reflectance", look.reflectance, fractions);
}

/// In the file, the look belongs to the optic.
struct OpticFields {
  Optic& optic;
  MirrorLook& look;
};

template <typename At>
void fields(At& at, OpticFields& part) {
  at.need({"kind", "shape"});
  at.choice("kind", part.optic.parts.front().kind, opticKinds);
  at.object("shape", part.optic.shape());
  at.object("look", part.look);
}

/// In the file, the pixel grid belongs to the camera.
struct CameraFields {
  Camera& camera;
  PixelGrid& grid;
};

template <typename At>
void fields(At& at, CameraFields& part) {
  Camera& camera = part.camera;
  at.need({"eye", "target"});
  at.field("eye", camera.eye, coordinates);
  at.field("target", camera.target, coordinates);
  at.field("up", camera.up, coordinates);
  at.expect(glm::length(camera.up) >= lengths.min, "up", "a vector that is not 0");
  at.field("fovDegrees", camera.fovDegrees, fieldsOfView);
  at.pair("grid", part.grid.columns, part.grid.rows, Range{1, 64});
  at.field("screenDistance", part.grid.distance, lengths);
}

template <typename At>
void fields(At& at, Material& material) {
  at.field("color", material.color, fractions);
  at.field("ambient", material.ambient, fractions);
  at.field("diffuse", material.diffuse, fractions);
  at.field("specular", material.specular, fractions);
  at.field("shininess", material.shininess, Range{1, 1000});
}

template <typename At>
void fields(At& at, BoxShape& box) {
  at.field("size", box.size, lengths);
  at.field("segments", box.segments, Range{1, 512});
}

template <typename At>
void fields(At& at, SphereShape& sphere) {
  at.field("radius", sphere.radius, lengths);
  at.field("segments", sphere.segments, Range{3, 2048});
}

template <typename At>
void fields(At& at, TorusKnotShape& knot) {
  at.field("p", knot.p, Range{1, 32});
  at.field("q", knot.q, Range{1, 32});
  at.expect(std::gcd(knot.p, knot.q) == 1, "q", "a number without a common divisor with p");
  at.field("tubeRadius", knot.tubeRadius, Range{0.01, 1});
  at.field("segments", knot.segments, Range{3, 4096});
  at.field("sides", knot.sides, Range{3, 512});
}

template <typename At>
void fields(At& at, LetterFShape& letter) {
  at.field("height", letter.height, lengths);
  at.field("segments", letter.segments, Range{1, 256});
}

template <typename At>
void fields(At& at, PawnShape& pawn) {
  at.field("height", pawn.height, lengths);
  at.field("segments", pawn.segments, Range{3, 2048});
}

template <typename At>
void fields(At& at, FileShape& file) {
  at.need({"path"});
  at.field("path", file.path);
  const bool isName = !file.path.empty() && file.path.find('\0') == std::string::npos;
  at.expect(isName, "path", "the name of a mesh file");
}

template <typename At>
void fields(At& at, OriginalShape& shape) {
  at.choice("type", shape, originalShapes);
  std::visit([&](auto& chosen) { fields(at, chosen); }, shape);
}

template <typename At>
void fields(At& at, Placement& placement) {
  at.field("position", placement.position, coordinates);
  at.field("rotationDegrees", placement.rotationDegrees, coordinates);
  at.factors("scale", placement.scale, lengths);
}

template <typename At>
void fields(At& at, OriginalSettings& original) {
  at.need({"shape"});
  at.object("shape", original.shape);
  at.field("unitize", original.unitize);
  at.object("placement", original.placement);
  at.object("material", original.material);
}

template <typename At>
void fields(At& at, Mistakes& mistakes) {
  at.field("direction", mistakes.direction);
  at.field("distance", mistakes.distance);
  at.field("normal", mistakes.normal);
}

template <typename At>
void fields(At& at, SculptureSettings& sculpture) {
  at.field("depthScale", sculpture.depthScale, Range{0.01, 100});
  at.numberOrOff("tolerancePixels", sculpture.tolerancePixels, Range{0.001, 1000});
  at.field("maxTriangles", sculpture.maxTriangles, Range{1, 1e8});
  at.field("imageSize", sculpture.imageSize, Range{16, 16384});
  at.object("mistakes", sculpture.mistakes);
  at.object("material", sculpture.material);
}

template <typename At>
void fields(At& at, PointLight& light) {
  at.need({"position"});
  at.field("position", light.position, coordinates);
  at.field("color", light.color, fractions);
  at.field("intensity", light.intensity, Range{0, 1000});
}

template <typename At>
void fields(At& at, Background& background) {
  at.field("top", background.top, fractions);
  at.field("bottom", background.bottom, fractions);
}

template <typename At>
void fields(At& at, GroundSettings& ground) {
  at.field("visible", ground.visible);
  at.field("height", ground.height, coordinates);
}

template <typename At>
void fields(At& at, TracingSettings& tracing) {
  at.field("maxDepth", tracing.maxDepth, Range{0, 8});
  at.field("shadows", tracing.shadows);
  at.field("samplesPerAxis", tracing.samplesPerAxis, Range{1, 4});
}

template <typename At>
void fields(At& at, ViewSettings& view) {
  at.field("eye", view.eye, coordinates);
  at.field("target", view.target, coordinates);
  at.field("fovDegrees", view.fovDegrees, fieldsOfView);
}

/// All but "format" and "version", which are not part of the level.
template <typename At>
void fields(At& at, Level& level) {
  at.need({"optic", "camera", "original"});
  LevelText text = *level.text;
  at.field("title", text.title);
  at.field("description", text.description);
  at.object("optic", OpticFields{level.optic, level.mirrorLook});
  at.object("camera", CameraFields{level.camera, level.grid});
  at.object("original", level.original);
  at.object("sculpture", level.sculpture);
  at.list("lights", level.lights, 64);
  at.object("background", level.background);
  at.object("ground", level.ground);
  at.object("tracing", level.tracing);
  at.object("view", level.view);
  at.opaque("lesson", text.lesson);
  level.text = std::move(text);
}

}  // namespace anamorph
