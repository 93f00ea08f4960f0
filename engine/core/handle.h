// core/handle.h - typed ids by value: an index and a generation, so that a stale handle is detected. Zero is null.
#pragma once

#include <cstdint>

namespace brittle {

template <class Tag>
struct Handle {
  std::uint32_t index = 0;       // slot, meaningful only if generation != 0
  std::uint32_t generation = 0;  // 0: the null handle

  template <class Archive>
  void serialize(Archive& archive) {
    archive(index);
    archive(generation);
  }
  explicit operator bool() const { return generation != 0; }
  friend bool operator==(const Handle&, const Handle&) = default;
  /// Order by slot, then generation: stable across machines, unlike any order by address.
  friend bool operator<(const Handle& a, const Handle& b) {
    return a.index != b.index ? a.index < b.index : a.generation < b.generation;
  }
};

}  // namespace brittle
