// sandbox/timeline.h - a simulation that can go back: what was put in at each tick, and its state every few ticks. Any
// tick that was reached once is reached again, bit for bit.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "engine/core/assert.h"
#include "engine/core/byte_stream.h"

namespace brittle::sandbox {

/// A Simulation has a type Input with ==, whose default is nothing; tick(const Input&), save(ByteWriter&) const and
/// restore(ByteReader&).
template <class Simulation>
class Timeline {
 public:
  using Input = typename Simulation::Input;

  /// Takes the state as it is for tick 0. `known`: what is put in later, if that is known already.
  explicit Timeline(Simulation& simulation, std::vector<Input> known = {})
      : simulation_(simulation), inputs_(std::move(known)) {
    keep(true);
  }

  std::uint32_t tick() const { return tick_; }
  /// One beyond the last tick of which the input is known.
  std::uint32_t end() const { return static_cast<std::uint32_t>(inputs_.size()); }
  std::size_t bytes() const { return bytes_; }

  /// One tick. An input that says something replaces what is known of the future.
  void step(const Input& input = {}) {
    if (!(input == Input{})) forgetFuture();
    if (tick_ == end()) inputs_.push_back(input);
    simulation_.tick(inputs_[tick_++]);
    if (const State* known = neededAt(tick_)) restore(*known);
    if (tick_ % spacing_ == 0 && tick_ > states_.back().tick) keep(false);
  }

  /// To any tick in [0, end()]: from the last state kept before it.
  void seek(std::uint32_t target) {
    BR_ASSERT(target <= end());
    std::size_t nearest = states_.size() - 1;
    while (states_[nearest].tick > target) --nearest;
    if (tick_ > target || states_[nearest].tick > tick_) restore(states_[nearest]);
    while (tick_ < target) step();
  }

  /// The simulation was changed from outside: other states follow, from the same inputs.
  void changed() {
    forgetStates(tick_);
    keep(true);
  }

 private:
  static constexpr std::size_t kMostBytes = std::size_t{256} << 20;

  struct State {
    std::uint32_t tick;
    bool needed;  // the ticks after it cannot be reached from an earlier one
    std::vector<unsigned char> bytes;
  };

  void forgetFuture() {
    inputs_.resize(tick_);
    forgetStates(tick_ + 1);
  }
  void forgetStates(std::uint32_t from) {
    while (!states_.empty() && states_.back().tick >= from) drop(states_.size() - 1);
  }
  const State* neededAt(std::uint32_t tick) const {
    for (const State& state : states_)
      if (state.needed && state.tick == tick) return &state;
    return nullptr;
  }
  void keep(bool needed) {
    ByteWriter out;
    simulation_.save(out);
    states_.push_back({tick_, needed, out.bytes()});
    bytes_ += out.bytes().size();
    if (bytes_ > kMostBytes) thin();
  }
  void drop(std::size_t index) {
    bytes_ -= states_[index].bytes.size();
    states_.erase(states_.begin() + static_cast<std::ptrdiff_t>(index));
  }
  /// Half as many states from now on.
  void thin() {
    spacing_ *= 2;
    for (std::size_t i = states_.size(); i-- > 0;)
      if (!states_[i].needed && states_[i].tick % spacing_ != 0) drop(i);
  }
  void restore(const State& state) {
    ByteReader in(state.bytes);
    const bool isRestored = simulation_.restore(in);
    BR_ASSERT(isRestored);
    tick_ = state.tick;
  }

  Simulation& simulation_;
  std::vector<Input> inputs_;
  std::vector<State> states_;  // by tick; the first is of tick 0
  std::uint32_t tick_ = 0, spacing_ = 8;
  std::size_t bytes_ = 0;
};

}  // namespace brittle::sandbox
