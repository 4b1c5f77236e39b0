#include "disk/disk_model.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <numeric>
#include <stdexcept>

namespace anamorph::testing {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t maxPending = 6;  // of a folder: all their orders are tried

std::string folderOf(const std::string& path) {
  return fs::path(path).parent_path().string();
}

std::string nameOf(const std::string& path) {
  return fs::path(path).filename().string();
}

std::string overlaid(std::string bytes, std::size_t offset, const std::string& piece) {
  bytes.resize(std::max(bytes.size(), offset + piece.size()), '\0');
  bytes.replace(offset, piece.size(), piece);
  return bytes;
}

}  // namespace

DiskImage readImage(const fs::path& folder) {
  DiskImage image;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    auto& bytes = image[entry.path().lexically_relative(folder).string()];
    if (entry.is_directory()) continue;
    std::ifstream file(entry.path(), std::ios::binary);
    bytes = std::string(std::istreambuf_iterator<char>(file), {});
  }
  return image;
}

void writeImage(const DiskImage& image, const fs::path& folder) {
  for (const auto& [path, bytes] : image) {  // folders come before what is in them
    bytes ? void(std::ofstream(folder / path, std::ios::binary) << *bytes)
          : void(fs::create_directory(folder / path));
  }
}

DiskModel::DiskModel(const DiskImage& image) : nodes_(1) {
  nodes_.front().isFolder = true;
  for (const auto& [path, bytes] : image) {
    Node& node = nodes_[make(path, !bytes)];
    node.bytes = node.sureBytes = bytes.value_or("");
  }
  for (Node& node : nodes_) {
    node.sureEntries = node.entries;
    node.pending.clear();
  }
}

std::optional<std::size_t> DiskModel::find(const std::string& path) const {
  std::size_t node = 0;
  for (const fs::path& name : fs::path(path)) {
    const auto found = nodes_[node].entries.find(name.string());
    if (found == nodes_[node].entries.end()) return std::nullopt;
    node = found->second;
  }
  return node;
}

void DiskModel::change(std::size_t folder, const Renaming& renaming) {
  Node& node = nodes_[folder];
  for (const auto& [name, target] : renaming.names) {
    node.entries.erase(name);
    if (target) node.entries[name] = *target;
  }
  node.pending.push_back(renaming);
}

std::size_t DiskModel::make(const std::string& path, bool folder) {
  const std::size_t made = nodes_.size();
  nodes_.emplace_back().isFolder = folder;
  change(find(folderOf(path)).value(), {{{nameOf(path), made}}});
  return made;
}

void DiskModel::apply(const DiskCall& call) {
  switch (call.change) {
    case DiskChange::openFile: {
      const auto found = find(call.path);
      const std::size_t node = found ? *found : make(call.path, false);
      open_[call.descriptor] = {node};
      if (!found || call.offset == 0) return;
      nodes_[node].bytes.clear();
      nodes_[node].pieces.clear();
      nodes_[node].unsure = true;
      return;
    }
    case DiskChange::openFolder:
      open_[call.descriptor] = {find(call.path).value()};
      return;
    case DiskChange::write: {
      Open& open = open_.at(call.descriptor);
      Node& node = nodes_[open.node];
      node.bytes = overlaid(node.bytes, open.offset, call.text);
      node.pieces.push_back({open.offset, call.text});
      node.unsure = true;
      open.offset += call.text.size();
      return;
    }
    case DiskChange::truncate: {
      Node& node = nodes_[open_.at(call.descriptor).node];
      node.bytes.resize(static_cast<std::size_t>(call.offset), '\0');
      node.pieces.clear();
      node.unsure = true;
      return;
    }
    case DiskChange::sync:
    case DiskChange::syncFolder: {
      Node& node = nodes_[open_.at(call.descriptor).node];
      node.sureEntries = node.entries;
      node.pending.clear();
      node.sureBytes = node.bytes;
      node.pieces.clear();
      node.unsure = false;
      return;
    }
    case DiskChange::rename: {
      if (folderOf(call.path) != folderOf(call.text)) throw std::logic_error("renamed between folders");
      const std::size_t node = find(call.path).value();
      const Renaming both{{{nameOf(call.path), std::nullopt}, {nameOf(call.text), node}}};
      return change(find(folderOf(call.path)).value(), both);
    }
    case DiskChange::remove:
      return change(find(folderOf(call.path)).value(), {{{nameOf(call.path), std::nullopt}}});
    case DiskChange::makeFolder:
      make(call.path, true);
      return;
    case DiskChange::close:
      open_.erase(call.descriptor);
      return;
    case DiskChange::attribute:
      return;
  }
}

// Some of what is pending, in any order.
std::set<DiskModel::Entries> DiskModel::possibleEntries(const Node& node) const {
  const std::size_t count = node.pending.size();
  if (count > maxPending) throw std::logic_error("too much is pending in a folder");
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::set<Entries> possible;
  do {
    Entries entries = node.sureEntries;
    possible.insert(entries);
    for (const std::size_t i : order) {
      for (const auto& [name, target] : node.pending[i].names) {
        entries.erase(name);
        if (target) entries[name] = *target;
      }
      possible.insert(entries);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return possible;
}

// All, nothing, half, the right size without the bytes, and all but one of the writes.
std::set<std::string> DiskModel::possibleBytes(const Node& node) const {
  if (!node.unsure) return {node.bytes};
  const std::size_t size = node.bytes.size();
  std::set<std::string> possible{node.sureBytes, node.bytes, "", node.bytes.substr(0, size / 2),
                                 std::string(size, '\0')};
  for (std::size_t missing = 0; missing < node.pieces.size(); ++missing) {
    std::string bytes(size, '\0');
    for (std::size_t i = 0; i < node.pieces.size(); ++i) {
      if (i != missing) bytes = overlaid(bytes, node.pieces[i].offset, node.pieces[i].bytes);
    }
    possible.insert(bytes);
  }
  return possible;
}

// What may be behind one name of a folder.
std::set<DiskImage> DiskModel::possibleParts(const std::string& name, const Node& node) const {
  std::set<DiskImage> parts;
  if (!node.isFolder) {
    for (const std::string& bytes : possibleBytes(node)) parts.insert(DiskImage{{name, bytes}});
    return parts;
  }
  for (const DiskImage& below : possibleImages(node)) {
    DiskImage part{{name, std::nullopt}};
    for (const auto& [path, bytes] : below) part[name + "/" + path] = bytes;
    parts.insert(part);
  }
  return parts;
}

std::set<DiskImage> DiskModel::possibleImages(const Node& folder) const {
  std::set<DiskImage> possible;
  for (const Entries& entries : possibleEntries(folder)) {
    std::set<DiskImage> images{{}};
    for (const auto& [name, node] : entries) {
      const std::set<DiskImage> parts = possibleParts(name, nodes_[node]);
      std::set<DiskImage> larger;
      for (const DiskImage& image : images) {
        for (const DiskImage& part : parts) {
          DiskImage joined = image;
          joined.insert(part.begin(), part.end());
          larger.insert(std::move(joined));
        }
      }
      images = std::move(larger);
    }
    possible.merge(images);
  }
  return possible;
}

std::set<DiskImage> DiskModel::imagesAfterPowerCut() const {
  return possibleImages(nodes_.front());
}

}  // namespace anamorph::testing
