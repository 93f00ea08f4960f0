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
#include "tools/brittle/price.h"
#include "tools/brittle/progress.h"

namespace brittle::program {
namespace {

using effects::Effect;

constexpr int kPriceTicks = 600;  // of a room that the price of an effect is measured over
constexpr int kDrawEvery = 20;    // [ticks]
constexpr Size kPicture = {320, 180};
constexpr auto kMostSteps = static_cast<std::uint32_t>(effects::kEffects) + 2;  // a room is measured in

/// Who asked for an effect and how often, and what it adds to the room: against the same room with it switched off.
struct Demanded {
  Effect effect = Effect::Count;
  std::map<std::string, int> who;
  Prices prices;

  int count() const {
    int sum = 0;
    for (const auto& [name, times] : who) sum += times;
    return sum;
  }
};

double heaviest(const Spent& spent) {
  double most = 0.0;
  for (const double tick : spent.ticks) most = std::max(most, tick);
  return most;
}

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
    for (int tick = 0; tick < ticks && game.roomNumber() == room && !game.isOver() && !isInterrupted(); ++tick) {
      replay::InputFrame input;
      if (tick % sim::rules::kTickRate == 0) input.throws.push_back({0, 0});
      const double start = cpuMilliseconds();
      game.tick(input);
      (*picture)->ticked(game);
      sound.tick((*picture)->packet());
      mixer.render(stereo);
      spent.ticks.push_back(cpuMilliseconds() - start);
      if (tick % kDrawEvery == 0) draw(game, **picture, spent);
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
    spent.pictures.push_back(cpuMilliseconds() - start);
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

Status addPrices(Show& show, sim::GameDef def, RoomCost& cost, Progress& progress, std::uint32_t step) {
  const effects::EffectMask off = def.without;
  std::vector<Spent> played(cost.demands.size() + 2);  // the whole, less each of them, the whole again
  for (std::size_t i = 0; i < played.size() && !isInterrupted(); ++i) {
    const bool isWhole = i == 0 || i > cost.demands.size();
    def.without = isWhole ? off : off.with(cost.demands[i - 1].effect);
    if (const Status shown = show.play(def, kPriceTicks, played[i], nullptr, nullptr); !shown) return shown;
    progress.reached(++step);
  }
  for (std::size_t i = 0; i < cost.demands.size(); ++i)
    cost.demands[i].prices = pricesOf(played.front(), played[i + 1], played.back());
  return Done{};
}

void print(const RoomCost& cost) {
  std::printf(
      "room %u: %.3f ms a tick (heaviest %.2f), %.2f ms a picture of %d x %d; %zu ticks with a throw a second\n",
      cost.room, meanOf(cost.whole.ticks), heaviest(cost.whole), meanOf(cost.whole.pictures), kPicture.width,
      kPicture.height, cost.whole.ticks.size());
  std::printf("  %-15s %9s %9s %9s  %s\n", "effect", "kB", "ms/tick", "ms/frame", "demanded by");
  for (const Demanded& demand : cost.demands) {
    std::string who = demand.who.begin()->first;
    if (demand.who.size() > 1) who += " and " + std::to_string(demand.who.size() - 1) + " more";
    std::printf("  %-15s %9s %9s %9s  %s, %d time%s\n", effects::nameOf(demand.effect),
                inWords(demand.prices.bytes, 1024.0, 1).c_str(), inWords(demand.prices.msPerTick, 1.0, 3).c_str(),
                inWords(demand.prices.msPerFrame, 1.0, 2).c_str(), who.c_str(), demand.count(),
                demand.count() == 1 ? "" : "s");
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
        &cost == rooms.data() ? "" : ",", cost.room, meanOf(cost.whole.ticks), heaviest(cost.whole),
        meanOf(cost.whole.pictures));
    for (const Demanded& demand : cost.demands) {
      std::printf(
          "%s\n    {\"effect\": \"%s\", \"bytes\": %.0f, \"bytes_noise\": %.0f, \"ms_per_tick\": %.4f, "
          "\"ms_per_tick_noise\": %.4f, \"ms_per_frame\": %.4f, \"ms_per_frame_noise\": %.4f, \"demanded_by\": {",
          &demand == cost.demands.data() ? "" : ",", effects::nameOf(demand.effect), demand.prices.bytes.value,
          demand.prices.bytes.noise, demand.prices.msPerTick.value, demand.prices.msPerTick.noise,
          demand.prices.msPerFrame.value, demand.prices.msPerFrame.noise);
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
  Progress progress("measuring", options.rooms * kMostSteps);
  for (std::uint32_t passed = 0; passed < options.rooms; ++passed, ++def->firstRoom) {
    RoomCost cost;
    cost.room = def->firstRoom;
    effects::EffectSet demands;
    faults.restart();
    const Status played = show.play(*def, sim::rules::kRoomTicks, cost.whole, &demands, &faults);
    if (!played && passed > 0) break;  // the level has no more rooms
    if (!played) return refuse(played.error());
    cost.demands = demandsOf(demands);
    const Status priced = addPrices(show, *def, cost, progress, passed * kMostSteps);
    if (!priced) return refuse(priced.error());
    if (isInterrupted()) return refuse(interruption());
    if (!options.json) print(cost);
    progress.reached((passed + 1) * kMostSteps);
    rooms.push_back(std::move(cost));
  }
  if (options.json) printJson(rooms);
  return kDone;
}

}  // namespace brittle::program
