// The legend against the table of looks, which the 3D view draws its rays by (tests/viewport/ray_lines_test.cpp).

#include <vector>

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "panels_fixture.h"
#include "raytrace/ray_looks.h"

namespace anamorph {
namespace {

using namespace anamorph::testing;

class Legend : public PanelsTest {
 protected:
  struct Entry {
    ImU32 color;
    int pieces;  // of its line: 1 when it is solid
  };

  // The lines of the legend from top to bottom; letters are left out by their colour.
  std::vector<Entry> entries() {
    frames(3);
    std::vector<Entry> found;
    const ImGuiWindow* window = ImGui::FindWindowByName("##legend");
    if (!window) return found;
    const ImU32 text = ImGui::GetColorU32(ImGuiCol_Text);
    const ImVector<ImDrawVert>& v = window->DrawList->VtxBuffer;
    for (int i = 0; i < v.Size; ++i) {
      const ImU32 opaque = v[i].col | IM_COL32_A_MASK;
      const bool isInk = (v[i].col & IM_COL32_A_MASK) == IM_COL32_A_MASK && v[i].col != text;
      if (!isInk) continue;
      if (found.empty() || found.back().color != opaque) found.push_back({opaque, 0});
      ++found.back().pieces;
    }
    return found;
  }
};

TEST_F(Legend, ShowsEveryRayAsTheViewDrawsIt) {
  open("2-cylinder");
  editor.rays.lightRays = true;
  editor.rays.hideNoHit = false;
  const std::vector<Entry> shown = entries();
  ASSERT_EQ(shown.size(), rayLooks.size());
  for (std::size_t i = 0; i < rayLooks.size(); ++i) {
    EXPECT_EQ(shown[i].color, ink::of(rayLooks[i].line.color)) << rayLooks[i].line.legend;
  }
  const auto pieces = [&](RayKind kind) { return shown[static_cast<std::size_t>(kind)].pieces; };
  EXPECT_EQ(pieces(RayKind::camera), pieces(RayKind::noHit)) << "both are solid";
  EXPECT_GT(pieces(RayKind::reflected), pieces(RayKind::camera)) << "dashed";
  EXPECT_GT(pieces(RayKind::light), pieces(RayKind::reflected)) << "dotted";
  EXPECT_EQ(pieces(RayKind::light), pieces(RayKind::shadow));
}

TEST_F(Legend, HasTheNormalWhileAVertexIsPicked) {
  open("2-cylinder");
  EXPECT_EQ(entries().size(), 2u) << "from the eye, reflected";
  editor.point = PickedPoint{};
  const std::vector<Entry> shown = entries();
  ASSERT_EQ(shown.size(), 3u);
  EXPECT_EQ(shown[2].color, ink::of(normalLook.color));
}

}  // namespace
}  // namespace anamorph
