// content/problem.h - one thing that is wrong with a file of a level: where, what, the value found and the value
// expected. Readers collect problems and go on; nobody throws a level away because of one.
#pragma once

#include "engine/core/result.h"

#include <string>
#include <vector>

namespace brittle::content {

struct Problem {
  std::string file;
  int line = 0;  // 0: the file as a whole
  std::string what;
  std::string value;     // as written; may be empty
  std::string expected;  // may be empty

  /// One line: "file:line: what, got 'value', expected ...".
  std::string text() const {
    std::string message = errorAt(file, line, what).message;
    if (!value.empty()) message += ", got '" + value.substr(0, 80) + "'";
    if (!expected.empty()) message += ", expected " + expected;
    return asOneLine(message);
  }
};

using Problems = std::vector<Problem>;

}  // namespace brittle::content
