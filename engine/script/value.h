// script/value.h - what passes between C++ and a script: nil, a boolean, a number or a string. Tables and functions stay inside.
#pragma once

#include <string>
#include <variant>

namespace brittle::script {

struct Nil {
  friend bool operator==(const Nil&, const Nil&) = default;
};

using Value = std::variant<Nil, bool, double, std::string>;

}  // namespace brittle::script
