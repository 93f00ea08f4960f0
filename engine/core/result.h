// core/result.h - a value, or one clear line about what is wrong with the data it should have come from.
// For files, scripts, replays and command lines; a broken contract is an assertion instead.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "engine/core/assert.h"

namespace brittle {

/// What was wrong: "file:line: what, the value, what was expected" (file and line where they exist).
struct Error {
  std::string message;
};

/// An error at a place in a file; line 0 means the file as a whole.
inline Error errorAt(const std::string& file, int line, const std::string& what) {
  return {line > 0 ? file + ":" + std::to_string(line) + ": " + what : file + ": " + what};
}

/// Without line ends and other control characters: what was typed, or stands in a file, may hold some.
inline std::string asOneLine(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 32) c = ' ';
  return text;
}

template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : value_(std::move(value)) {}
  Result(Error error) : error_(std::move(error)) {}

  explicit operator bool() const { return value_.has_value(); }
  T& value() {
    BR_ASSERT(value_.has_value());
    return *value_;
  }
  const T& value() const {
    BR_ASSERT(value_.has_value());
    return *value_;
  }
  T& operator*() { return value(); }
  const T& operator*() const { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  const Error& error() const { return error_; }

 private:
  std::optional<T> value_;
  Error error_;
};

/// Success without a value.
struct Done {};
using Status = Result<Done>;

}  // namespace brittle
