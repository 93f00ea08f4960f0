#include "tools/accuracy/instructions.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "tools/callgrind/callgrind.h"

namespace brittle::accuracy {
namespace {

/// This program.
Result<std::string> ownPath() {
  std::error_code problem;
  const std::filesystem::path path = std::filesystem::read_symlink("/proc/self/exe", problem);
  if (problem) return Error{"/proc/self/exe: cannot be read: " + problem.message()};
  return path.string();
}

double secondsOf(const Scene& scene, const physics::Accuracy& accuracy) {
  return static_cast<double>(kTick) * static_cast<double>(observe(scene, accuracy, 0).tickMs.size());
}

}  // namespace

std::string nameOf(const Setting& setting) {
  return setting.knob == "preset" ? setting.value : setting.knob + " " + setting.value;
}

Status countInstructions(std::vector<Scored>& scored, const Advance& advance) {
  const Result<std::string> self = ownPath();
  if (!self) return self.error();
  const double seconds = secondsOf(*findScene(kCountedScene), {});
  for (auto one = scored.begin(); one != scored.end(); ++one) {
    const auto same = std::find_if(scored.begin(), one, [&](const Scored& other) {
      return isSame(other.setting.accuracy, one->setting.accuracy);
    });
    if (same == one) {
      const Result<double> counted =
          callgrind::instructionsOf("brittle::physics::World::step(float)",
                                    {*self, "--scene", std::string(kCountedScene), "--accuracy", nameOf(one->setting)});
      if (!counted) return counted.error();
      one->cost.instructions = *counted / seconds;
    } else {
      one->cost.instructions = same->cost.instructions;
    }
    advance();
  }
  return Done{};
}

}  // namespace brittle::accuracy
