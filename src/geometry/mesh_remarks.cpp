#include "geometry/mesh_remarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace anamorph {

MeshRemarks::Counted& MeshRemarks::find(const Remark& kind) {
  const auto found =
      std::find_if(counted_.begin(), counted_.end(), [&](const Counted& c) { return c.kind == &kind; });
  return found != counted_.end() ? *found : counted_.emplace_back(Counted{&kind, 0, {}, {}});
}

bool MeshRemarks::has(const Remark& kind) const {
  return std::any_of(counted_.begin(), counted_.end(), [&](const Counted& c) { return c.kind == &kind; });
}

void MeshRemarks::setPlace(Counted& counted, RemarkPlace place) {
  if (!place.problem.empty() && !firstFault_)
    firstFault_ = Error(std::move(place.problem), file_, place.where);
  counted.where = std::move(place.where);
}

void MeshRemarks::say(std::string where, std::string text) {
  counted_.push_back({nullptr, 1, std::move(where), std::move(text)});
}

std::vector<std::string> MeshRemarks::warnings() const {
  std::vector<std::string> warnings;
  for (const auto& [kind, count, where, text] : counted_) {
    const bool isRange = count > 1 && !where.empty();
    std::string what = !kind        ? text
                       : count == 1 ? std::string(kind->one)
                                    : fmt::vformat(kind->many, fmt::make_format_args(count));
    warnings.emplace_back(Error(std::move(what), file_, isRange ? "from " + where + " on" : where).what());
  }
  return warnings;
}

void failWithoutTriangles(const MeshRemarks& remarks, std::string_view what, std::size_t vertices) {
  if (remarks.firstFault()) throw *remarks.firstFault();
  if (vertices == 0) throw Error("expected at least one triangle, got none and 0 vertices", remarks.file());
  throw Error(fmt::format("expected at least one triangle, got {} of {}: it has no surface. Make a mesh of "
                          "it first",
                          what, vertices == 1 ? "1 vertex" : fmt::format("{} vertices", vertices)),
              remarks.file());
}

}  // namespace anamorph
