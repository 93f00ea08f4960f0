// physics/accuracy.h - every knob that trades accuracy for time, in one struct; nothing else changes results.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "engine/physics/manifold.h"

namespace brittle::physics {

/// When glass breaks. The older ways are kept for comparison.
enum class FractureMode : std::uint8_t {
  InStep,            // inside the step: the striker leaves with v0 - J/M
  AfterStep,         // the solver runs with rigid glass first, then it breaks: the striker has bounced already
  AfterStepBlended,  // the same, then velocities are blended between before and after the step
};

/// Ranges are checked by isWithinRange.
struct Accuracy {
  FractureMode fractureMode = FractureMode::InStep;
  std::int32_t fractureRounds = 3;      // breakings one after another within a tick, 1 to 64; 0: unbounded
  std::int32_t fastRounds = 8;          // InStep: up to so many while what strikes goes farther than its own size in a
                                        // tick and would hang in the air until the next one, 0 to 64; 0: no more
  bool impulseCap = true;               // off: contacts with breakable bodies are rigid until they break (comparison)
  float blend = 0.5f;                   // AfterStepBlended: v = v_old t + v_new (1 - t) [-], 0 to 1
  std::int32_t iterations = 10;         // velocity iterations, 1 to 10000
  std::int32_t positionIterations = 3;  // push-out iterations, 0 to 100
  std::int32_t substeps = 1;            // 1 to 64; strength is budgeted over all of them
  ManifoldSettings manifold;            // recycleDistance 0 to 1
  float speculativeMargin = 0.02f;      // contacts exist from this far, beside what the tick's motion needs [m], 0 to 1
  bool warmStart = true;
  bool deactivation = true;
  float patternDensity = 1.0f;          // cracks relative to the material's own number [-], 0.1 to 10
  float minVolumeScale = 1.0f;          // smallest piece that is a body, relative to the material's [-], 0 to 1e6
  std::int32_t maxDebris = 512;         // light pieces alive at once, to 1e6; the oldest are recycled. What is only
                                        // seen keeps to shares of it (game/view/omission.h)
  std::int32_t maxBodies = 2048;        // dynamic pieces alive at once, to 1e6; the oldest resting ones become debris
  bool stacks = true;                   // what stands on each other is held from below (stack.h)
  float directSolveMassRatio = 200.0f;  // contacts of bodies further apart in mass: solved at once [-]; 0: never

  template <class Archive>
  void serialize(Archive& a) {
    a(fractureMode);
    a(fractureRounds);
    a(fastRounds);
    a(impulseCap);
    a(blend);
    a(iterations);
    a(positionIterations);
    a(substeps);
    a(manifold.kind);
    a(manifold.recycleDistance);
    a(speculativeMargin);
    a(warmStart);
    a(deactivation);
    a(patternDensity);
    a(minVolumeScale);
    a(maxDebris);
    a(maxBodies);
    a(stacks);
    a(directSolveMassRatio);
  }
};

/// Whether a world can be stepped with these: every number finite and within the range named above.
bool isWithinRange(const Accuracy& accuracy);

/// Named settings, from the cheapest to the most accurate: points on the front of error against time that
/// tools/accuracy measures, as far as its seeds tell; its report says why. Budgets of pieces and debris are by what
/// lives in the shipped rooms when somebody throws at everything there is: at most 473 pieces and 283 crumbs as
/// balanced, where the budgets bind only in fuller rooms; on a phone 172 and 259, of which the fullest moments are cut.
std::span<const std::string_view> presetNames();
/// None of that name: nothing.
std::optional<Accuracy> preset(std::string_view name);

}  // namespace brittle::physics
