// The match report to keep: as JSON for programs, and as one HTML page with its pictures inside for people.
#pragma once

#include <string>

#include "level/json_object.h"
#include "pipeline/picture.h"

namespace anamorph {

/// {"mapped": 6146, "missesMirror": 0, ...}
JsonValue statusJson(const StatusCounts& counts);

/// {"size": ..., "silhouetteIou": ..., ...}; correspondencePx is null when no pixel could be compared.
JsonValue matchJson(const MatchReport& report, const StatusCounts& counts);

/// What the page shows, all of one size.
struct MatchPictures {
  Image reflection, original, difference;
};

/// A page of its own: no other file, no network, no script.
std::string makeMatchPage(const LevelResult& finished, const MatchReport& report,
                          const MatchPictures& pictures);

/// Bytes as letters (RFC 4648), as data: URIs want them.
std::string encodeBase64(std::string_view bytes);

}  // namespace anamorph
