#include "game/sim/slow_motion.h"

#include "engine/math/types.h"

namespace brittle::sim {

static_assert(rules::kSlowestShare * 1000 >= rules::kTickRate * kWholeTick, "World::step takes no less than 1/1000 s");

TimeStep passTime(Clock& clock, std::uint64_t ticks, bool isSlow) {
  TimeStep step;
  step.part = static_cast<std::int32_t>(clock.after(ticks) & (kWholeTick - 1));
  clock.share = isSlow ? maxOf(clock.share - rules::kSlowStep, rules::kSlowestShare)
                       : minOf(clock.share + rules::kSlowStep, kWholeTick);
  clock.lost += kWholeTick - clock.share;
  step.share = clock.share;
  return step;
}

}  // namespace brittle::sim
