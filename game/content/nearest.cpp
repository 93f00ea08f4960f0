#include "game/content/nearest.h"

#include <algorithm>
#include <vector>

namespace brittle::content {
namespace {

constexpr std::size_t kFar = 3, kLongest = 100;

/// Letters to change, add or leave out between two names. Source: Wagner and Fischer, The String-to-String Correction
/// Problem, 1974.
std::size_t distanceBetween(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

}  // namespace

std::string nearestOf(std::string_view name, std::span<const std::string_view> known) {
  std::string_view nearest;
  std::size_t least = kFar;
  if (name.size() > kLongest) return {};
  for (const std::string_view candidate : known) {
    const std::size_t distance = distanceBetween(name, candidate);
    // of a name of three letters, two changed are another name
    if (distance >= least || 2 * distance > candidate.size()) continue;
    least = distance;
    nearest = candidate;
  }
  return std::string(nearest);
}

std::string listOf(std::span<const std::string_view> names) {
  std::string list;
  for (const std::string_view name : names) list.append(list.empty() ? "" : ", ").append(name);
  return names.size() == 1 ? list : "one of " + list;
}

}  // namespace brittle::content
