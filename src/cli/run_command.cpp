#include "cli/run_command.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/check.h"
#include "base/error.h"
#include "cli/commands.h"
#include "cli/print.h"
#include "cli/usage_error.h"
#include "level/level_library.h"

namespace anamorph {
namespace {

enum ExitCode { ok = 0, dataFault = 1, wrongUsage = 2, programFault = 3 };

using Arguments = std::vector<std::string>;

bool isCommand(const CLI::App& app, const std::string& name) {
  const auto commands = app.get_subcommands({});
  return std::any_of(commands.begin(), commands.end(),
                     [&](const CLI::App* command) { return command->get_name() == name; });
}

bool isGeneralOption(const std::string& name) {
  return name == "-h" || name == "--help" || name == "--version";
}

bool isLevel(const std::string& name) {
  try {
    findLevel(name);
    return true;
  } catch (const Error&) {
    return false;
  }
}

// `anamorph 1-plane` and `anamorph --fullscreen` mean the command that is meant otherwise.
void completeCommand(const CLI::App& app, const std::string& otherwise, Arguments& arguments) {
  if (otherwise.empty()) return;
  if (!arguments.empty()) {
    const std::string& first = arguments.front();
    if (isCommand(app, first) || isGeneralOption(first)) return;
    if (!first.starts_with("-") && !isLevel(first)) return;
  }
  arguments.insert(arguments.begin(), otherwise);
}

// CLI11 only says that a command is missing; a mistyped one is named here.
void checkCommandName(const CLI::App& app, const Arguments& arguments) {
  if (!arguments.empty() && (isCommand(app, arguments.front()) || arguments.front().starts_with("-"))) return;
  std::string known;
  for (const CLI::App* command : app.get_subcommands({})) {
    known += (known.empty() ? "" : ", ") + command->get_name();
  }
  const std::string got = arguments.empty() ? "" : ", got " + arguments.front();
  throw UsageError("expected a command (" + known + ")" + got + "; anamorph -h explains them");
}

int parseAndRun(CLI::App& app, Arguments arguments) {
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants them
  try {
    app.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // the help or the version was asked for
    printLine(stderr, error.what() + std::string(" (the option -h explains)"));
    return wrongUsage;
  }
  flushResults();
  return ok;
}

}  // namespace

int runCommand(int argc, char** argv, const MoreCommands& more) {
  CLI::App app("Anamorph: sculptures whose reflection in a mirror looks like an ordinary object.",
               "anamorph");
  app.set_version_flag("--version", "anamorph " ANAMORPH_VERSION);
  app.require_subcommand(1);
  CommonOptions common;
  addDeformCommand(app, common);
  addMatchCommand(app, common);
  addRenderCommand(app, common);
  addCheckCommand(app, common);
  addLevelsCommand(app, common);
  addSchemaCommand(app, common);
  addExportCommand(app, common);
  for (const auto add : more.add) add(app, common);
  try {
    Arguments arguments(argv + std::min(argc, 1), argv + argc);
    completeCommand(app, more.otherwise, arguments);
    checkCommandName(app, arguments);
    return parseAndRun(app, std::move(arguments));
  } catch (const UsageError& error) {
    printLine(stderr, error.what());
    return wrongUsage;
  } catch (const Error& error) {
    printError(error);
    return dataFault;
  } catch (const std::system_error& error) {
    const bool noThread = error.code() == std::errc::resource_unavailable_try_again;
    printLine(stderr, noThread ? "not enough memory for this: no thread can be started" : error.what());
    return dataFault;
  } catch (const std::bad_alloc&) {
    printLine(stderr, "not enough memory for this");
    return dataFault;
  } catch (const std::exception& error) {
    printLine(stderr, std::string("a fault in the program, please report it: ") + error.what());
    return programFault;
  }
}

}  // namespace anamorph
