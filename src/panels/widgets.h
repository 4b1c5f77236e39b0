// Rows of a property panel: a name on the left, a control on the right, an explanation when the mouse rests
// on either. Every control works on a copy of its value and returns whether it was changed, so that panels
// can compare and hand the copy to the session.
//
// Names, choices and explanations are given in English and shown in the chosen language (base/language.h).
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <imgui.h>

#include "level/limits.h"
#include "math/vec.h"
#include "panels/layout.h"
#include "panels/look.h"

namespace anamorph {

struct NumberRange : Range {
  double speed = 0.02;  ///< change per pixel dragged
  const char* format = "%.2f";
};

/// What is shown in the chosen language, with the English text as Dear ImGui's identity.
std::string label(const char* english);

/// A window over the others that can be moved and closed: in the middle at first, never larger than the
/// display, width and height at 100 %; height 0: as high as what is in it. `id`, "###help", is the same in
/// every language. Pair with ImGui::End(), whatever it returns.
bool beginToolWindow(const Look& look, const char* english, const char* id, bool& open, float width,
                     float height, float mostHeight = 0.94f);

/// A heading that folds; returns whether what is below it is to be drawn.
bool section(const Look& look, const char* title, bool open = true);

bool numberRow(const char* name, double& value, const NumberRange& range, const char* help = "");
/// With a slider in place of a field: for values whose whole range makes sense. `power`: logarithmic.
bool sliderRow(const char* name, double& value, const NumberRange& range, const char* help = "",
               bool logarithmic = false);
bool integerRow(const char* name, int& value, const Range& range, const char* help = "");
/// Three numbers with their axis' colours.
bool vectorRow(const char* name, Vector& value, const NumberRange& range, const char* help = "");
bool checkRow(const char* name, bool& value, const char* help = "");
/// Linear light in, linear light out; shown and picked as displays show it.
bool colorRow(const char* name, Color& value, const char* help = "");
bool choiceRow(const char* name, int& value, const std::vector<const char*>& choices, const char* help = "");
/// A line of text that can be typed, up to so many bytes (what does not go in is not taken).
bool textFieldRow(const char* name, std::string& value, std::size_t most, const char* help = "");
void textRow(const char* name, const std::string& value, const char* help = "");

/// A five-pointed star, for badges.
void drawStar(const ImVec2& middle, float radius);

/// Appears when the mouse has rested on the last item for half a second.
void tooltip(const char* text);

/// What is dragged or typed into is let go of, though the mouse button may still be down: the level that it
/// works on has been replaced.
void letGoOfWidgets();

/// Closes an open menu, list or colour picker. Returns whether there was one.
bool closePopups();

/// Wrapped text, shown as it is, at `wrapAt` in the window (0: at its right edge). What no message needs is cut off:
/// texts that may be long are drawn by LongTexts.
void paragraph(const std::string& text, float wrapAt = 0);
/// How high it is in so much room.
float paragraphHeight(const std::string& text, float width);

/// A title or a name, cut where it is longer than any line.
std::string inOneLine(const std::string& text);

/// Wrapped text of second rank.
void quietText(const Look& look, const char* text);

/// Sentences of the pipeline begin in small letters, as they come after a file's name elsewhere.
std::string capitalised(std::string sentence);

/// What is wrong, in red, below the row that it is about; begins with a capital letter. Nothing for an empty
/// text.
void problemText(const Look& look, const std::string& text);

/// A button as wide as the column.
bool wideButton(const char* name, const char* help = "", bool enabled = true);

/// A button of this width whose text may come near to its border.
bool fittedButton(const char* name, float width);

/// How many columns, at most `columns`, have room for the longest of these names, so that all rows are about as long as
/// each other.
int columnsFor(const std::vector<const char*>& names, int columns, float gap);

/// One of several choices side by side, as rows of buttons that fill the width; fewer columns where the names have no
/// room.
bool segmentedControl(const char* id, int& chosen, const std::vector<const char*>& names, int columns);

/// A window that is part of the fixed arrangement. Pair with ImGui::End().
bool beginPanel(const char* name, const Rect& rect, bool padded = true, bool scrolls = true);

}  // namespace anamorph
