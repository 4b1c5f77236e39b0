#include "viewport/outline_pass.h"

#include <gtest/gtest.h>

#include "optics/patch.h"

namespace anamorph {
namespace {

TEST(OutlinePass, GoesAroundTheMirrorOfWhichAPointIsSelected) {
  ViewportInput input;
  input.level.optic = {OpticKind::mirror, PatchMirror{}};
  Visible visible;
  for (const bool shown : {true, false}) {
    visible.mirror = shown ? "patch" : ShaderKinds::noMirror;
    for (const Selection& selection : {Selection{Part::mirror}, Selection{Part::controlPoint, 3}}) {
      input.selection = selection;
      EXPECT_EQ(OutlinePass::wanted(input, visible), shown) << int(selection.part);
    }
  }
}

}  // namespace
}  // namespace anamorph
