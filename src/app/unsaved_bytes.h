// The newest unsaved level as bytes, and the file that they belong into, for a program that is about to end: whoever
// handles its last signal may neither allocate nor wait. Autosave puts them here after every change, long before it
// writes them; a program that ends badly takes them and writes them (crash_handler.h):
//
//   autosave:   putUnsaved(made)    putUnsaved(made)    putUnsaved(nullptr): all is saved
//   a crash:                         takeUnsaved(): nobody else has or frees what it gives
//
// `file` is a recovery file whose lock goes with the process, so the next start offers it (recovery_files.h).
#pragma once

#include <memory>
#include <string>

namespace anamorph {

struct UnsavedBytes {
  std::string file;   ///< absolute path of the recovery file; its folder is there
  std::string bytes;  ///< all that it is to hold
};

/// In place of those before; null: nothing is unsaved. From any thread.
void putUnsaved(std::unique_ptr<const UnsavedBytes> unsaved);

/// The bytes put last, which are the caller's from now on: nobody frees them. Null when there are none, or they were
/// taken. Neither allocates nor waits: for signal handlers.
const UnsavedBytes* takeUnsaved() noexcept;

}  // namespace anamorph
