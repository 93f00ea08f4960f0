// tests/game/sim/endless.h - a game that goes on for hours: rooms of shipped segments in an order drawn anew, and a
// player who throws at everything there is.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engine/core/random.h"
#include "game/sim/constants.h"
#include "game/sim/game.h"
#include "tests/game/sim/layered_source.h"

namespace brittle::sim {

/// 500 rooms, four and a half hours: each of one of the shipped rooms' segments and as many doors as it takes.
inline LayeredSource endlessSource() {
  std::string kinds;
  for (const char* kind : {"hall", "gallery", "vault"}) {
    std::vector<std::string> names;
    for (const auto& file :
         std::filesystem::directory_iterator(BRITTLE_SOURCE_DIR "/assets/segments/first/" + std::string(kind)))
      names.push_back("\"first/" + std::string(kind) + "/" + file.path().stem().string() + "\"");
    std::sort(names.begin(), names.end());
    std::string list;
    for (const std::string& name : names) list += name + ", ";
    kinds += "{ " + list + "},\n";
  }
  const std::string room = "local kinds = {\n" + kinds + R"(}
function init()
  local names = kinds[mgRndInt(1, #kinds)]
  for i = 1, #names do
    confSegment(names[i], mgRndFloat(0.3, 1))
  end
  local l = 0
  while l < 150 do
    l = l + mgSegment(nextSegment(), -l)
  end
  mgLength(l)
end)";
  return LayeredSource({{"levels/endless.xml", levelOf(500, "endless")}, {"rooms/endless.lua", room}});
}

/// Throws at whatever is in sight, nearest first and each thing again after a while, a little beside it now and then;
/// where nothing is, anywhere.
class Thrower {
 public:
  explicit Thrower(std::uint64_t seed) : random_(seed) {}

  replay::InputFrame next(const Game& game) {
    replay::InputFrame frame;
    const std::uint64_t tick = game.tickCount();
    if (tick % kEvery != 0) return frame;
    game.look(sights_);
    std::erase_if(again_, [&](const auto& thing) { return thing.second <= tick; });
    const auto target = std::find_if(sights_.begin(), sights_.end(), [&](const Sight& sight) {
      return sight.position.z() > 0.8f && sight.position.z() < kFarthest && !again_.contains(sight.id);
    });
    if (target != sights_.end()) {
      again_[target->id] = tick + kAgain;
      frame.throws.push_back(aimAt(*target, game));
    } else if (tick % (3 * kEvery) == 0) {
      const float x = spread(0.4f);
      frame.throws.push_back(replay::quantizeAim(x, spread(0.25f)));
    }
    return frame;
  }

 private:
  static constexpr std::uint64_t kEvery = 15, kAgain = 45;  // [ticks]
  static constexpr float kFarthest = 25.0f;                 // [m]

  float spread(float most) { return random_.nextFloat(-most, most); }

  /// Where it will be when the ball is there; the ball is lobbed, and back on the aimed line after rules::kAimDistance.
  replay::Throw aimAt(const Sight& sight, const Game& game) {
    const float speed = rules::kThrowSpeed + game.camera().velocity.norm();
    Vec3 at = sight.position;
    float time = 0.0f;
    for (int i = 0; i < 3; ++i) {
      time = maxOf(0.0f, at.norm() - rules::kThrowAhead) / speed;
      at = sight.position + sight.velocity * time;
    }
    const float lob = 0.5f * game.gravity() * time * (rules::kAimDistance / speed - time);
    const float x = at.x() / at.z() + spread(0.01f);
    return replay::quantizeAim(x, (at.y() - lob) / at.z() + spread(0.01f));
  }

  Random random_;
  std::vector<Sight> sights_;
  std::map<std::uint64_t, std::uint64_t> again_;  // by thing: the tick from which it is thrown at again
};

}  // namespace brittle::sim
