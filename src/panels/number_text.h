// A number in a field or slider of Dear ImGui, which writes and reads numbers as C does: people see it as their language
// writes it (base/language.h), and may type a comma for the point.
#pragma once

#include <string>

#include <imgui.h>

namespace anamorph {

/// Around the widget "##value" of a number: while it lives Dear ImGui writes no number, and at its end it writes its own,
/// unless one is being typed.
class NumberText {
 public:
  /// `format`: the widget's, "%.2f px".
  NumberText(const char* format, const double& value);
  ~NumberText();
  NumberText(const NumberText&) = delete;
  NumberText& operator=(const NumberText&) = delete;

 private:
  const char* format_;
  const double& value_;
  bool typed_;
};

/// "0,25 px": what the format of C says, as people read it.
std::string numberText(const char* format, double value);

}  // namespace anamorph
