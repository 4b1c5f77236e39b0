// Pages as PDF and SVG, through cairo: one drawing code for both, into memory.
#pragma once

#include <string>

#include "exports/page.h"

namespace anamorph {

enum class PageFormat { pdf, svg };

/// The bytes of the file: one page, at its size in millimetres. The same page gives the same bytes.
std::string encodePage(const Page& page, PageFormat format);

/// How wide a text is, in millimetres.
double textWidth(const std::string& text, double size, bool bold = false);

}  // namespace anamorph
