#include "tools/accuracy/figures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/core/random.h"

namespace brittle::accuracy {
namespace {

constexpr int kResamples = 100;

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

/// Which variants of a scene.
using Sample = std::vector<std::uint32_t>;

/// The figure over these: their worst or their mean.
double reduced(const Figure& figure, const std::vector<Observation>& seen, const Sample& sample) {
  std::vector<double> values;
  for (const std::uint32_t i : sample) values.push_back(figure.of(seen[i]));
  return figure.isWorst ? *std::max_element(values.begin(), values.end()) : mean(values);
}

std::vector<float> speedsOf(const std::vector<Observation>& seen, const Sample& sample) {
  std::vector<float> all;
  for (const std::uint32_t i : sample) all.insert(all.end(), seen[i].speeds.begin(), seen[i].speeds.end());
  return all;
}

double speedError(const std::vector<Observation>& seen, const std::vector<Observation>& reference,
                  const Sample& sample) {
  const std::vector<float> expected = speedsOf(reference, sample);
  double sum = 0.0;
  for (const float speed : expected) sum += static_cast<double>(speed);
  if (sum == 0.0) return 0.0;
  return 100.0 * wassersteinOf(speedsOf(seen, sample), expected) * static_cast<double>(expected.size()) / sum;
}

double errorOver(const Figure& figure, const std::vector<Observation>& seen, const std::vector<Observation>& reference,
                 const Sample& sample) {
  if (figure.compared == Compared::AsSpeeds) return speedError(seen, reference, sample);
  const double value = reduced(figure, seen, sample);
  if (figure.compared == Compared::WithExact) return value;
  const double expected = reduced(figure, reference, sample);
  return 100.0 * std::abs(value - expected) / std::max(std::abs(expected), 1e-12);
}

/// What is no worst case has the bounds that resampling the variants gives (bootstrap: Efron, Bootstrap Methods, 1979).
Deviation errorOf(const Figure& figure, const std::vector<Observation>& seen,
                  const std::vector<Observation>& reference) {
  if (seen.empty() || reference.empty()) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none, none};
  }
  const auto count = static_cast<std::uint32_t>(std::min(seen.size(), reference.size()));
  Sample sample(count);
  std::iota(sample.begin(), sample.end(), 0u);
  const double value = errorOver(figure, seen, reference, sample);
  if (figure.isWorst || count == 1) return {value, value, value};
  Random random(5);
  std::vector<double> resampled;
  for (int i = 0; i < kResamples; ++i) {
    for (std::uint32_t& variant : sample) variant = random.nextBelow(count);
    resampled.push_back(errorOver(figure, seen, reference, sample));
  }
  std::sort(resampled.begin(), resampled.end());
  return {value, std::min(value, resampled[kResamples * 25 / 1000]),
          std::max(value, resampled[kResamples * 975 / 1000])};
}

double exitSpeed(const Observation& seen) {
  return 100.0 * seen.missedAtEnd[0] / seen.exactAtEnd[0];
}
double late(const Observation& seen) {
  return 100.0 * seen.missedAtEnd[1];
}
double missed(const Observation& seen) {
  return seen.missedAtEnd[0];
}
double wrong(const Observation& seen) {
  return 100.0 * seen.missedAtEnd[0];
}
double worst(const Observation& seen) {
  return seen.missedAtWorst[0];
}

}  // namespace

std::span<const Figure> allFigures() {
  using enum Compared;
  static const Figure figures[] = {
      {"panes", "exit speed", "%", WithExact, true, 2.0, exitSpeed},
      {"panes", "place behind", "cm", WithExact, true, 10.0, late},
      {"panes", "direction", "deg", WithExact, true, 1.0, [](const Observation& seen) { return seen.turned; }},
      {"panes", "panes not broken", "", WithExact, true, 0.5,
       [](const Observation& seen) { return 6.0 - seen.broken; }},
      {"panes", "shard push", "%", WithReference, false, 20.0, [](const Observation& seen) { return seen.push; }},
      {"panes", "deferred breaks", "", WithExact, false, 0.0, [](const Observation& seen) { return seen.held; }},
      {"grazes", "missed or ghost breaks", "%", WithExact, false, 1.0, wrong},
      {"stack", "displacement", "mm", WithExact, true, 10.0, missed},
      {"stack", "false breaks", "", WithExact, true, 0.5, [](const Observation& seen) { return seen.breaks; }},
      {"shatter", "shard speeds", "%", AsSpeeds, false, 10.0, nullptr},
      {"shatter", "momentum lost", "", WithExact, true, 1e-4,
       [](const Observation& seen) { return seen.momentumLost; }},
      {"shatter", "energy gained", "", WithExact, true, 1e-3,
       [](const Observation& seen) { return seen.energyGained; }},
      {"shatter", "bodies spoilt by numbers", "", WithExact, true, 0.5,
       [](const Observation& seen) { return seen.spoilt; }},
      {"shatter", "overlap", "mm", WithExact, false, 0.0, [](const Observation& seen) { return seen.overlap; }},
      {"swing", "angle", "deg", WithExact, true, 1.0, worst},
      {"packed", "displacement", "mm", WithExact, true, 1.0, missed},
      {"packed", "deepest overlap", "mm", WithExact, true, 1.0, [](const Observation& seen) { return seen.deepest; }},
      // Not in the score: single shards that are flung out of a crowd decide it, and it does not converge.
      {"flood", "shard speeds", "%", AsSpeeds, false, 0.0, nullptr},
      {"flood", "overlap", "mm", WithExact, false, 2.0, [](const Observation& seen) { return seen.overlap; }},
      {"flood", "deepest overlap", "mm", WithExact, true, 0.0, [](const Observation& seen) { return seen.deepest; }},
      {"flood", "breakings", "%", WithReference, false, 20.0, [](const Observation& seen) { return seen.breaks; }},
      {"flood", "fallen through the floor", "", WithExact, true, 0.5,
       [](const Observation& seen) { return seen.escaped; }},
      {"flood", "volume lost", "", WithExact, true, 1e-4, [](const Observation& seen) { return seen.volumeLost; }},
      {"flood", "volume no longer bodies", "%", WithExact, false, 5.0,
       [](const Observation& seen) { return 100.0 * seen.crumbVolume; }},
  };
  return figures;
}

std::size_t sceneOf(const Figure& figure) {
  return static_cast<std::size_t>(findScene(figure.scene) - allScenes().data());
}

std::vector<Deviation> errorsOf(const std::vector<std::vector<Observation>>& seen,
                                const std::vector<std::vector<Observation>>& reference) {
  std::vector<Deviation> errors;
  for (const Figure& figure : allFigures()) {
    errors.push_back(errorOf(figure, seen[sceneOf(figure)], reference[sceneOf(figure)]));
  }
  return errors;
}

double scoreOf(const std::vector<Deviation>& errors, double Deviation::*bound) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double tolerance = allFigures()[i].tolerance;
    if (tolerance == 0.0 || std::isnan(errors[i].value)) continue;
    const double part = std::min(errors[i].*bound / tolerance, kWorst);
    sum += part * part;
    ++count;
  }
  return count == 0 ? 0.0 : std::sqrt(sum / count);
}

double wassersteinOf(std::vector<float> a, std::vector<float> b) {
  if (a.empty() || b.empty()) return a.empty() && b.empty() ? 0.0 : 1e30;
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  const auto partBelow = [](std::size_t i, const std::vector<float>& sample) {
    return static_cast<double>(i) / static_cast<double>(sample.size());
  };
  std::size_t i = 0, k = 0;
  double area = 0.0, last = static_cast<double>(std::min(a[0], b[0]));
  while (i < a.size() || k < b.size()) {
    const bool isA = k == b.size() || (i < a.size() && a[i] < b[k]);
    const double here = static_cast<double>(isA ? a[i] : b[k]);
    area += (here - last) * std::abs(partBelow(i, a) - partBelow(k, b));
    last = here;
    ++(isA ? i : k);
  }
  return area;
}

}  // namespace brittle::accuracy
