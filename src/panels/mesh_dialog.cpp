#include "panels/mesh_dialog.h"

#include <fmt/format.h>
#include <imgui.h>

#include "base/language.h"
#include "panels/dialog.h"
#include "panels/widgets.h"

namespace anamorph {

std::optional<MeshQuestion::Answer> drawMeshDialog(const MeshQuestion& question, const DialogKeys& typed,
                                                   const Look& look) {
  if (!beginDialog(look, "Where is the mesh?", 480)) return std::nullopt;
  paragraph(trFormat("The original of this level is the mesh \"{}\", which cannot be read here:",
                     question.mesh.filename().string()));
  quietText(look, question.mesh.c_str());
  quietText(look, "The stand-in is a pawn where the RT camera looks. Undo takes it back.");
  ImGui::Dummy({0, 6 * static_cast<float>(look.scale)});
  int pressed = dialogButtons({"Browse for it...", "Use a stand-in", "Cancel"});
  if (isEnterTyped(typed)) pressed = 0;
  if (isTyped(typed, 'S')) pressed = 1;
  if (isTyped(typed, keys::escape)) pressed = 2;
  if (pressed >= 0) ImGui::CloseCurrentPopup();
  endDialog();
  return pressed < 0 ? std::nullopt : std::optional(static_cast<MeshQuestion::Answer>(pressed));
}

}  // namespace anamorph
