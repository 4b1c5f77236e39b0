#include "panels/notice_dialog.h"

#include <imgui.h>

#include "panels/dialog.h"
#include "panels/widgets.h"

namespace anamorph {

void drawNotice(std::optional<Notice>& notice, const DialogKeys& typed, const Look& look) {
  if (!beginDialog(look, notice->title.c_str(), 460)) return;
  paragraph(notice->text);
  ImGui::Dummy({0, 6 * static_cast<float>(look.scale)});
  const bool done = dialogButtons({"OK"}) == 0 || isEnterTyped(typed) || isTyped(typed, keys::escape);
  if (done) ImGui::CloseCurrentPopup();
  endDialog();
  if (done) notice.reset();
}

}  // namespace anamorph
