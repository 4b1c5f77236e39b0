#include "exports/print_repairs.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/language.h"
#include "exports/inside_out.h"
#include "geometry/mesh_assembly.h"

namespace anamorph {
namespace {

// Beginning with the smallest corner, in the same sense of rotation.
Triangle rotatedToFirst(const Triangle& t) {
  Triangle rotated = t;
  std::rotate(rotated.begin(), std::min_element(rotated.begin(), rotated.end()), rotated.end());
  return rotated;
}

template <typename Value>
void eraseAt(std::vector<Value>& values, const std::vector<std::uint32_t>& sortedPlaces) {
  auto place = sortedPlaces.begin();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (place != sortedPlaces.end() && *place == i) {
      ++place;
    } else {
      values[kept++] = values[i];
    }
  }
  values.resize(kept);
}

Mesh repaired(Mesh mesh, const PrintRepairs& repairs) {
  for (const std::uint32_t triangle : repairs.turned)
    std::swap(mesh.triangles[triangle][1], mesh.triangles[triangle][2]);
  eraseAt(mesh.triangles, repairs.doubled);
  if (!repairs.doubled.empty()) leaveOutUnusedVertices(mesh);
  return mesh;
}

struct RepairWords {
  const char *turnedPart, *turnedParts, *doubled, *doubledMany;
};
constexpr RepairWords done{"1 part was inside out and has been turned",
                           "{} parts were inside out and have been turned",
                           "1 triangle was there twice and has been left out",
                           "{} triangles were there twice and have been left out"};
constexpr RepairWords left{"1 part is inside out, and stays so because the tolerance is off",
                           "{} parts are inside out, and stay so because the tolerance is off",
                           "1 triangle is there twice, and stays because the tolerance is off",
                           "{} triangles are there twice, and stay because the tolerance is off"};

std::vector<std::string> notesOf(const PrintRepairs& repairs, const RepairWords& words) {
  std::vector<std::string> notes;
  const auto say = [&](std::size_t count, const char* one, const char* many) {
    if (count > 0) notes.push_back(count == 1 ? tr(one) : trFormat(fmt::runtime(many), count));
  };
  say(repairs.turnedParts, words.turnedPart, words.turnedParts);
  say(repairs.doubled.size(), words.doubled, words.doubledMany);
  return notes;
}

}  // namespace

std::vector<std::uint32_t> findDoubled(const std::vector<Triangle>& triangles) {
  std::vector<std::pair<Triangle, std::uint32_t>> sorted;
  sorted.reserve(triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) sorted.emplace_back(rotatedToFirst(triangles[i]), i);
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::uint32_t> doubled;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].first == sorted[i - 1].first) doubled.push_back(sorted[i].second);
  }
  std::sort(doubled.begin(), doubled.end());
  return doubled;
}

PrintRepairs findRepairs(const Mesh& mesh) {
  WeldedMesh welded = weldPositions(mesh);
  PrintRepairs repairs;
  const std::vector<std::uint32_t> doubled = findDoubled(welded.mesh.triangles);
  for (const std::uint32_t triangle : doubled) repairs.doubled.push_back(welded.triangleOf[triangle]);
  eraseAt(welded.mesh.triangles, doubled);
  eraseAt(welded.triangleOf, doubled);
  const Surface surface = measureSurface(welded.mesh);
  const std::vector<std::size_t> insideOut = findInsideOut(welded.mesh, surface);
  repairs.turnedParts = insideOut.size();
  for (const std::size_t shell : insideOut) {
    for (const std::uint32_t triangle : surface.shells[shell].triangles)
      repairs.turned.push_back(welded.triangleOf[triangle]);
  }
  return repairs;
}

PreparedPrint prepareForPrint(Mesh mesh, bool mayChange) {
  const PrintRepairs repairs = findRepairs(mesh);
  if (!mayChange) return {std::move(mesh), notesOf(repairs, left)};
  return {repaired(std::move(mesh), repairs), notesOf(repairs, done)};
}

}  // namespace anamorph
