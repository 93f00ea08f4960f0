#include "tools/brittle/price.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace brittle::program {
namespace {

/// The differences of ticks or pictures of the same number, each the mean of a tenth of them in a row: what disturbs
/// one disturbs its neighbours.
std::vector<double> differencesOf(const std::vector<double>& all, const std::vector<double>& less) {
  constexpr std::size_t kParts = 10;
  const std::size_t count = std::min(all.size(), less.size());
  const std::size_t each = std::max<std::size_t>(count / kParts, 1);
  std::vector<double> parts;
  for (std::size_t begin = 0; begin + each <= count && parts.size() < kParts; begin += each) {
    double sum = 0.0;
    for (std::size_t i = begin; i < begin + each; ++i) sum += all[i] - less[i];
    parts.push_back(sum / static_cast<double>(each));
  }
  return parts;
}

double standardErrorOf(const std::vector<double>& values) {
  if (values.size() < 2) return 0.0;
  const double mean = meanOf(values);
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const auto n = static_cast<double>(values.size());
  return std::sqrt(squares / (n * (n - 1.0)));
}

Price saved(const std::vector<double>& all, const std::vector<double>& less) {
  return {meanOf(all) - meanOf(less), 2.0 * standardErrorOf(differencesOf(all, less))};
}

Price between(const Price& first, const Price& last) {
  const double drift = std::fabs(first.value - last.value);
  return {0.5 * (first.value + last.value), std::max({first.noise, last.noise, drift})};
}

}  // namespace

double meanOf(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(std::max<std::size_t>(values.size(), 1));
}

Prices pricesOf(const Spent& before, const Spent& less, const Spent& after) {
  return {between({before.heapBytes - less.heapBytes}, {after.heapBytes - less.heapBytes}),
          between(saved(before.ticks, less.ticks), saved(after.ticks, less.ticks)),
          between(saved(before.pictures, less.pictures), saved(after.pictures, less.pictures))};
}

std::string inWords(const Price& price, double unit, int decimals) {
  const double last = std::pow(10.0, -decimals), value = price.value / unit, noise = price.noise / unit;
  const bool isKnown = std::fabs(value) > noise && std::fabs(value) >= 0.5 * last;
  char text[48];
  std::snprintf(text, sizeof text, isKnown ? "%.*f" : "< %.*f", decimals,
                isKnown ? value : std::max(std::ceil(noise / last), 1.0) * last);
  return text;
}

}  // namespace brittle::program
