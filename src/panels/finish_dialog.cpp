#include "panels/finish_dialog.h"

#include <imgui.h>

#include "base/language.h"
#include "panels/dialog.h"
#include "panels/widgets.h"

namespace anamorph {

void drawFinishDialog(std::optional<FinishQuestion>& question, const std::vector<std::string>& files,
                      double fraction, const DialogKeys& typed, const Look& look) {
  using Answer = FinishQuestion::Answer;
  if (!beginDialog(look, "A file is being written", 480)) return;
  const bool waits = question->answer == Answer::wait;
  paragraph(tr(waits ? "Anamorph ends as soon as it is written:" : "Ending now would leave it unwritten:"));
  for (const std::string& file : files) quietText(look, file.c_str());
  if (waits) ImGui::ProgressBar(static_cast<float>(fraction), {-FLT_MIN, 0});
  ImGui::Dummy({0, 6 * static_cast<float>(look.scale)});
  const int pressed = dialogButtons({"Wait and quit", "Stop and quit", "Cancel"}, {!waits});
  if (isEnterTyped(typed) || pressed == 0) question->answer = Answer::wait;
  const bool stops = isTyped(typed, 'S') || pressed == 1;
  if (stops) question->answer = Answer::stop;
  const bool cancelled = isTyped(typed, keys::escape) || pressed == 2;
  if (cancelled || stops) ImGui::CloseCurrentPopup();
  endDialog();
  if (cancelled) question.reset();
}

}  // namespace anamorph
