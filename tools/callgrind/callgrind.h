// callgrind/callgrind.h - counts the instructions of another program's function: the same number on every run,
// however busy the machine is.
#pragma once

#include <string>
#include <vector>

#include "engine/core/result.h"

namespace brittle::callgrind {

/// Whether it can be counted: one line that names the package if not.
Status checkCounting();
/// Runs a command under valgrind's callgrind, some fifty times as slow as by itself. Instructions of all calls of
/// `function`, named as callgrind writes it ("a::b(float)", `*` for anything), and of what it calls.
Result<double> instructionsOf(const std::string& function, const std::vector<std::string>& words);

}  // namespace brittle::callgrind
