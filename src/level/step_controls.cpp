#include "level/step_controls.h"

#include <array>

#include "optics/shape_table.h"

namespace anamorph {
namespace {

// But for the rows of the mirror's shape. The panels draw them, in a room below this one that `anamorph check` does not
// see: tests/panels/step_controls_test.cpp compares.
// clang-format off
constexpr std::array controls{
    "3D view", "A mesh from a file...", "Add a light", "Ambient", "Animate", "Another mesh...",
    "Camera, frustum and grid", "Canvas", "Caustic", "Colour", "Colour by status", "Columns",
    "Control columns", "Control point", "Control points", "Control rows", "Cut at", "Cut it off",
    "Depth offset", "Depth scale k", "Description", "Difference", "Diffuse", "Direction is right",
    "Distance", "Distance is right", "Exponent", "Eye", "Fainter if they matter less", "Field of view",
    "File", "Fit to the mirror", "Freeze the sculpture", "From the start", "Go on", "Grid opacity", "Ground",
    "Ground height", "Height", "Hide negligible rays", "Hide rays into the sky", "Hide the mirror",
    "How many", "In the colour they bring", "Inside the level", "Intensity", "Its height", "Its radius",
    "Its x", "Its y", "Keeps towards", "Language", "Legend", "Let it follow again", "Let it go",
    "Lift until nothing is hidden", "Lights", "Look through the RT camera", "Looks at", "Loop", "Mesh",
    "Mirror", "Morph", "Normal is right", "One after the other", "Original", "Parallel projection", "Pause",
    "Position", "Preview", "Put behind the mirror", "Radius", "Rays", "Recursion depth", "Refine",
    "Reflectance", "Reflection", "Reflects", "Remove this cut", "Remove this light", "Reset the level",
    "Rotation", "Rows", "Samples", "Scale", "Sculpture", "Seen by the eye", "Seen in the mirror", "Segments",
    "Shadows", "Shape", "Share", "Shininess", "Show only", "Show rays", "Show the lights", "Sides", "Size",
    "Sky above", "Sky below", "Specular", "Speed", "Stand up", "T R S to move, rotate, scale", "Theme",
    "Thicker if they matter more", "Thickness", "Tint", "Title", "To the lights too", "Tolerance",
    "Triangle edges", "Tube radius", "Turn x 90°", "Turn y 90°", "Turn z 90°", "Vertices", "View", "Which",
    "Wipe"};
// clang-format on

// Adds the rows of a shape.
struct ShapeRowNames : ShapeFields {
  explicit ShapeRowNames(std::vector<std::string>& all) : names(all) {}
  void point(const FieldName& name, Point&) override { names.emplace_back(name.label); }
  void direction(const FieldName& name, Vector&) override { names.emplace_back(name.label); }
  void angles(const FieldName& name, Vector&) override { names.emplace_back(name.label); }
  void length(const FieldName& name, double&) override { names.emplace_back(name.label); }
  void flag(const FieldName& name, bool&) override { names.emplace_back(name.label); }
  void points(const FieldName& name, std::span<Point> values) override { addNumbered(name, values.size()); }
  void lengths(const FieldName& name, std::span<double> values) override { addNumbered(name, values.size()); }
  void radii(const FieldName&, std::vector<double>&) override {}      // rows of their own
  void curve(const FieldName&, std::vector<CurvePoint>&) override {}  // rows of their own
  void heights(const FieldName&, HeightGrid&) override {}             // rows of their own
  void file(const FieldName& name, SurfaceFile&) override { names.emplace_back(name.label); }
  void addNumbered(const FieldName& name, std::size_t count) {
    for (std::size_t i = 1; i <= count; ++i) {
      names.push_back(std::string(name.label) + " " + std::to_string(i));
    }
  }
  void distance(const FieldName& name, const Point&, Point&) override { names.emplace_back(name.label); }
  std::vector<std::string>& names;
};

std::vector<std::string> allControls() {
  std::vector<std::string> names(controls.begin(), controls.end());
  ShapeRowNames rows(names);
  for (const ShapeType& type : shapeTypes()) {
    Shape shape = type.standard;
    visitFields(shape, rows);
  }
  return names;
}

}  // namespace

const std::vector<std::string>& stepControls() {
  static const std::vector<std::string> all = allControls();
  return all;
}

}  // namespace anamorph
