// accuracy/instructions.h - what each setting costs in instructions: the same number on every run, where times differ
// by what else the machine does.
#pragma once

#include <string_view>
#include <vector>

#include "tools/accuracy/study.h"

namespace brittle::accuracy {

/// Counted is World::step in the first variant of this scene: short, and it has everything that the step does in zero
/// gravity.
inline constexpr std::string_view kCountedScene = "shatter";

/// What --accuracy takes: "iterations 16" for a value of a knob, a preset by its name.
std::string nameOf(const Setting& setting);

/// Fills in every setting's instructions per simulated second, by playing the scene in a child under callgrind. Calls
/// advance once a setting.
Status countInstructions(std::vector<Scored>& scored, const Advance& advance);

}  // namespace brittle::accuracy
