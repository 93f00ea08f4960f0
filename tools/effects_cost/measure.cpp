#include "tools/effects_cost/measure.h"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "tools/callgrind/callgrind.h"
#include "tools/callgrind/shell.h"

namespace brittle::effects_cost {
namespace {

using callgrind::instructionsOf;
using callgrind::isThere;
using callgrind::numberAfter;
using callgrind::outputOf;
using effects::Effect;

constexpr const char* kProbe = BRITTLE_BINARY_DIR "/tools/effects_probe";
constexpr const char* kTimedTicks = "300";

/// What a probe's program says of itself in the room that uses nothing.
struct Plain {
  double instructions = 0.0, bytesPerBody = 0.0, programBytes = 0.0;
};

/// DepthOfField from depth-of-field, as CMake's options are called.
std::string moduleOf(Effect effect) {
  std::string module;
  bool isFirst = true;
  for (const char* c = effects::nameOf(effect); *c != '\0'; ++c) {
    if (*c != '-') module += static_cast<char>(isFirst ? std::toupper(*c) : *c);
    isFirst = *c == '-';
  }
  return module;
}

std::string optionOf(Effect effect) {
  std::string option = moduleOf(effect);
  std::transform(option.begin(), option.end(), option.begin(), [](unsigned char c) { return std::toupper(c); });
  return "BRITTLE_EFFECT_" + option;
}

Result<double> programBytesOf(const std::string& program) {
  const Result<std::string> sizes = outputOf({"size", "--format=berkeley", program});
  if (!sizes) return Error{sizes.error().message + " (apt-get install binutils)"};
  return numberAfter(*sizes, "filename");
}

/// By how much the heap grows with each body, from a room with few to one with many.
Result<double> bytesPerBodyOf(const std::string& program, int ticks) {
  double heap[2], bodies[2];
  for (const int i : {0, 1}) {
    const Result<std::string> played =
        outputOf({program, i == 0 ? "plain" : "crowd", "--ticks", std::to_string(ticks)});
    if (!played) return played.error();
    const Result<double> bytes = numberAfter(*played, "heap_bytes"), count = numberAfter(*played, "bodies");
    if (!bytes || !count) return bytes ? count.error() : bytes.error();
    heap[i] = *bytes;
    bodies[i] = *count;
  }
  return (heap[1] - heap[0]) / (bodies[1] - bodies[0]);
}

Result<Plain> plainOf(const std::string& program, int ticks) {
  const Result<double> instructions =
      instructionsOf("brittle::probe::playTick*", {program, "plain", "--ticks", std::to_string(ticks)});
  Plain plain;
  const Result<double> perBody = bytesPerBodyOf(program, ticks), size = programBytesOf(program);
  for (const Result<double>* found : {&instructions, &perBody, &size})
    if (!*found) return found->error();
  plain.instructions = *instructions;
  plain.bytesPerBody = *perBody;
  plain.programBytes = *size;
  return plain;
}

/// The probe of a build without an effect's module; of one with every module for Effect::Count. All are built file by
/// file in one folder, one after another: what does not know of the effect is the same object, so that all that differs
/// is the effect's.
Result<std::string> buildWithout(Effect effect, const std::string& jobs) {
  const std::string folder = BRITTLE_BINARY_DIR "/without";
  std::vector<std::string> configure = {"cmake", "-S", BRITTLE_SOURCE_DIR, "-B", folder, "-G", "Ninja"};
  for (const char* setting :
       {"--log-level=WARNING", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON"})
    configure.push_back(setting);
  if (isThere("ccache")) configure.push_back("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache");
  for (std::size_t i = 0; i < effects::kEffects; ++i)
    if (const auto other = static_cast<Effect>(i); hasModule(other))
      configure.push_back("-D" + optionOf(other) + (other == effect ? "=OFF" : "=ON"));
  Result<std::string> done = outputOf(configure);
  if (done) done = outputOf({"cmake", "--build", folder, "-j", jobs, "--target", "effects_probe"});
  if (!done && effect == Effect::Count) return done;
  if (!done) return Error{std::string("without ") + effects::nameOf(effect) + ": " + done.error().message};
  return folder + "/tools/effects_probe";
}

/// Of the room with what calls for the effect; `off`: with the effect switched off. The driver draws in this thread, so
/// that its work is counted.
Result<double> timeOf(Effect effect, bool off) {
  std::vector<std::string> words = {"env",     "LP_NUM_THREADS=0", kProbe,      effects::nameOf(effect),
                                    "--ticks", kTimedTicks,        "--backend", "egl"};
  if (off) words.push_back("--off");
  const Result<std::string> played = outputOf(words);
  if (!played) return played.error();
  return numberAfter(*played, "\"ms\"");
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Each round plays the room with the effect and without it in turn: whatever disturbs the machine disturbs both.
Status timeUsed(Cost& cost, int rounds) {
  std::vector<double> more;
  for (int round = 0; round < rounds; ++round) {
    const Result<double> off = timeOf(cost.effect, true), used = timeOf(cost.effect, false);
    if (!off || !used) return off ? used.error() : off.error();
    more.push_back(*used - *off);
  }
  cost.usedMilliseconds = median(more);
  return Done{};
}

Status compare(Cost& cost, const Plain& full, const Effort& effort) {
  const Result<std::string> probe = buildWithout(cost.effect, effort.jobs);
  if (!probe) return probe.error();
  const Result<Plain> without = plainOf(*probe, effort.ticks);
  if (!without) return without.error();
  cost.unusedOverhead = 100.0 * (full.instructions - without->instructions) / without->instructions;
  cost.bytesPerBody = full.bytesPerBody - without->bytesPerBody;
  cost.codeBytes = full.programBytes - without->programBytes;
  return Done{};
}

}  // namespace

bool hasModule(Effect effect) {
  std::istringstream modules(BRITTLE_EFFECT_MODULES);
  for (std::string module; modules >> module;)
    if (module == moduleOf(effect)) return true;
  return false;
}

std::size_t stepsOf(const std::vector<Effect>& effects, const Effort& effort) {
  return effort.compares ? 2 * effects.size() + 1 : effects.size();
}

Result<std::vector<Cost>> measure(const std::vector<Effect>& effects, const Effort& effort,
                                  const std::function<void(const std::string&)>& advance) {
  std::vector<Cost> costs;
  for (const Effect effect : effects) {
    advance(std::string("timing ") + effects::nameOf(effect));
    costs.push_back({});
    costs.back().effect = effect;
    if (const Status timed = timeUsed(costs.back(), effort.rounds); !timed) return timed.error();
  }
  if (!effort.compares) return costs;
  advance("counting the whole program");
  const Result<std::string> whole = buildWithout(Effect::Count, effort.jobs);
  const Result<Plain> full = whole ? plainOf(*whole, effort.ticks) : whole.error();
  if (!full) return full.error();
  for (Cost& cost : costs) {
    advance(std::string("without ") + effects::nameOf(cost.effect));
    if (!hasModule(cost.effect)) continue;
    if (const Status compared = compare(cost, *full, effort); !compared) return compared.error();
  }
  return costs;
}

}  // namespace brittle::effects_cost
