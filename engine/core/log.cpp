#include "engine/core/log.h"

#include <cstdio>
#include <utility>

namespace brittle {
namespace {

void printToStandardError(LogLevel level, std::string_view message) {
  const char* prefix = level == LogLevel::Error ? "error: " : level == LogLevel::Warning ? "warning: " : "";
  std::fprintf(stderr, "%s%.*s\n", prefix, static_cast<int>(message.size()), message.data());
}

LogSink& sink() {
  static LogSink current = printToStandardError;
  return current;
}

}  // namespace

LogSink setLogSink(LogSink replacement) {
  if (!replacement) replacement = printToStandardError;
  return std::exchange(sink(), std::move(replacement));
}

void log(LogLevel level, std::string_view message) {
  sink()(level, message);
}

}  // namespace brittle
