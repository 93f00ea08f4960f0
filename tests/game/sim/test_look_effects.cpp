// Effects that are only seen: which a room calls for, and who asked.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fixture.h"

namespace brittle::sim {
namespace {

using effects::Effect;

constexpr Effect kSeen[] = {Effect::Bloom, Effect::Mirror, Effect::Shadows, Effect::Decals, Effect::Air};
const std::string kPlainRoom = "mgSegment('test/plain', 0) mgLength(160)";

content::MemorySource roomOf(const std::string& attributes, const std::string& elements,
                             const std::string& calls = "") {
  content::MemorySource source = oneRoom("", 160.0f, kPlainRoom + calls);
  source.add("segments/test/plain.xml", "<segment size=\"12 10 32\" " + attributes +
                                            "><box pos=\"0 -1.2 -16\" size=\"4 .2 16\"/>" + elements + "</segment>");
  return source;
}

std::vector<std::string> whoAskedFor(Effect effect, const content::MemorySource& source) {
  std::vector<std::string> who;
  const std::unique_ptr<Game> game = newTestGame(source);
  for (const effects::Demand& demand : game->effects().demands())
    if (demand.effect == effect) who.push_back(demand.who);
  return who;
}

TEST(LookEffects, ARoomThatAsksForNoneHasNone) {
  const content::MemorySource source = roomOf("softshadow=\"0\"", "");
  for (const Effect effect : kSeen) EXPECT_FALSE(newTestGame(source)->effects().has(effect)) << nameOf(effect);
}

TEST(LookEffects, EachIsDemandedByTheLineThatAsksFirst) {
  const std::string box = "<box pos=\"0 2 -16\" size=\"1 1 1\" visible=\"1\" ", file = "segments/test/plain.xml:1";
  const auto asked = [&](Effect effect, const std::string& attributes, const std::string& elements) {
    return whoAskedFor(effect, roomOf(attributes, elements));
  };
  using ::testing::ElementsAre;
  EXPECT_THAT(asked(Effect::Bloom, "softshadow=\"0\"", box + "glow=\"1\"/>"), ElementsAre(file));
  EXPECT_THAT(asked(Effect::Mirror, "softshadow=\"0\"", box + "reflection=\"1\"/>" + box + "reflection=\"1\"/>"),
              ElementsAre(file))
      << "once, however many boxes ask";
  EXPECT_THAT(asked(Effect::Shadows, "softshadow=\"0.4\"", ""), ElementsAre(file));
  EXPECT_THAT(asked(Effect::Decals, "softshadow=\"0\"", "<decal pos=\"0 1 -3\" size=\"1 1\" tile=\"3\"/>"),
              ElementsAre(file));
  EXPECT_THAT(whoAskedFor(Effect::Air, roomOf("softshadow=\"0\"", "", " mgParticles('starfield')")),
              ElementsAre(::testing::StartsWith("rooms/test/room.lua:1")));
}

}  // namespace
}  // namespace brittle::sim
