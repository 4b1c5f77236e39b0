// A level: everything that one lesson about mirror anamorphosis shows, as plain data. The eye, the mirror,
// the original and how its sculpture is made, the light, and where the 3D view starts. Words as in the
// method, section 1.
//
// A level holds values only: no mesh, no image, no file name of its own. level_json.h reads and writes it;
// the pipeline makes the sculpture from its scene. Its text is what a lesson says, long and seldom changed: copies of
// the level, of which the history keeps many, share it. Lengths are scene units, angles degrees, colours linear RGB, z is
// up.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/shared.h"
#include "geometry/model_up.h"
#include "math/placement.h"
#include "optics/camera.h"
#include "optics/material.h"
#include "optics/mistakes.h"
#include "optics/optic.h"
#include "optics/plane.h"

namespace anamorph {

// The built-in originals; their parameters are those of geometry/shapes.h.

struct BoxShape {
  Vector size{6, 2, 2};
  int segments = 32;
  bool operator==(const BoxShape&) const = default;
};

struct SphereShape {
  double radius = 1;
  int segments = 64;
  bool operator==(const SphereShape&) const = default;
};

struct TorusKnotShape {
  int p = 2;
  int q = 3;
  double tubeRadius = 0.25;
  int segments = 256;
  int sides = 24;
  bool operator==(const TorusKnotShape&) const = default;
};

struct LetterFShape {
  double height = 2;
  int segments = 8;
  bool operator==(const LetterFShape&) const = default;
};

struct PawnShape {
  double height = 2;
  int segments = 64;
  bool operator==(const PawnShape&) const = default;
};

/// A mesh file. The path stays as it was written; modelPath() of level_json.h finds the file. A small mesh may be inside
/// the level; then the path is only what it is called.
struct FileShape {
  std::string path;
  Shared<std::string> obj = std::string();  ///< the mesh as the text of an OBJ file; empty: it is in the file
  ModelUp up = ModelUp::z;                  ///< of the mesh, which is turned so that it is up here
  bool operator==(const FileShape&) const = default;
};

using OriginalShape = std::variant<BoxShape, SphereShape, TorusKnotShape, LetterFShape, PawnShape, FileShape>;
/// What they are called in files.
inline constexpr std::array originalShapes{"box", "sphere", "torusKnot", "letterF", "pawn", "file"};
static_assert(originalShapes.size() == std::variant_size_v<OriginalShape>);

struct OriginalSettings {
  OriginalShape shape;
  bool unitize = false;  ///< centre the shape and scale it into the unit cube before it is placed
  Placement placement{.position = {0, 3.4, 1}};
  Material material{.color = {0.16, 0.35, 0.62}};
  bool operator==(const OriginalSettings&) const = default;
};

/// What a sculpture is made from, but for the original's shape and how finely it is divided.
struct SculptureInputs {
  Optic optic;
  Camera camera;         ///< its eye; by the rest of it the fineness is measured
  bool unitize = false;  ///< this and the next of the original
  Placement placement;
  double depthScale = 1;
  double depthOffset = 0;
  Mistakes mistakes;
  bool operator==(const SculptureInputs&) const = default;
};

struct SculptureSettings {
  double depthScale = 1;          ///< k of the method, section 2
  double depthOffset = 0;         ///< how far S is from Q besides, scene units (method-optics, section 2)
  double tolerancePixels = 0.25;  ///< refinement (section 5); 0: off, the original's own vertices
  std::size_t maxTriangles = 2000000;  ///< refinement stops here
  int imageSize = 512;                 ///< height in pixels of the image that the tolerance is meant for
  Mistakes mistakes;                   ///< of the thesis' published formulas, made on purpose
  Material material{.color = {0.72, 0.36, 0.22}};
  /// Kept while the sculpture is frozen (freeze.h): it is made from these, whatever the level's own are by now.
  std::optional<SculptureInputs> frozen;
  bool operator==(const SculptureSettings&) const = default;
};

/// How the mirror looks: the part of the light that it gives back, and its colour.
struct MirrorLook {
  Color tint{1};
  double reflectance = 0.95;
  bool operator==(const MirrorLook&) const = default;
};

/// The horizontal plane that the 3D view draws as floor.
struct GroundSettings {
  bool visible = true;
  double height = 0;
  bool operator==(const GroundSettings&) const = default;
};

struct TracingSettings {
  int maxDepth = 3;
  bool shadows = true;
  int samplesPerAxis = 2;  ///< supersampling: its square is the number of rays per pixel
  bool operator==(const TracingSettings&) const = default;
};

/// Where the 3D view starts.
struct ViewSettings {
  Point eye{16, -20, 13};
  Point target{0, 0, 2};
  double fovDegrees = 40;
  bool operator==(const ViewSettings&) const = default;
};

/// A key of the file that this program does not know, kept so that saving does not lose it.
struct UnknownKey {
  std::string object;  ///< JSON pointer of the object that holds it, "" for the level itself
  std::string key;
  std::string json;  ///< its value, as JSON text on one line
  bool operator==(const UnknownKey&) const = default;
};

/// What is seen and computed; by default the box behind a plane mirror.
struct LevelScene {
  Optic optic{OpticKind::mirror,
              PlaneMirror{{Point(-8, 0, 0), Point(8, 0, 0), Point(8, 0, 8), Point(-8, 0, 8)}}};
  MirrorLook mirrorLook;
  Camera camera{.eye = {0, -11.9, 6.5}, .target = {0, 3.4, 1}};
  PixelGrid grid;
  OriginalSettings original;
  SculptureSettings sculpture;
  std::vector<PointLight> lights{{{-7, -12, 14}, Color(1, 0.96, 0.9), 0.8},
                                 {{3, -0.5, 9}, Color(0.9, 0.95, 1), 0.6}};
  Background background;
  GroundSettings ground;
  TracingSettings tracing;
  ViewSettings view;

  bool operator==(const LevelScene&) const = default;
};

/// What is read: nothing that is computed depends on it.
struct LevelText {
  std::string title;
  std::string description;
  std::string lesson;  ///< the lesson's steps, as JSON text on one line; empty: none
  std::vector<UnknownKey> unknownKeys;
  std::string schema{};  ///< "$schema": where editors find what a level may hold; empty: none

  bool operator==(const LevelText&) const = default;
};

struct Level : LevelScene {
  Shared<LevelText> text;

  bool operator==(const Level&) const = default;
};

/// Whether all that is computed of two levels is the same, whatever their words.
inline bool isSameScene(const LevelScene& a, const LevelScene& b) {
  return a == b;
}

}  // namespace anamorph
