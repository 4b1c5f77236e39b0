// A level in a file of its own, and workspaces that come to rest, for tests of lessons.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

#include "edit/workspace.h"
#include "level/level_json.h"

namespace anamorph::testing {

/// Removed with its folder at the end.
class LevelFile {
 public:
  LevelFile() {
    std::string name = (std::filesystem::temp_directory_path() / "anamorph-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~LevelFile() { std::filesystem::remove_all(folder_); }
  LevelFile(const LevelFile&) = delete;
  LevelFile& operator=(const LevelFile&) = delete;

  void save(const Level& level) { saveLevel(path(), level); }
  std::filesystem::path path() const { return folder_ / "level.json"; }

 private:
  std::filesystem::path folder_;
};

/// Frames until everything is computed, nothing moves and the lesson has seen it.
inline void settle(Workspace& work) {
  for (int calm = 0; calm < 3; ++calm) {
    while (work.flight || work.lesson.play) advance(work, 0.05);
    work.studio.finish(work.session, {work.preview.size, false});
    advance(work, 0.01);
  }
}

}  // namespace anamorph::testing
