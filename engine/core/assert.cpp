#include "engine/core/assert.h"

#include <cstdio>
#include <cstdlib>

namespace brittle {
namespace {

void printAndAbort(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: assertion failed: %s\n", file, line, condition);
  std::abort();
}

AssertHandler handler = printAndAbort;

}  // namespace

AssertHandler setAssertHandler(AssertHandler replacement) {
  const AssertHandler previous = handler;
  handler = replacement != nullptr ? replacement : printAndAbort;
  return previous;
}

void assertFailed(const char* condition, const char* file, int line) {
  handler(condition, file, line);
}

}  // namespace brittle
