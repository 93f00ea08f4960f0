// script/value.h - what passes between C++ and a script: nil, a boolean, a number or a string. Tables and functions
// stay inside. A struct of its own, since gcc 12 warns about std::variant holding a string wherever one is built in
// place.
#pragma once

#include <string>
#include <utility>

namespace brittle::script {

struct Value {
  enum class Kind { Nil, Boolean, Number, Text };

  Value() = default;
  Value(bool value) : kind(Kind::Boolean), number(value ? 1.0 : 0.0) {}
  Value(double value) : kind(Kind::Number), number(value) {}
  Value(float value) : kind(Kind::Number), number(static_cast<double>(value)) {}
  Value(int value) : kind(Kind::Number), number(value) {}
  Value(std::string value) : kind(Kind::Text), text(std::move(value)) {}
  Value(const char* value) : kind(Kind::Text), text(value) {}

  bool isNil() const { return kind == Kind::Nil; }
  bool isNumber() const { return kind == Kind::Number; }
  bool isText() const { return kind == Kind::Text; }
  friend bool operator==(const Value&, const Value&) = default;

  Kind kind = Kind::Nil;
  double number = 0.0;  // also 1 or 0 for a boolean
  std::string text;
};

}  // namespace brittle::script
