#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "engine/core/log.h"
#include "engine/core/profile.h"
#include "engine/core/result.h"

namespace brittle {
namespace {

TEST(Log, GoesToTheInstalledSink) {
  std::vector<std::string> lines;
  LogSink previous = setLogSink([&](LogLevel level, std::string_view text) {
    lines.push_back(std::to_string(static_cast<int>(level)) + ":" + std::string(text));
  });
  logInfo("a");
  logError("b");
  setLogSink(std::move(previous));
  EXPECT_EQ(lines, (std::vector<std::string>{"0:a", "2:b"}));
}

struct Recorder : ZoneListener {
  std::vector<std::string> calls;
  void zoneBegins(const char* name) override { calls.push_back(std::string("+") + name); }
  void zoneEnds(const char* name) override { calls.push_back(std::string("-") + name); }
};

TEST(Zones, NestAndTellTheListener) {
  Recorder recorder;
  ZoneListener* previous = setZoneListener(&recorder);
  {
    BR_ZONE("outer");
    BR_ZONE("inner");
  }
  setZoneListener(previous);
  EXPECT_EQ(recorder.calls, (std::vector<std::string>{"+outer", "+inner", "-inner", "-outer"}));
}

TEST(Result, HoldsAValueOrOneLine) {
  const Result<int> good = 3;
  const Result<int> bad = errorAt("a.xml", 12, "size 0, expected more");
  EXPECT_TRUE(static_cast<bool>(good));
  EXPECT_EQ(*good, 3);
  EXPECT_FALSE(static_cast<bool>(bad));
  EXPECT_EQ(bad.error().message, "a.xml:12: size 0, expected more");
  EXPECT_EQ(errorAt("a.xml", 0, "missing").message, "a.xml: missing");
}

}  // namespace
}  // namespace brittle
