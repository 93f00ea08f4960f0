// game/sim/unseen.h - what nobody can see any more, nor will: beside or below the widest picture that any window can
// show, and not on its way into it. The camera only moves on along -Z, so what keeps its place outside of the picture
// stays outside.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/math/types.h"
#include "engine/physics/ids.h"

namespace brittle::sim {

/// All that pictures of any shape show from a place.
struct WidestView {
  Vec3 eye = Vec3::Zero();           // [m]
  float aside = 0.0f, below = 0.0f;  // tangents of the angles from straight ahead
  bool fallsDown = true;             // the room's gravity does not lift
};

/// `rolls`: the room turns about the way.
WidestView widestView(const Vec3& eye, bool rolls, float gravity);

/// Something that moves, or does not.
struct Mover {
  Vec3 center = Vec3::Zero();    // [m]
  Vec3 velocity = Vec3::Zero();  // [m/s]
  float radius = 0.0f;           // [m]
  bool rests = false;            // nothing but a touch moves it
};

/// Wholly outside of the view and not moving nearer to it. What is above it is not: it may fall into it.
bool isLeaving(const WidestView& view, const Mover& mover);

/// How long a piece has been out of sight.
struct Unseen {
  physics::BodyHandle body;
  std::uint32_t ticks = 0;

  template <class Archive>
  void serialize(Archive& a) {
    a(body);
    a(ticks);
  }
};

/// The present list from the last one: `bodies` of now, both in slot order. `ticks` passed since.
void goOn(std::span<const physics::BodyHandle> bodies, std::uint32_t ticks, std::vector<Unseen>& unseen);

}  // namespace brittle::sim
