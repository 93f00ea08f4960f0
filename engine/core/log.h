// core/log.h - one line per message to a replaceable sink (default: standard error). Who logs does not know who reads.
#pragma once

#include <functional>
#include <string_view>

namespace brittle {

enum class LogLevel { Info, Warning, Error };

using LogSink = std::function<void(LogLevel, std::string_view)>;

/// Replaces the sink; an empty one restores the default. Returns the sink it replaced.
LogSink setLogSink(LogSink sink);
void log(LogLevel level, std::string_view message);
inline void logInfo(std::string_view message) {
  log(LogLevel::Info, message);
}
inline void logWarning(std::string_view message) {
  log(LogLevel::Warning, message);
}
inline void logError(std::string_view message) {
  log(LogLevel::Error, message);
}

}  // namespace brittle
