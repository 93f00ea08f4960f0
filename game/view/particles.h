// view/particles.h - what breaking and hitting throw into the air: sparkle, splinters, puffs of dust. Each is a
// function of the moment and of remembered events alone: no state of its own, so nothing depends on which pictures were
// drawn before.
#pragma once

#include "game/view/memory.h"
#include "game/view/omission.h"

namespace brittle::view {

/// `tick` is the moment seen, `time` the game's own: in slow motion what flies is slower too. Adds glows and beams.
void addParticles(const sim::FramePacket& packet, const Memory& memory, double tick, double time, Bounds& bounds,
                  render::Frame& frame);

}  // namespace brittle::view
