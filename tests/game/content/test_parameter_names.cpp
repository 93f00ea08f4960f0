#include "game/content/parameter_names.h"

#include <gmock/gmock.h>

namespace brittle::content {
namespace {

using testing::ElementsAre;

TEST(ParameterNames, AreThoseOfEveryCallThatAsks) {
  const ParameterNames found = parameterNames(
      "-- mgGetInt(\"comment\")\nlocal w = mgGetFloat(\"width\", 2) local c = {mgGetColor('color', 1, 1, 1)}\n"
      "function tick() if mgGetBool(\"late\") then mgGetString \"bare\" mgGetInt( \"width\" ) mgGet(\"global\") end "
      "end");
  EXPECT_THAT(found.names, ElementsAre("width", "color", "late", "bare"));
  EXPECT_FALSE(found.isOpen);
}

TEST(ParameterNames, OneThatIsPutTogetherMayBeAny) {
  for (const char* source : {"mgGetFloat('size' .. axis, 1)", "mgGetFloat(name)", "local get = mgGetFloat get('x')",
                             "mgGetFloat('a\\65')", "mgGetFloat([[x]])", "mgGetFloat('unfinished"}) {
    EXPECT_TRUE(parameterNames(source).isOpen) << source;
    EXPECT_EQ(expectedFor("anything", parameterNames(source), false), "") << source;
  }
}

TEST(ParameterNames, ExpectedIsTheNearestOrAll) {
  const ParameterNames asked = {{"speed", "width"}, false};
  EXPECT_EQ(expectedFor("speed", asked, false), "");
  EXPECT_EQ(expectedFor("sped", asked, true), "speed");
  EXPECT_EQ(expectedFor("colour", asked, false), "one of speed, width");
  EXPECT_EQ(expectedFor("colour", asked, true), "");
  EXPECT_EQ(expectedFor("colour", {}, false), "none");
}

}  // namespace
}  // namespace brittle::content
