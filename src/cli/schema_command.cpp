// anamorph schema: what a level file may hold, for editors and validators.

#include <string>

#include "base/file.h"
#include "cli/commands.h"
#include "cli/output.h"
#include "cli/print.h"
#include "level/level_json.h"

namespace anamorph {

void addSchemaCommand(CLI::App& app, CommonOptions& common) {
  CLI::App* command =
      app.add_subcommand("schema", "Print what a level file may hold, as a JSON Schema for editors");
  addCommonOptions(*command, common);
  command->callback([] { printText(stdout, formatLevelSchema()); });
}

}  // namespace anamorph
