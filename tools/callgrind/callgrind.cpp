#include "tools/callgrind/callgrind.h"

#include "tools/callgrind/shell.h"

namespace brittle::callgrind {

Status checkCounting() {
  if (!isThere("valgrind")) return Error{"valgrind is missing: apt-get install valgrind"};
  return Done{};
}

Result<double> instructionsOf(const std::string& function, const std::vector<std::string>& words) {
  if (const Status there = checkCounting(); !there) return there.error();
  std::vector<std::string> command = {"valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null",
                                      "--toggle-collect=" + function};
  command.insert(command.end(), words.begin(), words.end());
  const Result<std::string> counted = outputOf(command);
  if (!counted) return counted.error();
  return numberAfter(*counted, "Collected :");
}

}  // namespace brittle::callgrind
