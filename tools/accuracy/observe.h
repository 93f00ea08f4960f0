// accuracy/observe.h - plays one variant of a scene and writes down all that the study asks of it: how far exact
// results were missed, what of momentum, energy and volume was lost, how deep bodies overlapped, and what each tick
// cost.
#pragma once

#include <cstdint>
#include <vector>

#include "tools/accuracy/scenes.h"

namespace brittle::accuracy {

/// One play. Ticks are of 1/60 s.
struct Observation {
  // Of the stage's analytics, in their order.
  std::vector<double> missedAtEnd, missedAtWorst;  // |value - exact|, in the analytic's unit
  std::vector<double> exactAtEnd;
  double turned = 0.0;         // the watched body's way, from -Z [deg]
  double push = 0.0;           // momentum of all other dynamic bodies along -Z at the end [N s]
  double broken = 0.0;         // assemblies that broke
  double breaks = 0.0;         // breakings
  double held = 0.0;           // breakings put off to the next tick
  double deepest = 0.0;        // overlap after the first break or second [mm]
  double overlap = 0.0;        // root mean square of the overlaps, too [mm]
  double momentumLost = 0.0;   // largest, of the first tick's momentum [-]; NaN where something is fixed
  double energyGained = 0.0;   // largest rise over the least so far, of the first tick's energy [-]; NaN with gravity
  double volumeLost = 0.0;     // of all there was [-]
  double crumbVolume = 0.0;    // of it that is debris at the end [-]
  double spoilt = 0.0;         // bodies removed because a number in them was not finite
  double escaped = 0.0;        // bodies more than 0.5 m below y = -1 with gravity
  std::vector<float> speeds;   // of all dynamic bodies but the watched one at the end [m/s]
  std::vector<double> tickMs;  // processor time of each tick [ms]
  std::uint64_t hash = 0;      // state at the end
};

/// Looks at the world after every tick.
Observation observe(const Scene& scene, const physics::Accuracy& accuracy, int variant);
/// The same of panes that are no variant of a scene.
Observation observePanes(const PanesDef& def, const physics::Accuracy& accuracy);

}  // namespace brittle::accuracy
