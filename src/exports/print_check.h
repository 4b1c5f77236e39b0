// Whether a 3D printer can make a mesh: is it closed, is inside told from outside, does it go through itself,
// how thin are its walls, how large is it. Equal positions are joined first, as slicers do.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "exports/export_request.h"
#include "exports/self_crossings.h"
#include "exports/surface_topology.h"
#include "exports/wall_thickness.h"
#include "level/json_object.h"

namespace anamorph {

/// Lengths in the mesh's unit: millimetres.
struct PrintCheck {
  std::size_t vertices = 0;  ///< after equal positions were joined
  std::size_t triangles = 0;
  std::size_t flatTriangles = 0;  ///< without an area
  SurfaceTopology topology;
  std::size_t parts = 0;      ///< shells of the surface
  std::size_t insideOut = 0;  ///< of those, closed ones that would have to be turned
  std::size_t doubled = 0;    ///< triangles that are there already
  SelfCrossings crossings;
  WallThickness walls;
  double smallestWidth = 0;        ///< that the walls were measured against
  std::vector<std::string> notes;  ///< about what was put right before (print_repairs.h)
  Box box;
  double volume = 0;  ///< inside, overlaps counted twice; only meaningful when the topology is sound
};

struct PrintCheckLimits {
  double smallestWidth =
      ExportRequest{}.smallestWidth;   ///< millimetres, of the thinnest wall that can be printed
  std::size_t maxCrossings = 100'000;  ///< counting stops about there
};

/// Nothing when cancelled. The same for every thread count.
std::optional<PrintCheck> checkPrint(const Mesh& mesh, int threads = 1, const Progress& progress = {},
                                     const PrintCheckLimits& limits = {});

/// What of the original did not come into the sculpture.
struct LeftOut {
  LeftOut(std::size_t vertices = 0, double folded = 0)
      : notMapped(vertices), foldedShare(folded) {}  // NOLINT: often one
  std::size_t notMapped;                             ///< vertices
  double foldedShare;                                ///< as LeftOutFolds has it
};

/// What a slicer would stumble over, and what to do about it, in sentences; empty: nothing.
std::vector<std::string> findPrintProblems(const PrintCheck& check, const LeftOut& leftOut);

/// Worth knowing though it can be printed: what was put right, and walls that are thin in a few spots only.
std::vector<std::string> findPrintHints(const PrintCheck& check);

/// The figures for people: what each is, and how much.
std::vector<std::pair<std::string, std::string>> printCheckRows(const PrintCheck& check);
/// The same as a line each.
std::string formatPrintCheck(const PrintCheck& check);
/// The same with whether it can be printed, what hinders that and what is worth knowing; `leftOut` as for
/// findPrintProblems().
std::string formatPrintReport(const PrintCheck& check, const LeftOut& leftOut);

JsonValue printCheckJson(const PrintCheck& check, const LeftOut& leftOut);

}  // namespace anamorph
