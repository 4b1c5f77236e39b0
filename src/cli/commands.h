// One function a command: it adds itself to the command line, with its options and what it does when it is
// chosen.
#pragma once

#include "cli/common_options.h"

namespace anamorph {

void addDeformCommand(CLI::App& app, CommonOptions& common);
void addMatchCommand(CLI::App& app, CommonOptions& common);
void addRenderCommand(CLI::App& app, CommonOptions& common);
void addExportCommand(CLI::App& app, CommonOptions& common);
void addCheckCommand(CLI::App& app, CommonOptions& common);
void addLevelsCommand(CLI::App& app, CommonOptions& common);
void addSchemaCommand(CLI::App& app, CommonOptions& common);

}  // namespace anamorph
