// The controls that lessons can point at are those that the panels draw: each row and button that the source names.

#include "level/step_controls.h"

#include <algorithm>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "optics/shape_table.h"
#include "source_text.h"

namespace anamorph {
namespace {

// The string literals in what the expression's first group takes from the text.
void addNames(std::set<std::string>& names, const std::string& text, const char* expression) {
  const std::regex call(expression), literal("\"([^\"]+)\"");
  for (std::sregex_iterator each(text.begin(), text.end(), call), end; each != end; ++each) {
    const std::string part = each->str(1);
    for (std::sregex_iterator name(part.begin(), part.end(), literal); name != end; ++name)
      names.insert(name->str(1));
  }
}

TEST(StepControls, AreThoseThatThePanelsDraw) {
  std::set<std::string> drawn{"Mirror", "Canvas", "Reflection", "Seen by the eye"};  // a tab has either
  for (const char* file :
       {"eye_properties", "original_properties", "mirror_properties", "sculpture_properties",
        "light_properties", "ray_properties", "view_properties", "material_rows", "help_buttons",
        "preview_panel", "properties_panel", "lesson_panel", "view_windows", "view_overlay"}) {
    const std::string text = textOf(sourceFolder / "src" / "panels" / (std::string(file) + ".cpp"));
    addNames(drawn, text,
             "\\b(?:[a-zA-Z]+Row|row|wideButton|highlightItem|highlightArea)\\(((?:\"[^\"]*\"|[^"
             "\",;{])*)");
    addNames(drawn, text, "\\bsearchButton\\(editor, (\"[^\"]*\")");
    addNames(drawn, text, "segmentedControl\\([^{;]*\\{([^}]*)\\}");
  }
  ASSERT_GT(drawn.size(), 50u);
  const std::set<std::string> listed(stepControls().begin(), stepControls().end());
  for (const std::string& name : drawn) EXPECT_EQ(listed.count(name), 1u) << "not in the list: " << name;
  for (const char* row : {"Corner 4", "Radius", "Top radius", "Height"})
    EXPECT_EQ(listed.count(row), 1u) << row;

  class Labels : public ShapeFields {
   public:
    void point(const FieldName& name, Point&) override { all.insert(name.label); }
    void direction(const FieldName& name, Vector&) override { all.insert(name.label); }
    void angles(const FieldName& name, Vector&) override { all.insert(name.label); }
    void flag(const FieldName& name, bool&) override { all.insert(name.label); }
    void lengths(const FieldName& name, std::span<double>) override { all.insert(name.label); }
    void radii(const FieldName& name, std::vector<double>&) override { all.insert(name.label); }
    void curve(const FieldName& name, std::vector<CurvePoint>&) override { all.insert(name.label); }
    void heights(const FieldName& name, HeightGrid&) override { all.insert(name.label); }
    void file(const FieldName& name, SurfaceFile&) override { all.insert(name.label); }
    void length(const FieldName& name, double&) override { all.insert(name.label); }
    void points(const FieldName& name, std::span<Point>) override { all.insert(name.label); }
    void distance(const FieldName& name, const Point&, Point&) override { all.insert(name.label); }
    std::set<std::string> all;
  } labels;
  for (const ShapeType& type : shapeTypes()) {
    Shape shape = type.standard;
    visitFields(shape, labels);
  }
  for (const std::string& name : listed) {
    const bool ofShape = std::any_of(labels.all.begin(), labels.all.end(),
                                     [&](const std::string& label) { return name.find(label) == 0; });
    EXPECT_TRUE(drawn.count(name) == 1 || ofShape) << "drawn nowhere: " << name;
  }
}

}  // namespace
}  // namespace anamorph
