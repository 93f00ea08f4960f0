#include "engine/physics/accuracy.h"

namespace brittle::physics {
namespace {

constexpr std::string_view kPresetNames[] = {"phone", "balanced", "accurate", "reference"};

template <class T>
bool isWithin(T value, T low, T high) {
  return value >= low && value <= high;  // false for NaN
}

}  // namespace

bool isWithinRange(const Accuracy& a) {
  return a.fractureMode <= FractureMode::AfterStepBlended && isWithin(a.fractureRounds, 0, 64) &&
         isWithin(a.fastRounds, 0, 64) && isWithin(a.blend, 0.0f, 1.0f) && isWithin(a.iterations, 1, 10'000) &&
         isWithin(a.positionIterations, 0, 100) && isWithin(a.substeps, 1, 64) &&
         a.manifold.kind <= ManifoldKind::Clipped && isWithin(a.manifold.recycleDistance, 0.0f, 1.0f) &&
         isWithin(a.speculativeMargin, 0.0f, 1.0f) && isWithin(a.patternDensity, 0.1f, 10.0f) &&
         isWithin(a.minVolumeScale, 0.0f, 1e6f) && isWithin(a.maxDebris, 0, 1'000'000) &&
         isWithin(a.maxBodies, 0, 1'000'000) && isWithin(a.directSolveMassRatio, 0.0f, 1e9f);
}

std::span<const std::string_view> presetNames() {
  return kPresetNames;
}

std::optional<Accuracy> preset(std::string_view name) {
  Accuracy accuracy;
  if (name == "balanced") return accuracy;
  if (name == "phone") {
    accuracy.minVolumeScale = 10.0f;
    accuracy.maxDebris = 192;
    accuracy.maxBodies = 192;
  } else if (name == "accurate") {
    accuracy.iterations = 8;
    accuracy.substeps = 2;
    accuracy.maxDebris = 1024;
    accuracy.maxBodies = 4096;
  } else if (name == "reference") {
    accuracy.iterations = 32;
    accuracy.substeps = 8;
    accuracy.maxDebris = 2048;
    accuracy.maxBodies = 8192;
  } else {
    return std::nullopt;
  }
  return accuracy;
}

}  // namespace brittle::physics
