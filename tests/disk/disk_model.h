// What may be on the disk after a power cut, as POSIX leaves it open.
//
// What a file holds is sure only when it was synced: what was written since may be there, or not, or in part. What a
// folder lists is sure only when the folder was synced: each name that was made, given or removed since may be so or
// not, and later ones may be without earlier ones.
//
//      open tmp, write, sync tmp, rename tmp to doc                      | power cut
//      disks: nothing happened; tmp beside the old doc; doc is new; doc is new and tmp is there, too
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "disk/disk_calls.h"

namespace anamorph::testing {

/// Files with their bytes, folders without, by their paths.
using DiskImage = std::map<std::string, std::optional<std::string>>;

DiskImage readImage(const std::filesystem::path& folder);
/// Makes the (empty) folder hold just that.
void writeImage(const DiskImage& image, const std::filesystem::path& folder);

class DiskModel {
 public:
  /// A disk that has all of this for sure.
  explicit DiskModel(const DiskImage& image);

  void apply(const DiskCall& call);
  /// All that may be there if the power fails now.
  std::set<DiskImage> imagesAfterPowerCut() const;

 private:
  using Entries = std::map<std::string, std::size_t>;  // names and nodes
  struct Renaming {
    std::vector<std::pair<std::string, std::optional<std::size_t>>> names;  // nothing: the name goes
  };
  struct Piece {
    std::size_t offset;
    std::string bytes;
  };
  struct Node {
    bool isFolder = false;
    Entries entries, sureEntries;
    std::vector<Renaming> pending;
    std::string bytes, sureBytes;
    std::vector<Piece> pieces;  // written since sureBytes
    bool unsure = false;        // written or truncated since sureBytes
  };
  struct Open {
    std::size_t node, offset = 0;
  };

  std::optional<std::size_t> find(const std::string& path) const;
  void change(std::size_t folder, const Renaming& renaming);
  std::size_t make(const std::string& path, bool folder);
  std::set<Entries> possibleEntries(const Node& node) const;
  std::set<std::string> possibleBytes(const Node& node) const;
  std::set<DiskImage> possibleParts(const std::string& name, const Node& node) const;
  std::set<DiskImage> possibleImages(const Node& folder) const;

  std::vector<Node> nodes_;  // the first is the folder itself
  std::map<int, Open> open_;
};

}  // namespace anamorph::testing
