// view/surroundings.h - what mirrors and glass show of the room about the camera: its sides, their colours, its lamps.
// Pure.
#pragma once

#include <optional>

#include "engine/render/frame.h"
#include "game/sim/frame_packet.h"
#include "game/view/omission.h"

namespace brittle::view {

/// From the segments about and ahead of the packet's camera, each counted by how much of the way ahead it holds, so
/// that nothing jumps as the camera flies on.
render::Surroundings surroundingsOf(const sim::FramePacket& packet, Bounds& bounds);

/// How dark soft shadows are, as the segments about the camera have it. [0, 1]
float shadowStrengthOf(const sim::FramePacket& packet);

/// The height of the polished floor about and ahead of the camera, the largest if there are several. [m]
std::optional<float> mirrorHeightOf(const sim::FramePacket& packet);

}  // namespace brittle::view
