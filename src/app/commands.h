// The commands that need OpenGL: open (the window), screenshot, bench-drag.
#pragma once

#include "cli/run_command.h"

namespace anamorph {

/// For main: all three, and that naming a level opens the window.
MoreCommands windowCommands();

void addOpenCommand(CLI::App& app, CommonOptions& common);
void addScreenshotCommand(CLI::App& app, CommonOptions& common);
void addBenchDragCommand(CLI::App& app, CommonOptions& common);

}  // namespace anamorph
