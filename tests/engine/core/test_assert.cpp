#include "engine/core/assert.h"

#include <gtest/gtest.h>

#include <string>

namespace brittle {
namespace {

std::string lastCondition;
void remember(const char* condition, const char*, int) {
  lastCondition = condition;
}

TEST(Assert, ABrokenContractReachesTheInstalledHandler) {
  const AssertHandler previous = setAssertHandler(remember);
  const int balls = -1;
  BR_ASSERT(balls >= -1);
  EXPECT_EQ(lastCondition, "");
  BR_ASSERT(balls >= 0);
  setAssertHandler(previous);
  EXPECT_EQ(lastCondition, "balls >= 0");
}

TEST(AssertDeathTest, ByDefaultItNamesTheConditionAndStops) {
  EXPECT_DEATH(BR_ASSERT(1 == 2), "assertion failed: 1 == 2");
}

}  // namespace
}  // namespace brittle
