// What the script tests share: run a source and look at its global `result`, or at the error.
#pragma once

#include <gtest/gtest.h>

#include "engine/script/sandbox.h"

namespace brittle::script {

inline const Library& noLibrary() {
  static const Library library;
  return library;
}

inline Value resultOf(const std::string& source) {
  Sandbox sandbox(noLibrary());
  const Status status = sandbox.load(source, "t.lua");
  EXPECT_TRUE(status) << status.error().message;
  return sandbox.get("result");
}

inline double numberOf(const std::string& expression) {
  const Value value = resultOf("result = " + expression);
  EXPECT_TRUE(value.isNumber()) << expression;
  return value.number;
}

inline std::string textOf(const std::string& expression) {
  const Value value = resultOf("result = " + expression);
  EXPECT_TRUE(value.isText()) << expression;
  return value.text;
}

inline std::string errorOf(const std::string& source, Limits limits = {}) {
  Sandbox sandbox(noLibrary(), 0, limits);
  const Status status = sandbox.load(source, "t.lua");
  return status ? "no error" : status.error().message;
}

}  // namespace brittle::script
