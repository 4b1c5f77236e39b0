// How much can be typed and pasted into a text field: every letter is asked for, and what does not go in is not taken.
// What stands there already stays, however long it is.
#pragma once

#include <cstddef>
#include <string>

#include <imgui.h>

namespace anamorph {

class TypingLimit {
 public:
  /// For this frame; `most`: bytes.
  TypingLimit(const std::string& text, std::size_t most)
      : room_(most - (text.size() < most ? text.size() : most)) {}

  /// Whether this letter goes in; then there is less room for the next.
  bool takes(unsigned letter) {
    const std::size_t bytes = letter < 0x80 ? 1 : letter < 0x800 ? 2 : letter < 0x10000 ? 3 : 4;
    if (bytes > room_) return false;
    room_ -= bytes;
    return true;
  }

  /// For ImGuiInputTextFlags_CallbackCharFilter, with a TypingLimit as user data.
  static int filter(ImGuiInputTextCallbackData* data) {
    return static_cast<TypingLimit*>(data->UserData)->takes(data->EventChar) ? 0 : 1;
  }

 private:
  std::size_t room_;
};

}  // namespace anamorph
