// A printed page as plain data: what is on it, in millimetres from its top left corner, y downwards, in the
// order in which it is painted. Made by pure functions, written by page_file.h.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>

#include "math/vec.h"

namespace anamorph {

struct Pen {
  double width = 0.25;
  Color color{0};            ///< as printed (sRGB)
  std::vector<double> dash;  ///< lengths of ink and gap; empty: solid

  bool operator==(const Pen&) const = default;
};

/// Lines through points; several of them are one shape, in which holes stay open.
struct PageShape {
  std::vector<std::vector<glm::dvec2>> lines;
  bool closed = false;
  std::optional<Pen> pen;
  std::optional<Color> fill;
};

struct PageCircle {
  glm::dvec2 centre{0};
  double radius = 1;
  std::optional<Pen> pen;
  std::optional<Color> fill;
};

enum class TextAlign { left, centre, right };

struct PageText {
  glm::dvec2 at{0};  ///< on the base line: its beginning, middle or end
  std::string text;
  double size = 3;  ///< of the letter m, millimetres
  bool bold = false;
  TextAlign align = TextAlign::left;
  bool upwards = false;  ///< turned to be read from the right
  Color color{0};
};

using PageItem = std::variant<PageShape, PageCircle, PageText>;

/// The paper a page is for, upright.
enum class Paper { a4, a3, letter };

struct Page {
  double width = 210, height = 297;
  std::string title;
  std::vector<PageItem> items;
};

}  // namespace anamorph
