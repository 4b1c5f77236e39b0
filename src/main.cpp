// Chooses the command, prints an Error, returns the exit code; all else is in cli/.

#include "cli/run_command.h"

int main(int argc, char** argv) {
  return anamorph::runCommand(argc, argv);
}
