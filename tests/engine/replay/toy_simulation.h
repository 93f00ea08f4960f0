// A simulation of one number: small enough to see at a glance why a replay differs.
#pragma once

#include "engine/core/random.h"
#include "engine/replay/recorder.h"

namespace brittle::replay {

class ToySimulation : public Simulation {
 public:
  explicit ToySimulation(std::uint64_t seed) : random_(seed) {}
  void tick(const InputFrame& input) override {
    value_ = mixSeed(value_, random_.next());
    for (const Throw& aim : input.throws)
      value_ = mixSeed(value_, static_cast<std::uint16_t>(aim.x) * 65536u + static_cast<std::uint16_t>(aim.y));
    value_ += input.buttons;
    ++ticks;
    if (ticks == breakAt) ++value_;
  }
  std::uint64_t hash() const override { return value_; }
  void save(ByteWriter& out) const override {
    out.write(value_);
    out.write(forgetful ? std::uint64_t{0} : random_.state());
    out.write(random_.increment());
    out.write(ticks);
  }
  bool restore(ByteReader& in) override {
    value_ = in.read<std::uint64_t>();
    const auto state = in.read<std::uint64_t>();
    random_.restore(state, in.read<std::uint64_t>());
    ticks = in.read<std::uint32_t>();
    return in.ok() && in.remaining() == 0;
  }

  std::uint32_t ticks = 0;
  std::uint32_t breakAt = 0;  // one bit goes wrong in this tick
  bool forgetful = false;     // its snapshots miss something the next tick reads

 private:
  Random random_;
  std::uint64_t value_ = 1;
};

inline InputFrame toyInput(std::uint32_t tick) {
  InputFrame frame;
  if (tick % 7 == 3) frame.throws.push_back(quantizeAim(0.01f * static_cast<float>(tick), -0.2f));
  if (tick % 50 == 49) frame.throws.push_back({-32767, 32767});
  if (tick == 20) frame.buttons = 2;
  return frame;
}

inline Replay toyReplay(std::uint32_t ticks, std::uint32_t interval = 40, bool forgetful = false) {
  Start start;
  start.simulationVersion = 5;
  start.contentHash = 0xc0ffee;
  start.seed = 42;
  start.mode = 1;
  start.level = "levels/first";
  start.settings = {1, 2, 3};
  ToySimulation simulation(start.seed);
  simulation.forgetful = forgetful;
  Recorder recorder(start, interval);
  for (std::uint32_t tick = 0; tick < ticks; ++tick) {
    simulation.tick(toyInput(tick));
    recorder.record(toyInput(tick), simulation);
  }
  return recorder.replay();
}

}  // namespace brittle::replay
