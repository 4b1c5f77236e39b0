#include "exports/print_check.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/count.h"
#include "base/language.h"
#include "exports/inside_out.h"
#include "exports/print_repairs.h"

namespace anamorph {
namespace {

// Tips and creases get thin in every model. A piece of wall is missed in print when it is larger than this: so many
// times the smallest width, squared, of its surface.
constexpr double spotWidths = 4;

Mesh withoutFlatTriangles(Mesh mesh) {
  const auto isFlat = [&](const Triangle& t) { return areaVector(mesh.positions, t) == Vector(0); };
  mesh.triangles.erase(std::remove_if(mesh.triangles.begin(), mesh.triangles.end(), isFlat),
                       mesh.triangles.end());
  return mesh;
}

std::string pairsOf(const SelfCrossings& crossings) {
  return (crossings.more ? tr("more than ") : "") + countOf(crossings.pairs, "pair", "pairs");
}

std::string placeOf(const Point& p) {
  return trFormat("({:.1f}, {:.1f}, {:.1f})", p.x, p.y,
                  p.z);  // a language with decimal commas parts them otherwise
}

std::string thicknessOf(const ThinPlace& place) {
  return place.thickness < 0.01 ? shownFormat("< {:g}", 0.01) : shownFormat("{:.2f}", place.thickness);
}

bool areWallsThin(const PrintCheck& check) {
  const WallThickness& walls = check.walls;
  const double spot = spotWidths * check.smallestWidth;
  return walls.samples > 0 && (walls.firstPercentile < check.smallestWidth || walls.thinArea > spot * spot);
}

// "(1.0, 2.0, 3.0) 0.02 mm, (4.0, 2.0, 3.0) 0.3 mm"
std::string thinPlaces(const WallThickness& walls) {
  std::string text;
  for (const ThinPlace& place : walls.places) {
    text += fmt::format("{}{} {} mm", text.empty() ? "" : ", ", placeOf(place.at), thicknessOf(place));
  }
  return text;
}

std::string thinSentence(const PrintCheck& check) {
  const WallThickness& walls = check.walls;
  std::string text = trFormat(
      "walls are thinner than the {:g} mm that the printer makes, over {:.1f} mm² of the surface: {}. ",
      check.smallestWidth, walls.thinArea, thinPlaces(walls));
  // Nobody prints it ten times as large because of its walls.
  constexpr double mostFactor = 3;
  const double factor = check.smallestWidth / std::max(walls.firstPercentile, 1e-3);
  if (factor > mostFactor)
    return text + tr("A larger depth scale k makes it thicker, or an original that is thicker there");
  return text +
         (factor > 1
              ? trFormat("With {:.2g} times as many millimetres per unit nearly all are thick enough", factor)
              : tr("Thicken the original there in a mesh editor"));
}

std::string openSentence(const PrintCheck& check, const LeftOut& leftOut) {
  std::string text =
      trFormat("the surface is open: {} no neighbour, so no slicer can tell inside from outside. ",
               countOf(check.topology.borderEdges, "edge has", "edges have"));
  if (leftOut.foldedShare > 0) {
    return text + trFormat(
                      "{:.2g} % of the sculpture is folded and left out: bring all of it nearer to the "
                      "mirror, or beyond "
                      "where its rays cross",
                      100 * leftOut.foldedShare);
  }
  if (leftOut.notMapped > 0) {
    return text + trFormat(
                      "{} of the original did not reach the sculpture: move the "
                      "original, the eye or the mirror until all are mapped",
                      countOf(leftOut.notMapped, "vertex", "vertices"));
  }
  return text + tr("The original itself is open: close its holes in a mesh editor");
}

}  // namespace

std::optional<PrintCheck> checkPrint(const Mesh& mesh, int threads, const Progress& progress,
                                     const PrintCheckLimits& limits) {
  PrintCheck check;
  check.smallestWidth = limits.smallestWidth;
  const Mesh welded = weldPositions(mesh).mesh;
  check.box = boundingBox(mesh.positions);
  check.vertices = welded.positions.size();
  check.triangles = mesh.triangles.size();  // those that lose their area by the welding, too
  if (!progress.update(0.05)) return std::nullopt;
  const Surface surface = measureSurface(welded);
  check.topology = surface.topology;
  check.parts = surface.shells.size();
  check.insideOut = findInsideOut(welded, surface).size();
  check.doubled = findDoubled(welded.triangles).size();
  check.volume = signedVolume(welded);
  const Mesh solid = withoutFlatTriangles(welded);
  check.flatTriangles = mesh.triangles.size() - solid.triangles.size();
  if (!progress.update(0.15)) return std::nullopt;
  const Bvh bvh(solid.positions, solid.triangles, threads);
  const auto crossings =
      countSelfCrossings(solid, bvh, limits.maxCrossings, threads, partOf(progress, 0.25, 0.8));
  if (!crossings) return std::nullopt;
  check.crossings = *crossings;
  const WallQuestion question{.thin = limits.smallestWidth, .inward = check.volume < 0 ? -1.0 : 1.0};
  const auto walls = measureWalls(solid, bvh, question, threads, partOf(progress, 0.8, 1));
  if (!walls) return std::nullopt;
  check.walls = *walls;
  return check;
}

std::vector<std::string> findPrintProblems(const PrintCheck& check, const LeftOut& leftOut) {
  const SurfaceTopology& topology = check.topology;
  std::vector<std::string> problems;
  if (topology.borderEdges > 0) problems.push_back(openSentence(check, leftOut));
  if (check.doubled > 0) {
    problems.push_back(
        trFormat("{} there twice, on the same place. Remove double faces of the original in a mesh editor",
                 countOf(check.doubled, "triangle is", "triangles are")));
  } else if (topology.crowdedEdges > 0) {
    problems.push_back(
        trFormat("{} used by three or more triangles: the surface is doubled or branches "
                 "there. Remove inner and double faces of the original in a mesh editor",
                 countOf(topology.crowdedEdges, "edge is", "edges are")));
  }
  if (topology.turnedEdges > 0) {
    problems.push_back(
        trFormat("the triangles on both sides of {} face different ways. "
                 "Let a mesh editor recalculate the original's outside",
                 countOf(topology.turnedEdges, "edge", "edges")));
  }
  if (topology.pinchedCorners > 0) {
    problems.push_back(
        trFormat("parts of the surface hang together in {} only, which breaks off. Move "
                 "the original's parts apart or into each other",
                 countOf(topology.pinchedCorners, "point", "points")));
  }
  if (check.insideOut > 0) {
    problems.push_back(trFormat("{} inside out. Let a mesh editor turn the original's faces around",
                                countOf(check.insideOut, "closed part is", "closed parts are")));
  }
  if (check.crossings.pairs > 0) {
    const bool own = check.parts > 1;
    problems.push_back(trFormat(
        "the surface goes through itself: {} of triangles, the first near {}. {}", pairsOf(check.crossings),
        placeOf(*check.crossings.example),
        tr(own ? "Slicers unite closed parts that overlap; what folds over within one part may come out wrong"
               : "Slicers may fill or leave out what lies between")));
  }
  if (topology.isSound() && check.walls.samples == 0)
    problems.push_back(tr("the surface encloses nothing: both of its sides lie in the same place"));
  if (areWallsThin(check)) problems.push_back(thinSentence(check));
  return problems;
}

std::vector<std::string> findPrintHints(const PrintCheck& check) {
  std::vector<std::string> hints = check.notes;
  if (!check.walls.places.empty() && !areWallsThin(check)) {
    hints.push_back(
        trFormat("small spots are thinner than the {:g} mm that the printer makes, and may be lost: {}",
                 check.smallestWidth, thinPlaces(check.walls)));
  }
  return hints;
}

std::vector<std::pair<std::string, std::string>> printCheckRows(const PrintCheck& check) {
  const SurfaceTopology& topology = check.topology;
  const Vector size = check.box.empty() ? Vector(0) : check.box.size();
  std::vector<std::pair<std::string, std::string>> rows;
  const auto line = [&](const char* name, const std::string& value) { rows.emplace_back(tr(name), value); };
  line("size", shownFormat("{:.1f} x {:.1f} x {:.1f} mm", size.x, size.y, size.z));
  line("triangles",
       trFormat("{} ({} without area), {}, {}", check.triangles, check.flatTriangles,
                countOf(check.vertices, "vertex", "vertices"), countOf(check.parts, "part", "parts")));
  line("closed", topology.borderEdges == 0
                     ? tr("yes")
                     : trFormat("no: {}", countOf(topology.borderEdges, "border edge", "border edges")));
  const std::size_t faults = topology.crowdedEdges + topology.pinchedCorners;
  line("manifold", faults == 0
                       ? tr("yes")
                       : trFormat("no: {}, {}",
                                  countOf(topology.crowdedEdges, "edge of three or more triangles",
                                          "edges of three or more triangles"),
                                  countOf(topology.pinchedCorners, "pinched point", "pinched points")));
  line("faces outwards",
       topology.turnedEdges == 0 && check.insideOut == 0
           ? tr(topology.borderEdges == 0 ? "yes" : "consistently, as far as it goes")
           : trFormat("no: {}, {}", countOf(topology.turnedEdges, "turned edge", "turned edges"),
                      countOf(check.insideOut, "part inside out", "parts inside out")));
  line("self-intersections", check.crossings.pairs == 0 ? tr("none") : pairsOf(check.crossings));
  if (check.walls.samples > 0) {
    line("walls",
         trFormat("99 % thicker than {:.2f} mm; thinnest found {} mm near {}", check.walls.firstPercentile,
                  thicknessOf(check.walls.least), placeOf(check.walls.least.at)));
    line("smallest width", trFormat("{:g} mm; {:.1f} mm² of the surface at thinner walls",
                                    check.smallestWidth, check.walls.thinArea));
  }
  if (topology.isSound()) line("volume", shownFormat("{:.2f} cm³", check.volume / 1000));
  return rows;
}

std::string formatPrintCheck(const PrintCheck& check) {
  std::string text;
  for (const auto& [name, value] : printCheckRows(check)) text += fmt::format("{:<20}{}\n", name, value);
  return text;
}

std::string formatPrintReport(const PrintCheck& check, const LeftOut& leftOut) {
  const std::vector<std::string> problems = findPrintProblems(check, leftOut), hints = findPrintHints(check);
  const char* verdict = !problems.empty() ? tr("not as it is")
                        : hints.empty()   ? tr("yes")
                                          : tr("yes, with care");
  std::string text = formatPrintCheck(check) + fmt::format("{:<20}{}\n", tr("printable"), verdict);
  for (const std::string& problem : problems) text += "- " + problem + "\n";
  for (const std::string& hint : hints) text += "- " + hint + "\n";
  return text;
}

JsonValue printCheckJson(const PrintCheck& check, const LeftOut& leftOut) {
  const SurfaceTopology& topology = check.topology;
  JsonObject object;
  object.add("vertices", check.vertices)
      .add("triangles", check.triangles)
      .add("flatTriangles", check.flatTriangles)
      .add("borderEdges", topology.borderEdges)
      .add("crowdedEdges", topology.crowdedEdges)
      .add("turnedEdges", topology.turnedEdges)
      .add("pinchedCorners", topology.pinchedCorners)
      .add("doubledTriangles", check.doubled)
      .add("parts", check.parts)
      .add("partsInsideOut", check.insideOut)
      .add("selfIntersections", check.crossings.pairs)
      .add("moreSelfIntersections", check.crossings.more);
  JsonValue walls;
  if (check.walls.samples > 0) {
    JsonValue places = emptyList();
    for (const ThinPlace& place : check.walls.places)
      places.items.push_back(JsonObject().add("atMm", place.at).add("mm", place.thickness).value());
    walls = JsonObject()
                .add("leastMm", check.walls.least.thickness)
                .add("leastAtMm", check.walls.least.at)
                .add("firstPercentileMm", check.walls.firstPercentile)
                .add("smallestWidthMm", check.smallestWidth)
                .add("thinAreaMm2", check.walls.thinArea)
                .add("thinPlaces", std::move(places))
                .value();
  }
  object.add("walls", walls);
  object.add("boundsMm", JsonObject().add("min", check.box.min).add("max", check.box.max).value());
  if (topology.isSound()) object.add("volumeMm3", check.volume);
  const std::vector<std::string> problems = findPrintProblems(check, leftOut);
  object.add("printable", problems.empty());
  object.add("problems", textList(problems));
  object.add("notes", textList(check.notes));
  return object.value();
}

}  // namespace anamorph
