// Mesa's software renderer compiles a shader in the first draw that uses it, and that is no piece of work: it holds a
// frame up for most of a second. So before the 3D view is drawn by programs that are new, a thread draws a tiny picture
// by them, in a context of its own. What it compiles goes into Mesa's cache on the disk, and from there the view has it
// in no time, at the next start, too.
//
//   frame:   ready(cylinder)? no: the panels only ... no ... no ... yes: the view
//   thread:  [tiny picture of a cylinder, compiles]---------^
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>

#include "pipeline/worker.h"
#include "viewport/scene_block.h"

namespace anamorph {

class ShaderWarmer {
 public:
  /// `wake` is called from the thread when it is done.
  explicit ShaderWarmer(std::function<void()> wake) : worker_(std::move(wake)) {}

  /// Whether what draws this input is compiled, as far as that could be done; begins with it when not.
  bool ready(const ViewportInput& input);

 private:
  std::set<ShaderKinds> warm_;
  std::optional<ShaderKinds> warming_;
  std::shared_ptr<Mailbox<ShaderKinds>> done_ = std::make_shared<Mailbox<ShaderKinds>>();
  Worker worker_;  // last: its jobs use the mailbox
};

}  // namespace anamorph
