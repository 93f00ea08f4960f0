// physics/debris.h - light debris: points with a radius that fall and collide with planes of static geometry only. The
// oldest are recycled; volume is accounted for.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/archive.h"
#include "engine/math/types.h"

namespace brittle::physics {

struct Crumb {
  Vec3 position = Vec3::Zero();  // [m]
  Vec3 velocity = Vec3::Zero();  // [m/s]
  float radius = 0.0f;           // [m]
  float volume = 0.0f;           // [m3]
  std::uint32_t color = 0xffffffff;
  std::int32_t bornTick = 0;
  bool resting = false;

  template <class Archive>
  void serialize(Archive& a) {
    a(position);
    a(velocity);
    a(radius);
    a(volume);
    a(color);
    a(bornTick);
    a(resting);
  }
};

struct Debris {
  std::vector<Crumb> crumbs;  // ring: the oldest is at `oldest` once full
  std::uint32_t oldest = 0;
  std::uint64_t recycled = 0;   // crumbs overwritten since the start
  double recycledVolume = 0.0;  // of those, and of those removed [m3]

  template <class Archive>
  void serialize(Archive& a) {
    a.vector(crumbs);
    a(oldest);
    a(recycled);
    a(recycledVolume);
  }
};

}  // namespace brittle::physics
