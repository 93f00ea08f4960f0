// accuracy/study.h - plays every scene at every setting, in rounds that all settings take in turn: what else the
// machine does hits all of them alike. A play shows the errors and the time at once; where everything bursts each round
// has seeds of its own, as a burst that goes otherwise takes up to half as long again.
#pragma once

#include <functional>
#include <vector>

#include "tools/accuracy/figures.h"
#include "tools/accuracy/knobs.h"
#include "tools/accuracy/room.h"

namespace brittle::accuracy {

/// How much is played.
struct Effort {
  bool quick = false;
  /// Of a scene, shared out among the rounds; where there are fewer than rounds, they are played again.
  int variants(const Scene& scene) const;
  int rounds() const { return quick ? 1 : 4; }
  int roomTicks() const { return quick ? 200 : 900; }
};

/// Processor time: per simulated second, mean of the rounds, with the least and the most; of single ticks.
struct Cost {
  double perSecond = 0.0, low = 0.0, high = 0.0;  // [ms/s], mean of the scenes
  std::vector<double> rounds;                     // of each round, mean of the scenes [ms/s]
  double medianTick = 0.0, p99Tick = 0.0;         // over the ticks of all scenes [ms]
  double instructions = 0.0;                      // per simulated second of one scene [1/s]; 0: not counted
  std::vector<double> scenes;                     // per simulated second of each scene, mean of the rounds [ms/s]
  double roomMedian = 0.0, roomP99 = 0.0;         // of whole ticks of the game in the room [ms]
  double roomBreaks = 0.0;
};

struct Scored {
  Setting setting;
  std::vector<Deviation> errors;  // as allFigures
  Deviation score;
  Cost cost;
  bool isFront = false;   // no other setting is both cheaper and better
  bool isBeaten = false;  // another is cheaper in every round, and better by more than the seeds explain
};

/// A step of the work is done.
using Advance = std::function<void()>;

using Reference = std::vector<std::vector<Observation>>;  // of all scenes
Reference playAll(const physics::Accuracy& accuracy, const Effort& effort, const Advance& advance);

Result<std::vector<Scored>> study(const std::vector<Setting>& settings, const Reference& reference, const Room& room,
                                  const Effort& effort, const Advance& advance);
/// How often `study` calls advance.
int stepsOf(const std::vector<Setting>& settings, const Effort& effort);

/// Compares every setting with every other.
void markFront(std::vector<Scored>& scored);

/// The value below which `part` of the values lie. 0: there are none.
double quantileOf(std::vector<double> values, double part);

}  // namespace brittle::accuracy
