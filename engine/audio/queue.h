// audio/queue.h - from one thread to one other without a lock: the audio callback must never wait for the game.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <type_traits>

namespace brittle::audio {

/// Holds up to `capacity` - 1 items.
template <class T, std::size_t capacity>
class Queue {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  /// By the producing thread. False, and nothing is done, when it is full.
  bool push(const T& item) {
    const std::size_t at = end_.load(std::memory_order_relaxed);
    const std::size_t next = (at + 1) % capacity;
    if (next == begin_.load(std::memory_order_acquire)) return false;
    items_[at] = item;
    end_.store(next, std::memory_order_release);
    return true;
  }
  /// By the consuming thread. False when it is empty.
  bool pop(T& item) {
    const std::size_t at = begin_.load(std::memory_order_relaxed);
    if (at == end_.load(std::memory_order_acquire)) return false;
    item = items_[at];
    begin_.store((at + 1) % capacity, std::memory_order_release);
    return true;
  }

 private:
  std::array<T, capacity> items_{};
  std::atomic<std::size_t> begin_{0}, end_{0};
};

}  // namespace brittle::audio
