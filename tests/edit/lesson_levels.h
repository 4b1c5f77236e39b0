// A level in a file of its own, and editors that come to rest, for tests of lessons.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

#include "edit/advance.h"
#include "edit/editor.h"
#include "level/level_json.h"

namespace anamorph::testing {

/// Removed with its folder at the end.
class LessonFile {
 public:
  LessonFile() {
    std::string name = (std::filesystem::temp_directory_path() / "anamorph-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~LessonFile() { std::filesystem::remove_all(folder_); }
  LessonFile(const LessonFile&) = delete;
  LessonFile& operator=(const LessonFile&) = delete;

  void save(const Level& level) { saveLevel(path(), level); }
  std::filesystem::path path() const { return folder_ / "level.json"; }

 private:
  std::filesystem::path folder_;
};

/// Frames until everything is computed, nothing moves and the lesson has seen it.
inline void evaluate(Editor& editor) {
  for (int calm = 0; calm < 3; ++calm) {
    while (editor.flight || editor.lesson.play) advance(editor, 0.05);
    editor.updater.finish(editor.session, {editor.preview.size, false});
    advance(editor, 0.01);
  }
}

}  // namespace anamorph::testing
