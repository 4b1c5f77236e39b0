// Chooses the command, prints an Error, returns the exit code; all else is in cli/ and app/.

#include "base/temporary_file.h"
#include "cli/run_command.h"

#ifdef ANAMORPH_GUI
#include "app/commands.h"
#endif

int main(int argc, char** argv) {
  anamorph::removeTemporariesOnSignals();
#ifdef ANAMORPH_GUI
  return anamorph::runCommand(argc, argv, anamorph::windowCommands());
#else
  return anamorph::runCommand(argc, argv);
#endif
}
