#include "geometry/up_guess.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "base/check.h"
#include "base/folder.h"
#include "base/language.h"
#include "geometry/file_text.h"

namespace anamorph {
namespace {

// Programs that name themselves in a comment at the head of an OBJ, and which way is up there unless somebody asks for
// another.
struct Program {
  const char* name;
  ModelUp up;
  std::string_view comment = name;  // by which it is known
};
constexpr std::array programs{
    Program{"Blender", ModelUp::y},   Program{"Maya", ModelUp::y, "This file uses centimeters as units"},
    Program{"3ds Max", ModelUp::y},   Program{"Cinema 4D", ModelUp::y},
    Program{"Rhino", ModelUp::y},     Program{"SketchUp", ModelUp::y},
    Program{"Wings 3D", ModelUp::y},  Program{"MilkShape 3D", ModelUp::y},
    Program{"ZBrush", ModelUp::y},    Program{"Houdini", ModelUp::y},
    Program{"LightWave", ModelUp::y}, Program{"DAZ Studio", ModelUp::y},
    Program{"Poser", ModelUp::y},     Program{"FreeCAD", ModelUp::z},
    Program{"OpenSCAD", ModelUp::z},  Program{"Tinkercad", ModelUp::z},
};

// "poser" is not in "composer".
bool hasWords(std::string_view text, std::string_view words) {
  const auto isPart = [&](std::size_t at) {
    return at < text.size() && std::isalnum(static_cast<unsigned char>(text[at])) != 0;
  };
  for (std::size_t at = text.find(words); at != std::string_view::npos; at = text.find(words, at + 1)) {
    if (!(at > 0 && isPart(at - 1)) && !isPart(at + words.size())) return true;
  }
  return false;
}

const Program* findProgram(std::string_view bytes) {
  constexpr std::size_t headLines = 20;
  LineReader lines(bytes.substr(0, 4096));
  for (std::string_view line; lines.next(line) && lines.number() <= headLines;) {
    line = trimmed(line);
    if (line.empty() || line[0] != '#') continue;
    const std::string comment = lowerCase(std::string(line));
    const auto at = std::find_if(programs.begin(), programs.end(), [&](const Program& program) {
      return hasWords(comment, lowerCase(std::string(program.comment)));
    });
    if (at != programs.end()) return &*at;
  }
  return nullptr;
}

// How much of the box's side below is flat, less what is flat above: a cube or a plate says nothing.
double flatBelow(const Mesh& mesh, const Box& box, int axis) {
  const Vector size = box.size();
  const double footprint = size[(axis + 1) % 3] * size[(axis + 2) % 3];
  if (!(footprint > 0 && size[axis] > 0)) return 0;
  const double near = 1e-3 * size[axis];
  double below = 0, above = 0;
  for (const Triangle& t : mesh.triangles) {
    const auto [low, high] =
        std::minmax({mesh.positions[t[0]][axis], mesh.positions[t[1]][axis], mesh.positions[t[2]][axis]});
    double* side = high <= box.min[axis] + near ? &below : low >= box.max[axis] - near ? &above : nullptr;
    if (side) *side += 0.5 * std::abs(areaVector(mesh.positions, t)[axis]);
  }
  return (below - above) / footprint;
}

}  // namespace

UpGuess guessUp(const Mesh& mesh, MeshFormat format, std::string_view bytes) {
  using Reason = UpGuess::Reason;
  if (format == MeshFormat::stl) return {ModelUp::z, Reason::printing};
  if (format == MeshFormat::obj) {
    if (const Program* program = findProgram(bytes)) return {program->up, Reason::program, program->name};
  }
  constexpr int y = 1, z = 2;
  constexpr double clearlyMore = 0.25;  // of the box's side
  constexpr double clearlyLarger = 1.1;
  const Box box = boundingBox(mesh.positions);
  const double flatY = flatBelow(mesh, box, y), flatZ = flatBelow(mesh, box, z);
  if (flatY > std::max(flatZ, 0.0) + clearlyMore) return {ModelUp::y, Reason::underside};
  if (flatZ > std::max(flatY, 0.0) + clearlyMore) return {ModelUp::z, Reason::underside};
  const Vector size = box.size();
  if (size.y > clearlyLarger * size.z) return {ModelUp::y, Reason::extent};
  if (size.z > clearlyLarger * size.y) return {ModelUp::z, Reason::extent};
  return {};
}

std::string upGuessText(const UpGuess& guess) {
  const char* axis = modelUpName(guess.up);
  switch (guess.reason) {
    case UpGuess::Reason::program:
      return trFormat("Its {} axis is taken to point up, as {} writes it.", axis, guess.program);
    case UpGuess::Reason::printing:
      return trFormat("Its {} axis is taken to point up, as in files for printing.", axis);
    case UpGuess::Reason::underside:
      return trFormat("Its {} axis is taken to point up: it is flat below.", axis);
    case UpGuess::Reason::extent:
      return trFormat("Its {} axis is taken to point up: it is higher that way.", axis);
    case UpGuess::Reason::nothing:
      return trFormat("Its {} axis is taken to point up: nothing tells otherwise.", axis);
  }
  CHECK(false);
}

}  // namespace anamorph
