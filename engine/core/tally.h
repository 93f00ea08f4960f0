// core/tally.h - what was put off, refused, recycled or taken away so that the rest keeps within its bounds: a number
// for each way of it, with the name it is shown by. Every layer that does so has one, and nothing goes uncounted.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace brittle {

struct NamedCount {
  const char* name = "";
  std::uint64_t count = 0;
};

/// Adds what has the same name; the rest follows.
inline void addUp(std::vector<NamedCount>& to, const std::vector<NamedCount>& counts) {
  for (const NamedCount& one : counts) {
    const auto known = std::find_if(to.begin(), to.end(),
                                    [&](const NamedCount& other) { return std::string_view(other.name) == one.name; });
    if (known == to.end())
      to.push_back(one);
    else
      known->count += one.count;
  }
}

/// A number for each enumerator of Kind, which ends with Count; nameOf(Kind) names them.
template <class Kind>
class Tally {
 public:
  void add(Kind kind, std::uint64_t count = 1) { counts_[static_cast<std::size_t>(kind)] += count; }
  void add(const Tally& other) {
    for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += other.counts_[i];
  }
  std::uint64_t operator[](Kind kind) const { return counts_[static_cast<std::size_t>(kind)]; }
  /// Appends those that are not zero.
  void list(std::vector<NamedCount>& counts) const {
    for (std::size_t i = 0; i < counts_.size(); ++i)
      if (counts_[i] > 0) counts.push_back({nameOf(static_cast<Kind>(i)), counts_[i]});
  }

 private:
  std::array<std::uint64_t, static_cast<std::size_t>(Kind::Count)> counts_{};
};

}  // namespace brittle
