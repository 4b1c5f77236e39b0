// Keys by their codes, and how they are called in menus.
#pragma once

#include <string>
#include <vector>

namespace anamorph {

/// Key codes as GLFW numbers them: letters and digits are their capital ASCII characters.
namespace keys {
constexpr int escape = 256, enter = 257, tab = 258, backspace = 259, right = 262, left = 263, down = 264,
              up = 265, pageUp = 266, pageDown = 267, home = 268, end = 269, padEnter = 335, f1 = 290,
              f2 = 291, f3 = 292, f4 = 293, f5 = 294, f6 = 295, f11 = 300, f12 = 301, pad0 = 320, space = 32;
constexpr int shift = 1, control = 2, alt = 4;
}  // namespace keys

/// A key with exactly these modifiers; code 0: none.
struct Key {
  int code = 0;
  int modifiers = 0;

  bool operator==(const Key&) const = default;
};

/// "Ctrl+Shift+S", "Page Up", "F3"; a key of the number pad has its digit's name.
std::string keyName(const Key& key);

/// A key that was pressed while a dialog was open.
struct DialogKey {
  int key = 0;
  bool repeated = false;  ///< it is held down
};
using DialogKeys = std::vector<DialogKey>;

bool isTyped(const DialogKeys& typed, int key);
/// Whether Enter was, on either half of the keyboard.
bool isEnterTyped(const DialogKeys& typed);

}  // namespace anamorph
