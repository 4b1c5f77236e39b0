// The command line: `anamorph deform|match|render|check|levels|schema|export`, and what the window adds. Results go to
// stdout, messages to stderr.
#pragma once

#include <string>
#include <vector>

#include "cli/common_options.h"

namespace anamorph {

/// Commands of rooms that this one does not know.
struct MoreCommands {
  std::vector<void (*)(CLI::App&, CommonOptions&)> add;
  std::string otherwise;  ///< the command that is meant when only a level is named, or nothing; empty: none
};

/// Runs what the arguments ask for. Returns the exit code: 0 ok, 1 a fault in the data, 2 a wrong command
/// line, 3 a fault in the program.
int runCommand(int argc, char** argv, const MoreCommands& more = {});

}  // namespace anamorph
