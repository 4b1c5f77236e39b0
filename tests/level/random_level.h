// Random valid levels for property tests: every field gets a value of its range, some the ends of it.
#pragma once

#include <cmath>
#include <random>
#include <string>

#include "level/level.h"
#include "optics/extrusion.h"
#include "optics/patch.h"
#include "optics/revolution.h"
#include "shapes.h"

namespace anamorph {

class RandomLevel {
 public:
  explicit RandomLevel(std::uint64_t seed) : random_(seed) {}

  Level make() {
    Level level;
    LevelText words{text(), text(), "", {}};
    if (coin()) words.schema = text();
    level.optic = {coin() ? OpticKind::mirror : OpticKind::canvas, mirror()};
    level.mirrorLook = {color(), fraction()};
    level.camera = camera();
    level.grid = {whole(1, 64), whole(1, 64), length()};
    level.original = {shape(), coin(), {point(), point(), coin() ? Vector(length()) : lengths()}, material()};
    level.sculpture = {between(0.01, 100),
                       coin() ? 0 : between(0.001, 1000),
                       coin() ? 0 : between(0.001, 1000),
                       static_cast<std::size_t>(whole(1, 100000000)),
                       whole(16, 16384),
                       {coin(), coin(), coin()},
                       material(),
                       std::nullopt};
    if (coin()) {
      level.sculpture.frozen = {{OpticKind::mirror, mirror()}, camera(),           coin(),
                                {point(), point(), lengths()}, between(0.01, 100), coin() ? 0 : length(),
                                {coin(), coin(), coin()}};
    }
    level.lights.resize(static_cast<std::size_t>(whole(0, 4)));
    for (PointLight& light : level.lights) light = {point(), color(), between(0, 1000)};
    level.background = {color(), color()};
    level.ground = {coin(), coordinate()};
    level.tracing = {whole(0, 8), coin(), whole(1, 4)};
    level.view = {point(), point(), between(1, 170)};
    if (coin()) {
      words.lesson =
          R"({"id": "é\n", "steps": [{"id": "1", "title": "", "why": "\\", "do": "", "done": []}]})";
    }
    if (coin()) {
      words.unknownKeys = {{"/optic/shape", "a/b~", "[1, {\"c\": -0.0}]"},
                           {"", "zoom", "12345678901234567890"}};
    }
    level.text = std::move(words);
    return level;
  }

 private:
  double between(double low, double high) {
    const int pick = whole(0, 9);
    if (pick < 2) return pick == 0 ? low : high;
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  bool coin() { return whole(0, 1) == 1; }
  double fraction() { return between(0, 1); }
  double coordinate() { return coin() ? between(-1e6, 1e6) : whole(-20, 20); }
  double length() { return std::pow(10, between(-6, 6)); }
  Point point() {
    const double x = coordinate(), y = coordinate();
    return {x, y, coordinate()};
  }
  Vector lengths() {
    const double x = length(), y = length();
    return {x, y, length()};
  }
  Color color() {
    const double red = fraction(), green = fraction();
    return {red, green, fraction()};
  }
  std::string text() {
    const char* pieces[] = {"box", " ", "\"", "\\", "/", "\n", "\t", "é", "镜", "🙂", "\x01", "</script>"};
    std::string text;
    for (int i = whole(0, 6); i > 0; --i) text += pieces[whole(0, 11)];
    return text;
  }
  Material material() {
    const Color base = color();
    const double ambient = fraction(), diffuse = fraction(), specular = fraction();
    return {base, ambient, diffuse, specular, between(1, 1000)};
  }
  Shape mirror() {
    Shape mirror = wholeMirror();
    std::vector<HalfSpace> clip(static_cast<std::size_t>(std::max(0, whole(-3, 3))));
    for (HalfSpace& half : clip) half = {point(), Vector(1, 0, 0) + color()};
    mirror.clipBy(std::move(clip));
    return mirror;
  }
  std::vector<double> radii() {
    std::vector<double> values(static_cast<std::size_t>(whole(3, 12)));
    for (double& value : values) value = length();
    return values;
  }
  Shape wholeMirror() {
    switch (whole(0, 9)) {
      case 0:
        return PlaneMirror{{point(), point(), point(), point()}};
      case 1:
        return CylinderMirror{point(), point(), length()};
      case 2:
        return ConeMirror{point(), point(), coin() ? 0 : length(), length()};
      case 3:
        return EllipsoidMirror{point(), lengths(), coin() ? Vector(0) : point()};
      case 4:
        return ParaboloidMirror{point(), Vector(1, 0, 0) + color(), length(), length(),
                                coin() ? 0 : length()};
      case 5:
        return RevolutionMirror{point(), point(), radii()};
      case 6: {
        ExtrusionMirror wall{point(), Vector(1, 0, 0) + color(), Vector(0, 1, 0) + color(), length(), {},
                             coin()};
        for (int i = whole(3, 12); i > 0; --i) wall.points.emplace_back(coordinate(), coordinate());
        return wall;
      }
      case 7: {
        PatchMirror patch{
            point(), Vector(1, 0, 0) + color(), Vector(0, 1, 0) + color(), {length(), length()}, {}};
        patch.heights.columns = static_cast<std::size_t>(whole(4, 7));
        const std::size_t count = patch.heights.columns * static_cast<std::size_t>(whole(4, 7));
        for (std::size_t i = 0; i < count; ++i) patch.heights.heights.push_back(coordinate());
        return patch;
      }
      case 8: {
        MeshMirror mesh;
        mesh.file.path = "x" + text();
        mesh.placement = {point(), point(), lengths()};
        return mesh;
      }
      default:
        return SphereMirror{point(), length()};
    }
  }
  OriginalShape shape() {
    switch (whole(0, 5)) {
      case 0:
        return BoxShape{lengths(), whole(1, 512)};
      case 1:
        return SphereShape{length(), whole(3, 2048)};
      case 2:
        return TorusKnotShape{2, 2 * whole(0, 15) + 1, between(0.01, 1), whole(3, 4096), whole(3, 512)};
      case 3:
        return LetterFShape{length(), whole(1, 256)};
      case 4:
        return PawnShape{length(), whole(3, 2048)};
      default:
        return FileShape{"x" + text(), coin() ? "v " + text() : std::string(),
                         static_cast<ModelUp>(whole(0, int(modelUpNames.size()) - 1))};
    }
  }
  Camera camera() {
    Camera camera;
    camera.eye = point();
    camera.target = point();
    camera.up = Vector(1, 0, 0) + 0.1 * color();
    camera.fovDegrees = between(1, 170);
    return camera;
  }

  std::mt19937_64 random_;
};

}  // namespace anamorph
