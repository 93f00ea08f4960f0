#include "game/content/number.h"

#include "engine/core/random.h"

#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>

namespace brittle::content {
namespace {

TEST(Number, ReadsWhatPeopleWrite) {
  EXPECT_EQ(parseNumber(".25"), 0.25);
  EXPECT_EQ(parseNumber("-.3"), -0.3);
  EXPECT_EQ(parseNumber("5."), 5.0);
  EXPECT_EQ(parseNumber("+1.5e2"), 150.0);
  EXPECT_EQ(parseNumber("  12\t"), 12.0);
  EXPECT_EQ(parseNumber("1e-3"), 0.001);
}

TEST(Number, RefusesWhatIsNone) {
  for (const char* text :
       {"", " ", ".", "-", "1,5x", "1e", "1e+", "0x10", "nan", "inf", "1 2", "--1", "1.2.3", "e5", "1-2"})
    EXPECT_FALSE(parseNumber(text)) << text;
}

TEST(Number, IsExactForEveryFloatInShortNotation) {
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const double size = static_cast<double>(random.nextFloat(-1000.0f, 1000.0f));
    char text[64];
    std::snprintf(text, sizeof(text), i % 2 == 0 ? "%.6f" : "%.9g", size);
    EXPECT_EQ(parseNumber(text), std::strtod(text, nullptr)) << text;
  }
}

TEST(Number, HugeExponentsEnd) {
  EXPECT_EQ(parseNumber("1e-999999999999"), 0.0);
  EXPECT_GT(*parseNumber("1e99999999999"), 1e300);
  EXPECT_EQ(parseNumber("0e99999999999"), 0.0);
  EXPECT_NEAR(*parseNumber("123456789012345678901234567890"), 1.2345678901234568e29, 1e15);
  EXPECT_NEAR(*parseNumber("0." + std::string(400, '0') + "1"), 0.0, 1e-300);
}

TEST(Number, ListsTakeAnyBlanks) {
  EXPECT_EQ(parseNumbers(" 1  2\t3\n"), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(parseNumbers("1, 2,3"), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(parseNumbers(""), std::vector<double>{});
  EXPECT_FALSE(parseNumbers("1 2 x"));
}

TEST(Number, TruthsTakeAnyCase) {
  EXPECT_EQ(parseTruth("1"), true);
  EXPECT_EQ(parseTruth(" False "), false);
  EXPECT_FALSE(parseTruth("2"));
  EXPECT_FALSE(parseTruth(""));
}

}  // namespace
}  // namespace brittle::content
