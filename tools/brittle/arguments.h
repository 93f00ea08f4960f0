// brittle/arguments.h - reads a program's command line, and says in one line what is wrong with it: the same way in
// every program.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdio>
#include <optional>
#include <string>

#include "engine/core/result.h"
#include "tools/brittle/options.h"

namespace brittle::program {

/// Prints "NAME: message" to standard error, as one line; the exit status.
inline int refuse(const std::string& name, const Error& error) {
  std::fprintf(stderr, "%s\n", asOneLine(name + ": " + error.message).c_str());
  return kWrongInput;
}

/// Fills what `app` binds to its options. The status to leave with, if there is nothing more to do: help was asked for,
/// or the line is wrong. `app` has a name.
inline std::optional<int> readArguments(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& problem) {
    const bool hasCommands = !app.get_subcommands([](const CLI::App*) { return true; }).empty();
    const std::string& name = app.get_name();
    return refuse(name, {std::string(problem.what()) + " (" + name + " --help" +
                         (hasCommands ? ", " + name + " COMMAND --help)" : ")")});
  }
  return std::nullopt;
}

}  // namespace brittle::program
