// Any bytes as a room's script, in a level with one segment: the game starts or says why not, plays, can be saved and
// taken up again (a game whose script made functions while it ran says no instead).
#include <string>

#include "engine/core/assert.h"
#include "engine/core/byte_stream.h"
#include "engine/core/log.h"
#include "game/content/asset_source.h"
#include "game/sim/game.h"
#include "tests/fuzz/target.h"

namespace {

using namespace brittle;

content::MemorySource assetsAround(const std::string& script) {
  content::MemorySource assets;
  assets.add("levels/test.xml", "<level><room type=\"test/room\" length=\"100\"/></level>");
  assets.add("rooms/test/room.lua", script);
  assets.add("segments/test/hall.xml",
             "<segment size=\"12 10 16\"><box pos=\"0 -1.2 -8\" size=\"5 .2 8\"/>"
             "<obstacle pos=\"0 0 -9\" type=\"glass\"/></segment>");
  assets.add("obstacles/glass.lua",
             "function init() mgMaterial('glass') mgStatic(1) b = mgCreateBody(0,0,0) "
             "mgCreateBox(b, 1, 1, .02) end");
  return assets;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const bool quiet = (setLogSink([](LogLevel, std::string_view) {}), true);
  (void)quiet;
  const content::MemorySource assets = assetsAround(std::string(reinterpret_cast<const char*>(data), size));
  sim::GameDef def;
  def.level = "test";
  const Result<std::unique_ptr<sim::Game>> made = sim::Game::create(assets, def);
  if (!made) return 0;
  sim::Game& game = **made;
  for (int tick = 0; tick < 3; ++tick) game.tick({});
  BR_ASSERT(game.totalQuarantined() == 0);
  ByteWriter saved;
  game.save(saved);
  ByteReader in(saved.bytes());
  const std::uint64_t hash = game.stateHash();
  if (game.restore(in)) BR_ASSERT(game.stateHash() == hash);
  return 0;
}
