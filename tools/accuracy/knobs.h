// accuracy/knobs.h - what the study turns: every knob of engine/physics/accuracy.h over its values, one at a time
// around the default, then iterations and sub-steps together, and the presets.
#pragma once

#include <string>
#include <vector>

#include "engine/physics/accuracy.h"

namespace brittle::accuracy {

struct Setting {
  std::string knob;   // "iterations"
  std::string value;  // "16"; of the default "10"
  int order = 0;      // within its knob
  bool isDefault = false;
  physics::Accuracy accuracy;
};

/// Knob by knob, each with the default among its values. `quick`: the few that the directions are tested by.
std::vector<Setting> knobSettings(bool quick);
/// When glass breaks, alone.
std::vector<Setting> fractureModes();
/// Iterations by sub-steps.
std::vector<Setting> gridSettings(bool quick);
/// The presets of engine/physics/accuracy.h by name.
std::vector<Setting> presetSettings();

/// Whether two settings are the same in every number: then they need to be measured once only.
bool isSame(const physics::Accuracy& a, const physics::Accuracy& b);

/// What everything is compared with: small steps, many iterations, no bound of rounds, nothing recycled or at rest.
/// `fineness` 1 is the reference; 2 and 4 have sub-steps so many times as long, to show that it has converged.
physics::Accuracy referenceAccuracy(int fineness = 1);

}  // namespace brittle::accuracy
