// Power-ups whose effect this program may be built without.
#include <gtest/gtest.h>

#include "engine/effects/effect.h"
#include "tests/game/sim/power_up_games.h"

namespace brittle::sim {
namespace {

// With the module it is there to collect; without it that is said with its place, and the room plays.
TEST(PowerUpModules, OneIsThereOrReported) {
  for (const PowerUp kind : {PowerUp::BallFrenzy, PowerUp::SlowMotion, PowerUp::NitroBalls, PowerUp::Barrel}) {
    const auto effect = effectOf(kind);
    const bool isBuilt = !effect || effects::isBuilt(*effect);
    const content::MemorySource source = oneRoom("\n" + pickupAt(nameOf(kind)));
    const auto game = newTestGame(source);
    EXPECT_EQ(game->problems().empty(), isBuilt) << nameOf(kind);
    if (!isBuilt) {
      EXPECT_EQ(game->problems()[0].text, std::string("segments/test/corridor.xml:2: power-up ") + nameOf(kind) +
                                              ": this program is built without its effect, " +
                                              effects::nameOf(*effect));
    }
    EXPECT_EQ(collect(*game), isBuilt) << nameOf(kind);
    play(*game, 200);
  }
}

}  // namespace
}  // namespace brittle::sim
