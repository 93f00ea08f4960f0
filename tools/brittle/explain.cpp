#include <malloc.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "game/sim/constants.h"
#include "game/view/sound.h"
#include "platform/headless/headless.h"
#include "tools/bench/cpu_time.h"
#include "tools/brittle/faults.h"
#include "tools/brittle/game.h"
#include "tools/brittle/interrupt.h"
#include "tools/brittle/omissions.h"
#include "tools/brittle/picture.h"
#include "tools/brittle/progress.h"

namespace brittle::program {
namespace {

using effects::Effect;

constexpr int kPriceTicks = 600;  // of a room that the price of an effect is measured over
constexpr int kDrawEvery = 20;    // [ticks]
constexpr Size kPicture = {320, 180};

/// What so many ticks of a room took.
struct Spent {
  double milliseconds = 0.0;      // of simulation and sound
  double drawMilliseconds = 0.0;  // of the pictures
  double worst = 0.0;             // [ms] heaviest tick
  double heapBytes = 0.0;
  int ticks = 0, pictures = 0;
  std::vector<NamedCount> omissions;  // of game, pictures and sound

  double perTick() const { return milliseconds / std::max(ticks, 1); }
  double perPicture() const { return drawMilliseconds / std::max(pictures, 1); }
};

/// Who asked for an effect and how often, and what it adds to the room: against the same room with it switched off.
struct Demanded {
  Effect effect = Effect::Count;
  std::map<std::string, int> who;
  double bytes = 0.0, msPerTick = 0.0, msPerFrame = 0.0;

  int count() const {
    int sum = 0;
    for (const auto& [name, times] : who) sum += times;
    return sum;
  }
};

struct RoomCost {
  std::uint32_t room = 0;
  Spent whole;
  std::vector<Demanded> demands;
};

double heapBytes() {
  return static_cast<double>(mallinfo2().uordblks);
}

/// A game with its picture and sound, played from the beginning of a room with a throw straight ahead every second.
class Show {
 public:
  Show(runtime::Platform& platform, const content::AssetSource& assets, const audio::Bank& bank)
      : platform_(platform), assets_(assets), bank_(bank) {}

  Status play(const sim::GameDef& def, int ticks, Spent& spent, effects::EffectSet* demands, Faults* faults) {
    const double before = heapBytes();
    const auto simulation = openGame(assets_, def);
    if (!simulation) return simulation.error();
    sim::Game& game = (*simulation)->game();
    auto picture = Picture::create(platform_, 0, assets_);
    if (!picture) return picture.error();
    audio::Mixer mixer(bank_);
    view::Sound sound(mixer);
    std::vector<float> stereo(2 * audio::kSampleRate / sim::rules::kTickRate);
    const std::uint64_t room = game.roomNumber();
    while (spent.ticks < ticks && game.roomNumber() == room && !game.isOver() && !isInterrupted()) {
      replay::InputFrame input;
      if (spent.ticks % sim::rules::kTickRate == 0) input.throws.push_back({0, 0});
      const double start = cpuMilliseconds();
      game.tick(input);
      (*picture)->ticked(game);
      sound.tick((*picture)->packet());
      mixer.render(stereo);
      const double took = cpuMilliseconds() - start;
      spent.milliseconds += took;
      spent.worst = std::max(spent.worst, took);
      if (spent.ticks++ % kDrawEvery == 0) draw(game, **picture, spent);
      if (demands != nullptr && game.roomNumber() == room) *demands = game.effects();
    }
    spent.heapBytes = heapBytes() - before;
    spent.omissions = game.omissions();
    addUp(spent.omissions, (*picture)->omissions());
    addUp(spent.omissions, sound.omissions());
    if (faults != nullptr) faults->show(game);
    return Done{};
  }

 private:
  static void draw(sim::Game& game, Picture& picture, Spent& spent) {
    const double start = cpuMilliseconds();
    picture.draw(game, {.size = {kPicture.width, kPicture.height}});
    picture.readBack();  // waits for it
    spent.drawMilliseconds += cpuMilliseconds() - start;
    ++spent.pictures;
  }

  runtime::Platform& platform_;
  const content::AssetSource& assets_;
  const audio::Bank& bank_;
};

std::vector<Demanded> demandsOf(const effects::EffectSet& set) {
  std::vector<Demanded> demands;
  for (std::size_t i = 0; i < effects::kEffects; ++i) {
    const auto effect = static_cast<Effect>(i);
    if (!set.has(effect)) continue;
    demands.push_back({});
    demands.back().effect = effect;
    for (const effects::Demand& demand : set.demands())
      if (demand.effect == effect) ++demands.back().who[demand.who];
  }
  return demands;
}

Status addPrices(Show& show, sim::GameDef def, RoomCost& cost, Progress& progress, std::uint32_t& step) {
  Spent all;
  if (const Status played = show.play(def, kPriceTicks, all, nullptr, nullptr); !played) return played;
  const effects::EffectMask off = def.without;
  for (Demanded& demand : cost.demands) {
    if (isInterrupted()) break;
    Spent less;
    def.without = off.with(demand.effect);
    if (const Status played = show.play(def, kPriceTicks, less, nullptr, nullptr); !played) return played;
    demand.bytes = all.heapBytes - less.heapBytes;
    demand.msPerTick = all.perTick() - less.perTick();
    demand.msPerFrame = all.perPicture() - less.perPicture();
    progress.reached(++step);
  }
  return Done{};
}

void print(const RoomCost& cost) {
  std::printf("room %u: %.3f ms a tick (heaviest %.2f), %.2f ms a picture of %d x %d; %d ticks with a throw a second\n",
              cost.room, cost.whole.perTick(), cost.whole.worst, cost.whole.perPicture(), kPicture.width,
              kPicture.height, cost.whole.ticks);
  std::printf("  %-15s %8s %9s %9s  %s\n", "effect", "kB", "ms/tick", "ms/frame", "demanded by");
  for (const Demanded& demand : cost.demands) {
    std::string who = demand.who.begin()->first;
    if (demand.who.size() > 1) who += " and " + std::to_string(demand.who.size() - 1) + " more";
    std::printf("  %-15s %8.1f %9.4f %9.4f  %s, %d times\n", effects::nameOf(demand.effect), demand.bytes / 1024.0,
                demand.msPerTick, demand.msPerFrame, who.c_str(), demand.count());
  }
  std::string none;
  for (std::size_t i = 0; i < effects::kEffects; ++i) {
    const auto effect = static_cast<Effect>(i);
    const auto is = [=](const Demanded& demand) { return demand.effect == effect; };
    if (std::none_of(cost.demands.begin(), cost.demands.end(), is))
      none += (none.empty() ? "" : ", ") + std::string(effects::nameOf(effect));
  }
  if (!none.empty()) std::printf("  nobody demands %s\n", none.c_str());
  if (!cost.whole.omissions.empty()) std::printf("  left out: %s\n", inWords(cost.whole.omissions).c_str());
}

/// A text of the content as JSON has it.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out + "\"";
}

void printJson(const std::vector<RoomCost>& rooms) {
  std::printf("[");
  for (const RoomCost& cost : rooms) {
    std::printf(
        "%s\n  {\"room\": %u, \"ms_per_tick\": %.4f, \"heaviest_ms\": %.3f, \"ms_per_frame\": %.4f, \"effects\": [",
        &cost == rooms.data() ? "" : ",", cost.room, cost.whole.perTick(), cost.whole.worst, cost.whole.perPicture());
    for (const Demanded& demand : cost.demands) {
      std::printf(
          "%s\n    {\"effect\": \"%s\", \"bytes\": %.0f, \"ms_per_tick\": %.4f, \"ms_per_frame\": %.4f, "
          "\"demanded_by\": {",
          &demand == cost.demands.data() ? "" : ",", effects::nameOf(demand.effect), demand.bytes, demand.msPerTick,
          demand.msPerFrame);
      for (auto it = demand.who.begin(); it != demand.who.end(); ++it)
        std::printf("%s%s: %d", it == demand.who.begin() ? "" : ", ", quoted(it->first).c_str(), it->second);
      std::printf("}}");
    }
    std::printf("],\n    \"left_out\": %s}", inJson(cost.whole.omissions).c_str());
  }
  std::printf("\n]\n");
}

/// With a driver that draws in this thread, so that its work is counted; without one pictures cost what handing them
/// over costs.
Result<std::unique_ptr<platform::Headless>> makePlatform() {
  setenv("LP_NUM_THREADS", "0", 1);
  const runtime::PictureSize size = {kPicture.width, kPicture.height};
  auto made = platform::createHeadless(platform::HeadlessBackend::Egl, size);
  return made ? std::move(made) : platform::createHeadless(platform::HeadlessBackend::Null, size);
}

}  // namespace

int explain(const ExplainOptions& options) {
  const auto assets = openAssets(options.game.assets);
  if (!assets) return refuse(assets.error());
  Result<sim::GameDef> def = defOf(options.game);
  if (!def) return refuse(def.error());
  const auto platform = makePlatform();
  if (!platform) return refuse(platform.error());
  catchInterrupts();
  const audio::Bank bank;
  Show show(**platform, **assets, bank);
  Faults faults;
  std::vector<RoomCost> rooms;
  Progress progress("measuring", options.rooms * static_cast<std::uint32_t>(effects::kEffects));
  for (std::uint32_t passed = 0; passed < options.rooms; ++passed, ++def->firstRoom) {
    RoomCost cost;
    cost.room = def->firstRoom;
    effects::EffectSet demands;
    faults.restart();
    const Status played = show.play(*def, sim::rules::kRoomTicks, cost.whole, &demands, &faults);
    if (!played && passed > 0) break;  // the level has no more rooms
    if (!played) return refuse(played.error());
    cost.demands = demandsOf(demands);
    std::uint32_t step = passed * static_cast<std::uint32_t>(effects::kEffects);
    if (const Status priced = addPrices(show, *def, cost, progress, step); !priced) return refuse(priced.error());
    if (isInterrupted()) return refuse(interruption());
    if (!options.json) print(cost);
    rooms.push_back(std::move(cost));
  }
  if (options.json) printJson(rooms);
  return kDone;
}

}  // namespace brittle::program
