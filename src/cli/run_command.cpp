#include "cli/run_command.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "base/check.h"
#include "base/error.h"
#include "cli/commands.h"
#include "cli/usage_error.h"

namespace anamorph {
namespace {

enum ExitCode { ok = 0, dataFault = 1, wrongUsage = 2, programFault = 3 };

// CLI11 only says that a command is missing; a mistyped one is named here.
void checkCommandName(const CLI::App& app, int argc, char** argv) {
  std::string known;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (argc > 1 && command->get_name() == argv[1]) return;
    known += (known.empty() ? "" : ", ") + command->get_name();
  }
  if (argc > 1 && argv[1][0] == '-') return;
  const std::string got = argc > 1 ? ", got " + std::string(argv[1]) : "";
  throw UsageError("expected a command (" + known + ")" + got + "; anamorph -h explains them");
}

int parseAndRun(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // the help or the version was asked for
    fmt::print(stderr, "{} (the option -h explains)\n", error.what());
    return wrongUsage;
  }
  flushResults();
  return ok;
}

}  // namespace

int runCommand(int argc, char** argv) {
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
  try {
    checkCommandName(app, argc, argv);
    return parseAndRun(app, argc, argv);
  } catch (const UsageError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return wrongUsage;
  } catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return dataFault;
  } catch (const std::system_error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return dataFault;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "not enough memory for this\n");
    return dataFault;
  } catch (const std::exception& error) {
    fmt::print(stderr, "a fault in the program, please report it: {}\n", error.what());
    return programFault;
  }
}

}  // namespace anamorph
