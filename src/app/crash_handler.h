// A program that ends badly (a failed assertion of a library, a fault of the graphics driver) or is ended from outside (a
// log-out, Ctrl+C in the terminal) writes the newest unsaved level first. Its bytes are made beforehand (unsaved_bytes.h): a signal handler may do hardly more than open, write and
// rename. Whatever would have happened without it happens then.
#pragma once

namespace anamorph {

/// From now on for SIGABRT, SIGSEGV, SIGFPE, SIGBUS and SIGILL, and for SIGTERM, SIGHUP and SIGINT where these are not
/// ignored; on a stack of its own for the thread that calls it.
void installCrashHandler();

/// Writes the newest unsaved level into its file, in one step. Neither allocates nor waits; without one, or when it
/// cannot, nothing happens.
void writeUnsaved() noexcept;

}  // namespace anamorph
