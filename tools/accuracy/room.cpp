#include "tools/accuracy/room.h"

#include "game/sim/smoke.h"
#include "tools/bench/cpu_time.h"

namespace brittle::accuracy {

Result<std::unique_ptr<Room>> Room::record(const std::string& assets, int ticks) {
  std::unique_ptr<Room> room(new Room(assets));
  const Result<std::string> script = room->assets_.read("player.lua");
  if (!script) return script.error();
  int asked = 0;
  sim::SmokeSettings settings;
  settings.isCalledOff = [&] { return asked++ >= ticks; };
  sim::SmokeResult result = sim::runSmoke(room->assets_, "player.lua", *script, settings);
  if (result.inputs.empty()) return Error{"player.lua: nothing was played"};
  room->inputs_ = std::move(result.inputs);
  return room;
}

Result<RoomPlay> Room::play(const physics::Accuracy& accuracy) const {
  sim::GameDef def;
  def.accuracy = accuracy;
  Result<std::unique_ptr<sim::Game>> game = sim::Game::create(assets_, def);
  if (!game) return game.error();
  RoomPlay play;
  for (const replay::InputFrame& input : inputs_) {
    const double before = cpuMilliseconds();
    (*game)->tick(input);
    play.tickMs.push_back(cpuMilliseconds() - before);
  }
  play.breaks = (*game)->totalBreaks();
  play.cleared = (*game)->totalCleared();
  return play;
}

}  // namespace brittle::accuracy
