// Files as programs write them and as accidents leave them: random good meshes, damaged in every way that other programs
// read past. Nothing may be lost without a word: the triangles that are read and those that a warning counts are
// together the triangles that were written.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "error_text.h"
#include "geometry/little_endian_file.h"
#include "geometry/mesh_files.h"

namespace anamorph {
namespace {

// What is wrong with a triangle of a file.
enum class Fault { none, nan, infinite, twoCorners, sameCorners, badIndex, word };

using Corners = std::array<std::array<float, 3>, 3>;

struct Written {
  std::string name, bytes;
  std::size_t triangles = 0, good = 0;
};

class Damage {
 public:
  explicit Damage(unsigned seed) : random_(seed) {
    const std::size_t count = 1 + below(30);
    for (std::size_t i = 0; i < count; ++i) triangles_.push_back(makeTriangle(i));
  }

  Written obj() {
    const std::vector<Fault> faults = makeFaults(
        {Fault::nan, Fault::infinite, Fault::twoCorners, Fault::sameCorners, Fault::badIndex, Fault::word});
    std::vector<std::string> lines;
    const bool facesFirst = chance(5);
    std::vector<std::string> faceLines;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      for (int c = 0; c < 3; ++c) lines.push_back("v " + numbers(i, c, faults[i], c == 1));
      const std::size_t first = 3 * i + 1;
      const bool negative = !facesFirst && chance(3);
      const auto index = [&](std::size_t c) {
        return negative ? fmt::format("-{}", 3 - c) : fmt::format("{}{}", first + c, chance(6) ? "/1/1" : "");
      };
      std::string face = (chance(9) ? "fo " : "f ") + index(0) + (chance(9) ? " \\\n" : " ") + index(1);
      if (faults[i] == Fault::sameCorners) face += " " + index(1);
      if (faults[i] == Fault::badIndex) face += chance(2) ? " 0" : " 999999";
      if (faults[i] == Fault::word) face += " x";
      if (faults[i] != Fault::sameCorners && faults[i] != Fault::badIndex && faults[i] != Fault::word &&
          faults[i] != Fault::twoCorners)
        face += " " + index(2);
      (facesFirst ? faceLines : lines).push_back(face);
      if (chance(9)) lines.push_back(chance(2) ? "usemtl C:\\mats\\" : "l 1 2");
    }
    lines.insert(lines.begin(), faceLines.begin(), faceLines.end());
    scatter(lines, {"# by hand", "", "vn 0 0 1", "# C:\\", "s off"}, 0);
    return written("m.obj", text(lines, true), faults);
  }

  Written textStl() {
    const std::vector<Fault> faults =
        makeFaults({Fault::nan, Fault::infinite, Fault::twoCorners, Fault::sameCorners, Fault::word});
    std::vector<std::string> lines{"solid a name"};
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      if (i > 0 && chance(9)) {
        if (chance(2)) lines.push_back(chance(2) ? "endsolid" : "end solid x");
        lines.push_back("solid facet normal");
      }
      lines.push_back(chance(9) ? "facet normal nan nan nan" : "facet normal 0 0 1");
      lines.push_back(faults[i] == Fault::word ? "inner loop" : "outer loop");
      const int corners = faults[i] == Fault::twoCorners ? 2 : 3;
      for (int c = 0; c < corners; ++c) {
        const int corner = faults[i] == Fault::sameCorners && c == 2 ? 1 : c;
        lines.push_back("vertex " + numbers(i, corner, faults[i], c == 1));
      }
      lines.push_back(chance(9) ? "end loop" : "endloop");
      lines.push_back("endfacet");
    }
    if (chance(2)) lines.push_back("endsolid a name");
    if (chance(3)) {
      for (std::string& line : lines) {
        for (char& c : line) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
      }
    }
    scatter(lines, {"# by hand", ""}, 0);
    return written("m.stl", text(lines, true), faults);
  }

  Written binaryStl() {
    const std::vector<Fault> faults = makeFaults({Fault::nan, Fault::infinite, Fault::sameCorners});
    std::string bytes = chance(2) ? "solid facet normal 0 0 1" : "by hand";
    bytes.resize(80, chance(2) ? ' ' : '\0');
    const auto count = static_cast<std::uint32_t>(triangles_.size());
    const std::uint32_t wrong[] = {0, 0xFFFFFFFF, count - 1, count + 1,
                                   static_cast<std::uint32_t>(random_())};
    appendLittleEndian(bytes, chance(2) ? count : wrong[below(std::size(wrong))]);
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      bytes.append(12, '\0');
      for (int c = 0; c < 3; ++c) {
        for (const float value :
             values(i, faults[i] == Fault::sameCorners && c == 2 ? 1 : c, faults[i], c == 1))
          appendLittleEndian(bytes, value);
      }
      appendLittleEndian(bytes, static_cast<std::uint16_t>(random_()));
    }
    return written("m.stl", bytes, faults);
  }

  Written ply() {
    const std::vector<Fault> faults =
        makeFaults({Fault::nan, Fault::infinite, Fault::twoCorners, Fault::sameCorners, Fault::badIndex});
    const bool isText = chance(2), isBig = chance(2), facesFirst = chance(3), colours = chance(3);
    std::vector<std::string> head{isText  ? "format ascii 1.0"
                                  : isBig ? "format binary_big_endian 1.0"
                                          : "format binary_little_endian 1.0"};
    const std::vector<std::string> vertexHead{fmt::format("element vertex {}", 3 * triangles_.size()),
                                              "property float x", "property float y", "property float z"};
    std::vector<std::string> faceHead{fmt::format("element face {}", triangles_.size())};
    if (colours) faceHead.push_back("property uchar red");
    faceHead.push_back(chance(2) ? "property list uchar int vertex_indices"
                                 : "property list float int vertex_index");
    const bool floatCount = faceHead.back().find("float") != std::string::npos;
    for (const auto* part : {facesFirst ? &faceHead : &vertexHead, facesFirst ? &vertexHead : &faceHead})
      head.insert(head.end(), part->begin(), part->end());
    head.insert(head.begin(), "ply");
    scatter(head, {"comment by hand", "obj_info x", "", "crs {}", "Created by hand"}, 1);
    head.push_back("end_header");

    std::vector<std::string> vertices, faces;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      for (int c = 0; c < 3; ++c) {
        std::string row;
        for (const float value : values(i, c, faults[i], c == 1)) {
          isText ? row += fmt::format("{} ", value) : row += binary(value, isBig);
        }
        vertices.push_back(row);
      }
      const int first = static_cast<int>(3 * i);
      std::vector<int> corners{first, first + 1, first + 2};
      if (faults[i] == Fault::twoCorners) corners.pop_back();
      if (faults[i] == Fault::sameCorners) corners[2] = corners[1];
      if (faults[i] == Fault::badIndex) corners[2] = chance(2) ? -1 : 999999;
      std::string row;
      if (colours) row += isText ? "255 " : "\xFF";
      if (isText) {
        row += fmt::format("{} {}{}", corners.size(), fmt::join(corners, " "), chance(5) ? " 7 8 9" : "");
      } else {
        row += floatCount ? binary(static_cast<float>(corners.size()), isBig)
                          : std::string(1, static_cast<char>(corners.size()));
        for (const int corner : corners) row += binary(corner, isBig);
      }
      faces.push_back(row);
    }
    std::vector<std::string> rows = facesFirst ? faces : vertices;
    rows.insert(rows.end(), facesFirst ? vertices.begin() : faces.begin(),
                facesFirst ? vertices.end() : faces.end());
    if (isText) {
      scatter(rows, {"", "# by hand", "comment x"}, 0);
      rows.insert(rows.begin(), head.begin(), head.end());
      return written("m.ply", text(rows, false), faults);
    }
    const std::string end = chance(3) ? "\r\n" : chance(2) ? "\r" : "\n";
    std::string bytes = chance(4) ? "\xEF\xBB\xBF" : "";
    for (const std::string& line : head) bytes += line + end;
    for (const std::string& row : rows) bytes += row;
    return written("m.ply", bytes, faults);
  }

 private:
  Corners makeTriangle(std::size_t i) {
    Corners triangle;
    std::uniform_real_distribution<float> uniform(-1, 1);
    for (auto& corner : triangle) {
      for (float& value : corner) value = uniform(random_) + static_cast<float>(i);
    }
    return triangle;
  }

  std::vector<Fault> makeFaults(const std::vector<Fault>& kinds) {
    std::vector<Fault> faults(triangles_.size(), Fault::none);
    for (Fault& fault : faults) {
      if (chance(5)) fault = kinds[below(kinds.size())];
    }
    return faults;
  }

  std::array<float, 3> values(std::size_t triangle, int corner, Fault fault, bool faulty) {
    std::array<float, 3> result = triangles_[triangle][static_cast<std::size_t>(corner)];
    if (faulty && fault == Fault::nan) result[below(3)] = std::numeric_limits<float>::quiet_NaN();
    if (faulty && fault == Fault::infinite) result[below(3)] = std::numeric_limits<float>::infinity();
    return result;
  }

  std::string numbers(std::size_t triangle, int corner, Fault fault, bool faulty) {
    const auto [x, y, z] = values(triangle, corner, fault, faulty);
    return fmt::format("{:.9e} {:.9e} {}", x, y, z);
  }

  template <typename Number>
  static std::string binary(Number value, bool isBig) {
    std::string bytes;
    appendLittleEndian(bytes, value);
    if (isBig) std::reverse(bytes.begin(), bytes.end());
    return bytes;
  }

  // Puts lines that say nothing between those from `first` on.
  void scatter(std::vector<std::string>& lines, const std::vector<std::string>& more, std::size_t first) {
    for (std::size_t i = below(4); i > 0; --i) {
      const auto at = static_cast<std::ptrdiff_t>(first + below(lines.size() - first));
      lines.insert(lines.begin() + at, more[below(more.size())]);
    }
  }

  std::string text(const std::vector<std::string>& lines, bool mixed) {
    const std::array<std::string, 3> ends{"\n", "\r\n", "\r"};
    const std::size_t end = below(3);
    std::string bytes = chance(4) ? "\xEF\xBB\xBF" : "";
    const bool isMixed = mixed && chance(4);
    for (const std::string& line : lines) bytes += line + ends[isMixed ? below(3) : end];
    if (chance(4)) bytes.append(below(20), '\0');
    if (chance(4)) bytes += '\x1a';
    return bytes;
  }

  Written written(const std::string& name, const std::string& bytes, const std::vector<Fault>& faults) const {
    const auto good = std::count(faults.begin(), faults.end(), Fault::none);
    return {name, bytes, triangles_.size(), static_cast<std::size_t>(good)};
  }

  std::size_t below(std::size_t count) { return random_() % count; }
  bool chance(std::size_t oneIn) { return below(oneIn) == 0; }

  std::mt19937 random_;
  std::vector<Corners> triangles_;
};

// The sum of what the warnings say of triangles.
std::size_t countLeftOut(const std::vector<std::string>& warnings) {
  std::size_t sum = 0;
  for (const std::string& warning : warnings) {
    const std::string what = warning.substr(warning.rfind(": ") + 2);
    const auto isAbout = [&](const char* word) { return what.find(word) != std::string::npos; };
    const bool counts = std::isdigit(static_cast<unsigned char>(what[0])) && isAbout(" left out") &&
                        (isAbout(" face") || isAbout(" facet") || isAbout(" triangle")) &&
                        !isAbout("no face uses");
    if (counts) sum += std::stoul(what);
  }
  return sum;
}

void expectNothingLost(const Written& file, const std::string& what) {
  LoadedMesh loaded;
  const std::string error = errorOf([&] { loaded = readMesh(file.bytes, file.name); });
  if (file.good == 0) {
    EXPECT_NE(error, "no error") << what;
    return;
  }
  ASSERT_EQ(error, "no error") << what << "\n" << file.bytes;
  EXPECT_EQ(loaded.mesh.triangles.size(), file.good) << what << "\n" << file.bytes;
  EXPECT_EQ(loaded.mesh.triangles.size() + countLeftOut(loaded.warnings), file.triangles)
      << what << "\n"
      << fmt::format("{}", fmt::join(loaded.warnings, "\n"));
  EXPECT_EQ(loaded.mesh.positions.size(), 3 * file.good) << what;
  const Vector size = boundingBox(loaded.mesh.positions).size();
  EXPECT_LT(std::max({size.x, size.y, size.z}), 33) << what;
}

TEST(MeshDamage, NothingIsLostWithoutAWord) {
  for (unsigned seed = 0; seed < 1500; ++seed) {
    const std::string what = "seed " + std::to_string(seed);
    expectNothingLost(Damage(seed).obj(), "OBJ, " + what);
    expectNothingLost(Damage(seed).textStl(), "text STL, " + what);
    expectNothingLost(Damage(seed).binaryStl(), "binary STL, " + what);
    expectNothingLost(Damage(seed).ply(), "PLY, " + what);
    if (HasFailure()) break;
  }
}

}  // namespace
}  // namespace anamorph
