// core/slot_pool.h - values in numbered slots, reached by handles that go stale when the slot is reused.
// Iteration is in slot order and slots are reused last-freed-first, so the order depends on the calls made and on
// nothing else.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "engine/core/assert.h"
#include "engine/core/handle.h"

namespace brittle {

/// A snapshot of a pool with more slots is refused: an empty slot is five bytes in it, and a whole value in memory.
/// Chosen: twice the 32,000 bodies of the largest test, and of the largest values, 1 kB each, 64 MB.
inline constexpr std::size_t kMostRestoredSlots = 65'536;

template <class T, class HandleType>
class SlotPool {
 public:
  void reserve(std::size_t count) {
    slots_.reserve(count);
    free_.reserve(count);
  }

  HandleType insert(T value) {
    if (free_.empty()) {
      free_.push_back(static_cast<std::uint32_t>(slots_.size()));
      slots_.emplace_back();
    }
    const std::uint32_t index = free_.back();
    free_.pop_back();
    Slot& slot = slots_[index];
    slot.value = std::move(value);
    slot.alive = true;
    ++alive_;
    return {index, slot.generation};
  }

  /// The value goes back to a default-constructed one; every handle to it is stale from now on.
  void erase(HandleType handle) {
    BR_ASSERT(contains(handle));
    Slot& slot = slots_[handle.index];
    slot.value = T{};
    slot.alive = false;
    slot.generation = slot.generation == ~0u ? 1 : slot.generation + 1;
    free_.push_back(handle.index);
    --alive_;
  }

  bool contains(HandleType handle) const {
    return handle.generation != 0 && handle.index < slots_.size() && slots_[handle.index].alive &&
           slots_[handle.index].generation == handle.generation;
  }

  T& operator[](HandleType handle) {
    BR_ASSERT(contains(handle));
    return slots_[handle.index].value;
  }
  const T& operator[](HandleType handle) const {
    BR_ASSERT(contains(handle));
    return slots_[handle.index].value;
  }
  T* find(HandleType handle) { return contains(handle) ? &slots_[handle.index].value : nullptr; }
  const T* find(HandleType handle) const { return contains(handle) ? &slots_[handle.index].value : nullptr; }

  /// By slot number; the slot must be alive.
  T& at(std::uint32_t index) {
    BR_ASSERT(isAlive(index));
    return slots_[index].value;
  }
  const T& at(std::uint32_t index) const {
    BR_ASSERT(isAlive(index));
    return slots_[index].value;
  }
  bool isAlive(std::uint32_t index) const { return index < slots_.size() && slots_[index].alive; }
  HandleType handleAt(std::uint32_t index) const { return {index, slots_[index].generation}; }

  std::size_t size() const { return alive_; }
  /// One past the highest slot ever used.
  std::uint32_t capacity() const { return static_cast<std::uint32_t>(slots_.size()); }

  /// Calls visit(handle, value) for every alive slot, in slot order. The visitor may not insert.
  template <class Visit>
  void forEach(Visit&& visit) {
    for (std::uint32_t i = 0; i < capacity(); ++i)
      if (slots_[i].alive) visit(handleAt(i), slots_[i].value);
  }
  template <class Visit>
  void forEach(Visit&& visit) const {
    for (std::uint32_t i = 0; i < capacity(); ++i)
      if (slots_[i].alive) visit(handleAt(i), slots_[i].value);
  }

  /// Slots, generations and the order of reuse: what a snapshot must hold.
  /// What damaged bytes could break: the free slots are the empty ones, each once; no handle to a slot is null.
  bool isConsistent() const {
    for (const Slot& slot : slots_)
      if (slot.generation == 0) return false;
    std::vector<bool> isFree(slots_.size(), false);
    for (const std::uint32_t index : free_) {
      if (index >= slots_.size() || slots_[index].alive || isFree[index]) return false;
      isFree[index] = true;
    }
    return alive_ + free_.size() == slots_.size();
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.vector(free_);
    archive.resize(slots_, sizeof(Slot::generation) + sizeof(Slot::alive), kMostRestoredSlots);
    for (Slot& slot : slots_) {
      archive(slot.generation);
      archive(slot.alive);
      if (slot.alive) archive(slot.value);
    }
    alive_ = 0;
    for (const Slot& slot : slots_) alive_ += slot.alive ? 1 : 0;
  }

 private:
  struct Slot {
    T value{};
    std::uint32_t generation = 1;
    bool alive = false;
  };
  std::vector<Slot> slots_;
  std::vector<std::uint32_t> free_;
  std::size_t alive_ = 0;
};

}  // namespace brittle
