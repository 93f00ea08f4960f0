// view/water.h - water as it is seen: a gentle swell, rings from what fell in, foam, drops thrown up. Each is a
// function of the moment and of remembered splashes alone: no state of its own, so any picture is the same alone as in
// a full run.
//
// A splash makes two groups of waves, one twice as long as the other. Both obey the dispersion of deep water, w^2 = g
// k: crests run with w / k, the group itself at half of that, so crests are born at its back and vanish at its front.
// Source: Lamb, Hydrodynamics, 1932, art. 236 to 240.
#pragma once

#include <vector>

#include "game/view/memory.h"
#include "game/view/omission.h"

namespace brittle::view {

/// Of deep-water waves of this length [m], in m/s.
float crestSpeed(float wavelength);
inline float groupSpeed(float wavelength) {
  return 0.5f * crestSpeed(wavelength);
}

/// A group of waves of one length [m] about the place that it began at, `age` [s] ago, as a share of its first height.
float groupHeight(float distance, float age, float wavelength);

/// Something that fell in.
struct Splash {
  Vec2 place = Vec2::Zero();  // x and z, in the packet's frame [m]
  float age = 0.0f;           // [s]
  float size = 0.2f;          // of what fell in [m]
  float speed = 5.0f;         // with which [m/s]

  float wavelength() const;  // of its shorter waves [m]
  float amplitude() const;   // of those as they begin [m]
};

/// How high a splash's waves stand this far from its middle; gone after kMemoryTicks. [m]
float ringHeight(const Splash& splash, float distance);
/// How white it is there. [0, 1]
float splashFoam(const Splash& splash, float distance);
/// The swell: at x and `along` the whole way [m], after `seconds`. At most kSwellHeight. [m]
float swellHeight(float x, double along, double seconds);
inline constexpr float kSwellHeight = 0.022f;

/// `tick` is the moment seen. Adds the waters of the rooms that have some before the camera, farthest first, and the
/// drops of fresh splashes.
void addWaters(const sim::FramePacket& packet, const Memory& memory, double tick, Bounds& bounds, render::Frame& frame);

}  // namespace brittle::view
