// effects_cost/measure.h - what an effect costs where it is used, and what it costs where it is not: the same room
// played by a build with all modules and by one that the effect's module was left out of.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/effects/effect.h"

namespace brittle::effects_cost {

struct Cost {
  effects::Effect effect = effects::Effect::Count;
  double usedMilliseconds = 0.0;  // a tick with its picture and sound, more than without the effect
  // Against a build without its module, in a room that does not use it; nothing if it was not compared.
  std::optional<double> unusedOverhead;  // of instructions [%]
  std::optional<double> bytesPerBody;    // of heap [bytes]
  std::optional<double> codeBytes;       // of program that is not linked without the module
};

struct Effort {
  int ticks = 120;  // that instructions are counted over
  int rounds = 7;   // of timing, interleaved
  bool compares = true;
  std::string jobs = "2";
};

/// Whether the effect has a module that can be left out.
bool hasModule(effects::Effect effect);

/// `advance` is called before each step with what it is.
Result<std::vector<Cost>> measure(const std::vector<effects::Effect>& effects, const Effort& effort,
                                  const std::function<void(const std::string&)>& advance);
/// How many steps measure takes.
std::size_t stepsOf(const std::vector<effects::Effect>& effects, const Effort& effort);

}  // namespace brittle::effects_cost
