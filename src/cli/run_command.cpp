#include "cli/run_command.h"

#include <exception>

#include <fmt/format.h>

#include "base/check.h"
#include "base/error.h"
#include "cli/commands.h"
#include "cli/usage_error.h"

namespace anamorph {
namespace {

enum ExitCode { ok = 0, dataFault = 1, wrongUsage = 2, programFault = 3 };

int parseAndRun(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
    return ok;
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);  // prints the help, the version, or what is wrong
    return code == 0 ? ok : wrongUsage;
  }
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
    return parseAndRun(app, argc, argv);
  } catch (const UsageError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return wrongUsage;
  } catch (const Error& error) {
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
