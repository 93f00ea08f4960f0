// brittle/speakers.h - plays the sound of a game on the system's device.
#pragma once

#include <memory>

#include "game/sim/frame_packet.h"

namespace brittle::program {

class Speakers {
 public:
  /// Null where there is no device: that is said in one line, and the game goes on in silence.
  static std::unique_ptr<Speakers> open();
  ~Speakers();
  Speakers(const Speakers&) = delete;
  Speakers& operator=(const Speakers&) = delete;

  /// After every tick.
  void ticked(const sim::FramePacket& packet);
  /// Another game follows.
  void restarted();
  /// What it left out so far.
  std::vector<NamedCount> omissions() const;

 private:
  struct Parts;
  explicit Speakers(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace brittle::program
