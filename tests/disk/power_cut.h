// Cuts the power at every moment of some saves, and looks at every disk that may then be there (disk_model.h).
#pragma once

#include <cstddef>
#include <exception>
#include <filesystem>
#include <functional>
#include <set>
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
  std::size_t moments = 0, disks = 0;
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

/// Takes the steps in an empty folder. Within each, every disk has to hold the document from before it or the one from
/// after it; once it has returned, the one from after it.
inline PowerCuts cutPower(const std::vector<Step>& steps, const Document& document) {
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
    while (true) {
      const bool returned = applied == calls.size();
      for (const DiskImage& disk : model.imagesAfterPowerCut()) {
        ++cuts.disks;
        const std::string found = lookAt(disk, document);
        if (found == after || (!returned && found == before)) continue;
        const std::string moment = returned ? "after all was done" : "before " + describe(calls[applied]);
        if (cuts.fault.empty()) {
          cuts.fault = moment + ": expected \"" + before + "\" or \"" + after + "\", got \"" + found + "\"";
        }
      }
      ++cuts.moments;
      if (returned) break;
      model.apply(calls[applied++]);
    }
    before = after;
  }
  return cuts;
}

}  // namespace anamorph::testing
