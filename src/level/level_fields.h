// The level file, said once: names, order, ranges and which keys are needed. FieldReader, FieldWriter and FieldSchema
// walk these functions, so what is read, what is written and what `anamorph schema` says cannot drift apart.
// levels/README.md explains the same for people.
//
// To add a field: a member in level.h with its default, a line here, its limits in limits.h, a line in
// levels/README.md.
#pragma once

#include <array>
#include <numeric>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "base/text.h"
#include "level/field_reader.h"
#include "level/lesson.h"
#include "level/level.h"
#include "level/limits.h"
#include "optics/shape_table.h"

namespace anamorph {

constexpr std::array opticKinds{"mirror", "none"};

/// The keys of a shape.
struct ShapeKeys : ShapeFields {
  std::vector<const char*> keys;
  void add(const FieldName& name) {
    if (!name.mayBeAbsent) keys.push_back(name.key);
  }
  void point(const FieldName& name, Point&) override { add(name); }
  void direction(const FieldName& name, Vector&) override { add(name); }
  void angles(const FieldName& name, Vector&) override { add(name); }
  void length(const FieldName& name, double&) override { add(name); }
  void flag(const FieldName& name, bool&) override { add(name); }
  void points(const FieldName& name, std::span<Point>) override { add(name); }
  void lengths(const FieldName& name, std::span<double>) override { add(name); }
  void radii(const FieldName& name, std::vector<double>&) override { add(name); }
  void curve(const FieldName& name, std::vector<CurvePoint>&) override { add(name); }
  void heights(const FieldName& name, HeightGrid&) override { add(name); }
  void file(const FieldName& name, SurfaceFile&) override { add(name); }
};

template <typename At>
void expectFileName(At& at, const char* key, const std::string& path) {
  at.expect(!path.empty() && path.find('\0') == std::string::npos, key, "the name of a mesh file");
  at.expect(path.size() <= limits::mostPathBytes, key, "a shorter name of a mesh file");
}

template <typename At>
void fields(At& at, HalfSpace& half) {
  at.need({"point", "normal"});
  at.field("point", half.point, limits::coordinates);
  at.field("normal", half.normal, limits::coordinates);
  at.expect(glm::length(half.normal) >= limits::lengths.min, "normal", "a vector that is not 0");
}

template <typename At>
struct ShapeInFile : ShapeFields {
  explicit ShapeInFile(At& file) : at(file) {}
  void point(const FieldName& name, Point& value) override { at.field(name.key, value, limits::coordinates); }
  void direction(const FieldName& name, Vector& value) override {
    at.field(name.key, value, limits::coordinates);
    at.expect(glm::length(value) >= limits::lengths.min, name.key, "a vector that is not 0");
  }
  void angles(const FieldName& name, Vector& value) override { at.field(name.key, value, limits::degrees); }
  void length(const FieldName& name, double& value) override {
    at.field(name.key, value, name.mayBeZero ? limits::lengthsOrZero : limits::lengths);
  }
  void flag(const FieldName& name, bool& value) override { at.field(name.key, value); }
  void points(const FieldName& name, std::span<Point> values) override {
    at.field(name.key, values, limits::coordinates);
  }
  void lengths(const FieldName& name, std::span<double> values) override {
    at.field(name.key, values, limits::lengths);
  }
  void radii(const FieldName& name, std::vector<double>& values) override {
    at.numbers(name.key, values, limits::lengths, limits::splinePoints);
  }
  void curve(const FieldName& name, std::vector<CurvePoint>& values) override {
    at.curve(name.key, values, limits::coordinates, limits::splinePoints);
  }
  void heights(const FieldName& name, HeightGrid& values) override {
    at.grid(name.key, values, limits::coordinates, limits::patchPoints);
  }
  void file(const FieldName& name, SurfaceFile& value) override {
    const std::string before = value.path;
    at.field(name.key, value.path);
    expectFileName(at, name.key, value.path);
    if (value.path != before) value = {value.path, nullptr, {}};
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
  std::vector<HalfSpace> clip = shape.clip();
  at.listIfAny("clip", clip, limits::mostClips);
  shape.clipBy(std::move(clip));
}

template <typename At>
void fields(At& at, MirrorLook& look) {
  at.field("tint", look.tint, limits::fractions);
  at.field("reflectance", look.reflectance, limits::fractions);
}

template <typename At>
void fields(At& at, Optic& optic) {
  at.need({"kind", "shape"});
  at.choice("kind", optic.parts.front().kind, opticKinds);
  at.object("shape", optic.shape());
}

/// In the file, the look belongs to the optic.
struct OpticFields {
  Optic& optic;
  MirrorLook& look;
};

template <typename At>
void fields(At& at, OpticFields& part) {
  fields(at, part.optic);
  at.object("look", part.look);
}

template <typename At>
void fields(At& at, Camera& camera) {
  at.need({"eye", "target"});
  at.field("eye", camera.eye, limits::coordinates);
  at.field("target", camera.target, limits::coordinates);
  at.field("up", camera.up, limits::coordinates);
  at.expect(glm::length(camera.up) >= limits::lengths.min, "up", "a vector that is not 0");
  at.field("fovDegrees", camera.fovDegrees, limits::fieldOfView.level);
}

/// In the file, the pixel grid belongs to the camera.
struct CameraFields {
  Camera& camera;
  PixelGrid& grid;
};

template <typename At>
void fields(At& at, CameraFields& part) {
  fields(at, part.camera);
  at.pair("grid", part.grid.columns, part.grid.rows, limits::gridCells);
  at.field("screenDistance", part.grid.distance, limits::gridDistance.level);
}

template <typename At>
void fields(At& at, Material& material) {
  at.field("color", material.color, limits::fractions);
  at.field("ambient", material.ambient, limits::fractions);
  at.field("diffuse", material.diffuse, limits::fractions);
  at.field("specular", material.specular, limits::fractions);
  at.field("shininess", material.shininess, limits::shininess.level);
}

template <typename At>
void fields(At& at, BoxShape& box) {
  at.field("size", box.size, limits::shapeSize.level);
  at.field("segments", box.segments, limits::boxSegments.level);
}

template <typename At>
void fields(At& at, SphereShape& sphere) {
  at.field("radius", sphere.radius, limits::shapeSize.level);
  at.field("segments", sphere.segments, limits::sphereSegments.level);
}

template <typename At>
void fields(At& at, TorusKnotShape& knot) {
  at.field("p", knot.p, limits::knotTurns);
  at.field("q", knot.q, limits::knotTurns);
  at.expect(std::gcd(knot.p, knot.q) == 1, "q", "a number without a common divisor with p");
  at.field("tubeRadius", knot.tubeRadius, limits::tubeRadius);
  at.field("segments", knot.segments, limits::knotSegments.level);
  at.field("sides", knot.sides, limits::knotSides.level);
}

template <typename At>
void fields(At& at, LetterFShape& letter) {
  at.field("height", letter.height, limits::shapeSize.level);
  at.field("segments", letter.segments, limits::letterSegments.level);
}

template <typename At>
void fields(At& at, PawnShape& pawn) {
  at.field("height", pawn.height, limits::shapeSize.level);
  at.field("segments", pawn.segments, limits::pawnSegments.level);
}

template <typename At>
void fields(At& at, FileShape& file) {
  at.need({"path"});
  at.field("path", file.path);
  expectFileName(at, "path", file.path);
  std::string up = file.up == ModelUp::z ? "" : modelUpName(file.up);
  at.textOrNone("up", up, limits::mostTitleBytes);
  const auto axis = up.empty() ? ModelUp::z : findModelUp(up);
  at.expect(axis.has_value(), "up", alternatives({modelUpNames.begin(), modelUpNames.end()}));
  file.up = axis.value_or(ModelUp::z);
  std::string obj = *file.obj;
  at.textOrNone("obj", obj, limits::mostInsideBytes);
  file.obj = std::move(obj);
}

template <typename At>
void fields(At& at, OriginalShape& shape) {
  at.choice("type", shape, originalShapes);
  std::visit([&](auto& chosen) { fields(at, chosen); }, shape);
}

template <typename At>
void fields(At& at, Placement& placement) {
  at.field("position", placement.position, limits::coordinates);
  at.field("rotationDegrees", placement.rotationDegrees, limits::coordinates);
  at.factors("scale", placement.scale, limits::shapeScale.level);
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

/// All of them are needed: what is left out would be another sculpture.
template <typename At>
void fields(At& at, SculptureInputs& inputs) {
  at.need({"optic", "camera", "unitize", "placement", "depthScale"});
  at.object("optic", inputs.optic);
  at.object("camera", inputs.camera);
  at.field("unitize", inputs.unitize);
  at.object("placement", inputs.placement);
  at.field("depthScale", inputs.depthScale, limits::depthScale.level);
  at.optional("depthOffset", inputs.depthOffset, 0, limits::depthOffset.level);
  at.object("mistakes", inputs.mistakes);
}

template <typename At>
void fields(At& at, SculptureSettings& sculpture) {
  at.field("depthScale", sculpture.depthScale, limits::depthScale.level);
  at.optional("depthOffset", sculpture.depthOffset, 0, limits::depthOffset.level);
  at.numberOrOff("tolerancePixels", sculpture.tolerancePixels, limits::tolerance.level);
  at.field("maxTriangles", sculpture.maxTriangles, limits::triangles);
  at.field("imageSize", sculpture.imageSize, limits::imageSize);
  at.object("mistakes", sculpture.mistakes);
  at.object("material", sculpture.material);
  at.optionalObject("frozen", sculpture.frozen);
}

template <typename At>
void fields(At& at, PointLight& light) {
  at.need({"position"});
  at.field("position", light.position, limits::coordinates);
  at.field("color", light.color, limits::fractions);
  at.field("intensity", light.intensity, limits::lightIntensity.level);
}

template <typename At>
void fields(At& at, Background& background) {
  at.field("top", background.top, limits::fractions);
  at.field("bottom", background.bottom, limits::fractions);
}

template <typename At>
void fields(At& at, GroundSettings& ground) {
  at.field("visible", ground.visible);
  at.field("height", ground.height, limits::coordinates);
}

template <typename At>
void fields(At& at, TracingSettings& tracing) {
  at.field("maxDepth", tracing.maxDepth, limits::reflections);
  at.field("shadows", tracing.shadows);
  at.field("samplesPerAxis", tracing.samplesPerAxis, limits::samplesPerAxis);
}

template <typename At>
void fields(At& at, ViewSettings& view) {
  at.field("eye", view.eye, limits::coordinates);
  at.field("target", view.target, limits::coordinates);
  at.field("fovDegrees", view.fovDegrees, limits::viewFieldOfView.level);
}

/// All but "format" and "version", which are not part of the level.
template <typename At>
void fields(At& at, Level& level) {
  at.need({"optic", "camera", "original"});
  LevelText text = *level.text;
  at.textOrNone("$schema", text.schema, limits::mostTextBytes);
  at.field("title", text.title);
  at.field("description", text.description);
  at.object("optic", OpticFields{level.optic, level.mirrorLook});
  at.object("camera", CameraFields{level.camera, level.grid});
  at.object("original", level.original);
  at.object("sculpture", level.sculpture);
  at.list("lights", level.lights, limits::mostLights);
  at.object("background", level.background);
  at.object("ground", level.ground);
  at.object("tracing", level.tracing);
  at.object("view", level.view);
  at.template textOf<Lesson>("lesson", text.lesson, limits::mostLessonBytes);
  level.text = std::move(text);
}

}  // namespace anamorph
