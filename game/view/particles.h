// view/particles.h - light that comes and goes: sparks of breaking glass, dust in the air, labels over won crystals.
// Each is a function of the moment and of remembered events alone: no state of its own, so nothing depends on which
// pictures were drawn before.
#pragma once

#include "game/view/memory.h"

namespace brittle::view {

/// `tick` is the moment seen. Adds glows, and texts for which `aspect` is the picture's width over its height.
void addParticles(const sim::FramePacket& packet, const Memory& memory, double tick, float aspect,
                  render::Frame& frame);

}  // namespace brittle::view
