// Short taps of keys for Dear ImGui 1.86, which looks at keys once a frame: a key that was pressed since the last
// frame is let go of after the next one, however short the tap was.
//
//   frame            frame                     frame
//     |    down up     |  sees it down  |  up    |
#pragma once

#include <set>
#include <utility>
#include <vector>

namespace anamorph {

class KeyTaps {
 public:
  struct Release {
    int key, code, modifiers;
  };

  void press(int key) {
    fresh_.insert(key);
    std::erase_if(late_, [&](const Release& release) { return release.key == key; });  // it is held again
  }
  /// Whether the release has to wait for the next frame.
  bool waits(const Release& release) {
    if (fresh_.count(release.key) == 0) return false;
    late_.push_back(release);
    return true;
  }
  /// After a frame: the keys that are to be let go of now.
  std::vector<Release> takeReleases() {
    fresh_.clear();
    return std::exchange(late_, {});
  }

 private:
  std::set<int> fresh_;  // pressed since the last frame
  std::vector<Release> late_;
};

}  // namespace anamorph
