#include "panels/keys.h"

#include <algorithm>

#include <fmt/format.h>

namespace anamorph {
namespace {

std::string bareName(int code) {
  struct Name {
    int code;
    const char* name;
  };
  constexpr Name names[] = {{keys::escape, "Esc"}, {keys::tab, "Tab"},        {keys::space, "Space"},
                            {keys::home, "Home"},  {keys::pageUp, "Page Up"}, {keys::pageDown, "Page Down"},
                            {keys::left, "Left"},  {keys::right, "Right"}};
  for (const Name& known : names) {
    if (known.code == code) return known.name;
  }
  if (code >= keys::f1 && code <= keys::f12) return fmt::format("F{}", code - keys::f1 + 1);
  if (code >= keys::pad0 && code < keys::pad0 + 10) return std::to_string(code - keys::pad0);
  return {static_cast<char>(code)};
}

}  // namespace

std::string keyName(const Key& key) {
  if (key.code == 0) return "";
  std::string name;
  if ((key.modifiers & keys::control) != 0) name += "Ctrl+";
  if ((key.modifiers & keys::shift) != 0) name += "Shift+";
  if ((key.modifiers & keys::alt) != 0) name += "Alt+";
  return name + bareName(key.code);
}

bool isTyped(const DialogKeys& typed, int key) {
  return std::any_of(typed.begin(), typed.end(), [&](const DialogKey& one) { return one.key == key; });
}

bool isEnterTyped(const DialogKeys& typed) {
  return isTyped(typed, keys::enter) || isTyped(typed, keys::padEnter);
}

}  // namespace anamorph
