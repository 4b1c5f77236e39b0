// The command line: `anamorph deform|match|render|check|levels`. Results go to stdout, messages to stderr.
#pragma once

namespace anamorph {

/// Runs what the arguments ask for. Returns the exit code: 0 ok, 1 a fault in the data, 2 a wrong command
/// line, 3 a fault in the program.
int runCommand(int argc, char** argv);

}  // namespace anamorph
