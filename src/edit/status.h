// What the status line says about what was done last. A sentence about the level holds for that level only: as soon as
// the level is another one, by an edit, an undo or a drag, it goes, so that nothing is said of an earlier state. What is
// not about the level (a file that could not be written) stays until something else is said.
#pragma once

#include <optional>
#include <string>

#include "level/level.h"

namespace anamorph {

class Status {
 public:
  /// About the level as it is.
  void sayOf(const Level& level, std::string text);
  /// About something else.
  void say(std::string text);
  void clear() { *this = {}; }

  /// A frame begins with this level: forgets what was said of another one.
  void update(const Level& level);

  /// Empty: nothing.
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::optional<Level> level_;  // that the text is about
};

}  // namespace anamorph
