// callgrind/shell.h - other programs, run for what they print.
#pragma once

#include <string>
#include <vector>

#include "engine/core/result.h"

namespace brittle::callgrind {

/// Runs a command and waits. What it printed, complaints included; an error with its last line if it ends badly.
Result<std::string> outputOf(const std::vector<std::string>& words);
/// Whether a program of that name is in PATH.
bool isThere(const std::string& program);
/// The number behind `name` in a text like {"name": 1.5, ...} or "name : 15"; an error if there is none.
Result<double> numberAfter(const std::string& text, const std::string& name);

}  // namespace brittle::callgrind
