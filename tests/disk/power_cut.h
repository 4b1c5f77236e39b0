// Cuts the power at every moment of some saves, and looks at every disk that may then be there (disk_model.h).
#pragma once

#include <cstddef>
#include <exception>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/program.h"
#include "disk/disk_calls.h"
#include "disk/disk_model.h"

namespace anamorph::testing {

using Step = std::function<void(const std::filesystem::path& folder)>;
/// What a user has, as text; throws where it cannot be read.
using Document = std::function<std::string(const std::filesystem::path& folder)>;

struct PowerCuts {
  std::size_t moments = 0;
  std::string fault;  ///< the first disk that has neither the old document nor the new one; empty: none
};

/// The document of a disk.
inline std::string documentOn(const DiskImage& disk, const Document& document) {
  const TemporaryFolder folder;
  writeImage(disk, folder / "");
  return document(folder / "");
}

/// Likewise, or what is wrong with it.
inline std::string lookAt(const DiskImage& disk, const Document& document) {
  try {
    return documentOn(disk, document);
  } catch (const std::exception& error) {
    return std::string("unreadable: ") + error.what();
  }
}

/// The first disk that has none of these documents, and what it has instead; empty: all have one.
inline std::string findLoss(const std::set<DiskImage>& disks, const std::set<std::string>& allowed,
                            const Document& document) {
  for (const DiskImage& disk : disks) {
    const std::string found = lookAt(disk, document);
    if (allowed.count(found) > 0) continue;
    std::string expected;
    for (const std::string& text : allowed) expected += (expected.empty() ? "\"" : " or \"") + text + "\"";
    return "expected " + expected + ", got \"" + found + "\"";
  }
  return {};
}

/// Takes the steps in an empty folder, up to the first fault. Within each, every disk has to hold the document from
/// before it or the one from after it; once it has returned, the one from after it. Calls of the kind `unheard` do
/// nothing to the disk: as if the program did not make them.
inline PowerCuts cutPower(const std::vector<Step>& steps, const Document& document,
                          std::optional<DiskChange> unheard = std::nullopt) {
  const TemporaryFolder folder;
  const std::filesystem::path live = std::filesystem::path(folder / "").parent_path();
  const DiskWatch watch(live);
  DiskModel model({});
  PowerCuts cuts;
  std::size_t applied = 0;
  std::string before = documentOn({}, document);
  for (const Step& step : steps) {
    step(live);
    const std::vector<DiskCall> calls = watch.calls();
    const std::string after = documentOn(readImage(live), document);
    for (; applied < calls.size(); ++applied, ++cuts.moments) {
      const DiskCall& call = calls[applied];
      const std::string loss = findLoss(model.imagesAfterPowerCut(), {before, after}, document);
      if (!loss.empty()) return {cuts.moments, "before " + describe(call) + ": " + loss};
      if (call.change != unheard) model.apply(call);
    }
    const std::string loss = findLoss(model.imagesAfterPowerCut(), {after}, document);
    if (!loss.empty()) return {cuts.moments, "once it is done: " + loss};
    before = after;
  }
  return cuts;
}

}  // namespace anamorph::testing
