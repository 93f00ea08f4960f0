#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "engine/core/profile.h"
#include "game/sim/constants.h"
#include "game/view/sound.h"
#include "tools/brittle/faults.h"
#include "tools/brittle/game.h"
#include "tools/brittle/interrupt.h"

namespace brittle::program {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Time spent in each named zone, nested ones included in their outer ones.
class ZoneTimes : public ZoneListener {
 public:
  void zoneBegins(const char* name) override { open_.push_back({name, Clock::now()}); }
  void zoneEnds(const char*) override {
    milliseconds[open_.back().first] += millisecondsSince(open_.back().second);
    open_.pop_back();
  }
  std::map<std::string, double> milliseconds;

 private:
  std::vector<std::pair<const char*, Clock::time_point>> open_;
};

struct RoomCost {
  std::map<std::string, std::map<std::string, int>> demands;  // effect -> who -> how often
  std::map<std::string, double> zones;                        // [ms], all ticks together
  double milliseconds = 0.0, worst = 0.0;
  std::size_t bytes = 0;  // largest snapshot
  double soundMilliseconds = 0.0;
  std::size_t soundBytes = 0;  // of the rooms' reverb and echo, at most
  int ticks = 0;
};

void collectDemands(const effects::EffectSet& effects, RoomCost& cost) {
  std::map<std::string, std::map<std::string, int>> now;
  for (const effects::Demand& demand : effects.demands()) ++now[effects::nameOf(demand.effect)][demand.who];
  for (const auto& [effect, who] : now)
    for (const auto& [name, count] : who) cost.demands[effect][name] = std::max(cost.demands[effect][name], count);
}

/// Mixes the game's sound as it would be heard.
class Listener {
 public:
  explicit Listener(const audio::Bank& bank)
      : mixer_(bank), sound_(mixer_), stereo_(2 * audio::kSampleRate / sim::rules::kTickRate) {}
  void listen(const sim::Game& game, RoomCost& cost) {
    const Clock::time_point start = Clock::now();
    game.copyFrame(packet_);
    sound_.tick(packet_);
    mixer_.render(stereo_);
    cost.soundMilliseconds += millisecondsSince(start);
    cost.soundBytes = std::max(cost.soundBytes, mixer_.spaceBytes());
  }

 private:
  audio::Mixer mixer_;
  view::Sound sound_;
  sim::FramePacket packet_;
  std::vector<float> stereo_;
};

/// Plays a room from end to end with a throw straight ahead every second.
RoomCost playRoom(sim::Game& game, Listener& listener) {
  RoomCost cost;
  ZoneTimes times;
  ZoneListener* const previous = setZoneListener(&times);
  const std::uint64_t room = game.roomNumber();
  while (cost.ticks < sim::rules::kRoomTicks && game.roomNumber() == room && !game.isOver() && !isInterrupted()) {
    replay::InputFrame input;
    if (cost.ticks % sim::rules::kTickRate == 0) input.throws.push_back({0, 0});
    const Clock::time_point start = Clock::now();
    game.tick(input);
    const double spent = millisecondsSince(start);
    cost.milliseconds += spent;
    cost.worst = std::max(cost.worst, spent);
    listener.listen(game, cost);
    if (cost.ticks++ % sim::rules::kTickRate != 0) continue;
    collectDemands(game.effects(), cost);
    ByteWriter out;
    game.save(out);
    cost.bytes = std::max(cost.bytes, out.bytes().size());
  }
  setZoneListener(previous);
  cost.zones = times.milliseconds;
  return cost;
}

void print(std::uint32_t room, const RoomCost& cost) {
  const double ticks = std::max(cost.ticks, 1);
  std::printf("room %u: %.3f ms a tick, worst %.2f ms, over %d ticks with a throw a second; state %zu kB\n", room,
              cost.milliseconds / ticks, cost.worst, cost.ticks, cost.bytes / 1024);
  for (const auto& [effect, who] : cost.demands) {
    int count = 0;
    for (const auto& [name, times] : who) count += times;
    std::printf("  %-10s demanded %d times by %s%s\n", effect.c_str(), count, who.begin()->first.c_str(),
                who.size() > 1 ? (" and " + std::to_string(who.size() - 1) + " more").c_str() : "");
  }
  for (int i = 0; i < static_cast<int>(effects::Effect::Count); ++i)
    if (const char* name = effects::nameOf(static_cast<effects::Effect>(i)); !cost.demands.contains(name))
      std::printf("  %-10s nobody demands it\n", name);
  for (const auto& [zone, milliseconds] : cost.zones)
    std::printf("    %-20s %.4f ms a tick\n", zone.c_str(), milliseconds / ticks);
  std::printf("    %-20s %.4f ms a tick; the room's reverb and echo hold %zu kB\n", "sound",
              cost.soundMilliseconds / ticks, cost.soundBytes / 1024);
}

}  // namespace

int explain(const ExplainOptions& options) {
  const auto assets = openAssets(options.game.assets);
  if (!assets) return refuse(assets.error());
  Result<sim::GameDef> def = defOf(options.game);
  if (!def) return refuse(def.error());
  catchInterrupts();
  const audio::Bank bank;
  Faults faults;
  for (std::uint32_t passed = 0; passed < options.rooms; ++passed, ++def->firstRoom) {
    const auto simulation = openGame(**assets, *def);
    if (!simulation && passed > 0) break;  // the level has no more rooms
    if (!simulation) return refuse(simulation.error());
    Listener listener(bank);
    const RoomCost cost = playRoom((*simulation)->game(), listener);
    if (isInterrupted()) return refuse(interruption());
    print(def->firstRoom, cost);
    faults.restart();
    faults.show((*simulation)->game());
  }
  return kDone;
}

}  // namespace brittle::program
