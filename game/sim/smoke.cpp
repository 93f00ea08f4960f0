#include "game/sim/smoke.h"

#include <cstdio>

#include "engine/core/random.h"
#include "engine/script/sandbox.h"
#include "game/sim/smoke_state.h"

namespace brittle::sim {

namespace {

/// Named arguments are tables, which stay inside Lua: unpacked here into plain numbers.
constexpr const char* kPrelude = R"(
local throwAt, positionIs, speedIs = throw, expect_position, expect_speed
function throw(t) throwAt(t.tick or -1, t.x or 0, t.y or 0) end
function expect_position(t) positionIs(t.z, t.within or 0.01) end
function expect_speed(t) speedIs(t.v, t.within or 0.01) end
)";

constexpr std::int64_t kInstructions = 500'000'000;  // of a script: a player that looks ten times a second for hours

/// A count between arguments 1 and 2 (the same if there is no second).
void expectRange(script::Call& call, Smoke& smoke, const char* what, double (*count)(const Game&)) {
  const double least = call.number(1);
  const double most = call.number(2, least);
  if (call.failed()) return;
  Game* game = smoke.game(call);
  if (game == nullptr) return;
  const double found = count(*game);
  smoke.check(call, what, found >= least && found <= most, smokeText(found),
              least == most ? smokeText(least) : smokeText(least) + " to " + smokeText(most));
}

/// A value within argument 2 of argument 1.
void expectNear(script::Call& call, Smoke& smoke, const char* what, double (*value)(const Game&)) {
  const double wanted = call.number(1);
  const double within = call.number(2);
  if (call.failed()) return;
  Game* game = smoke.game(call);
  if (game == nullptr) return;
  const double found = value(*game);
  smoke.check(call, what, found >= wanted - within && found <= wanted + within, smokeText(found),
              smokeText(wanted) + " within " + smokeText(within));
}

void throwBall(script::Call& call, Smoke& smoke) {
  const double tick = call.number(1);
  const float x = call.real(2);
  const float y = call.real(3);
  if (call.failed()) return;
  Game* game = smoke.game(call);
  if (game == nullptr) return;
  const std::uint64_t now = game->tickCount();
  const std::uint64_t at = tick < 0.0 ? now : static_cast<std::uint64_t>(tick);
  if (at < now || at > kLongestRun)
    return call.fail("tick " + smokeText(tick) + ": expected " + smokeText(static_cast<double>(now)) + " or later");
  if (!smoke.throwAt(at, replay::quantizeAim(x, y)))
    call.fail("tick " + smokeText(static_cast<double>(at)) + ": more than 8 throws");
}

/// Plays until the tick of argument 1; false if the call failed.
Game* runTo(script::Call& call, Smoke& smoke) {
  const double tick = call.number(1);
  if (call.failed()) return nullptr;
  if (!(tick >= 0.0 && tick <= static_cast<double>(kLongestRun)))
    call.fail("tick " + smokeText(tick) + ": expected 0 to " + smokeText(kLongestRun));
  Game* game = call.failed() ? nullptr : smoke.game(call);
  if (game != nullptr) smoke.run(*game, static_cast<std::uint64_t>(tick));
  if (smoke.isCalledOff()) call.fail("called off");
  return call.failed() ? nullptr : game;
}

void restoreAt(script::Call& call, Smoke& smoke) {
  call.charge(1'000'000);  // a whole game is written, made and read
  Game* game = runTo(call, smoke);
  if (game == nullptr) return;
  const bool same = smoke.saveAndRestore(*game);
  smoke.check(call, "restore_at", same, "another state", "the saved one");
}

void chooseMode(script::Call& call, Smoke& smoke) {
  const std::string name = call.string(1);
  const char* const names[] = {"training", "classic", "mayhem", "zen"};
  for (int i = 0; i < 4; ++i)
    if (name == names[i]) smoke.result.def.mode = static_cast<Mode>(i);
  const bool known = name == names[static_cast<int>(smoke.result.def.mode)];
  if (!known && !call.failed()) call.fail("mode \"" + name + "\": expected training, classic, mayhem or zen");
}

void addSetup(script::Library& library) {
  addSmokeCall(library, "level", [](script::Call& call, Smoke& s) {
    const std::string name = call.string(1);
    if (s.started()) return call.fail("the game has begun already");
    if (!call.failed()) s.result.def.level = name;
  });
  addSmokeCall(library, "seed", [](script::Call& call, Smoke& s) {
    const int number = call.integer(1);
    if (s.started()) return call.fail("the game has begun already");
    if (call.failed() || s.settings.seed) return;
    s.result.def.seed = static_cast<std::uint64_t>(number);
    call.random() = Random(s.result.def.seed);
  });
  addSmokeCall(library, "room", [](script::Call& call, Smoke& s) {
    const int number = call.integer(1);
    if (s.started()) return call.fail("the game has begun already");
    if (!call.failed()) s.result.def.firstRoom = static_cast<std::uint32_t>(number);
  });
  addSmokeCall(library, "mode", chooseMode);
}

/// What the game let be seen and heard so far.
void expectEvents(script::Call& call, Smoke& smoke) {
  const std::string name = call.string(1);
  const double least = call.number(2);
  const double most = call.number(3, 1e9);
  Game* game = call.failed() ? nullptr : smoke.game(call);
  if (game == nullptr) return;
  if (name != "splash" && name != "smoke") return call.fail("\"" + name + "\": expected splash or smoke");
  const double found = smoke.eventsOf(name == "splash" ? EventType::Splash : EventType::Smoke);
  smoke.check(call, "expect_events", least <= found && found <= most, smokeText(found) + " of " + name,
              smokeText(least) + (call.has(3) ? " to " + smokeText(most) : " or more"));
}

void addExpectations(script::Library& library) {
  addSmokeCall(library, "expect_events", expectEvents);
  addSmokeCall(library, "expect_broken", [](script::Call& call, Smoke& s) {
    expectRange(call, s, "expect_broken", [](const Game& g) { return static_cast<double>(g.totalBreaks()); });
  });
  addSmokeCall(library, "expect_balls", [](script::Call& call, Smoke& s) {
    expectRange(call, s, "expect_balls", [](const Game& g) { return static_cast<double>(g.hud().balls); });
  });
  addSmokeCall(library, "expect_crashes", [](script::Call& call, Smoke& s) {
    expectRange(call, s, "expect_crashes", [](const Game& g) { return static_cast<double>(g.totalCrashes()); });
  });
  addSmokeCall(library, "expect_streak", [](script::Call& call, Smoke& s) {
    expectRange(call, s, "expect_streak", [](const Game& g) { return static_cast<double>(g.hud().streak); });
  });
  addSmokeCall(library, "expect_crystals", [](script::Call& call, Smoke& s) {
    expectRange(call, s, "expect_crystals", [](const Game& g) { return static_cast<double>(g.totalCrystals()); });
  });
  addSmokeCall(library, "expect_cleared", [](script::Call& call, Smoke& s) {
    expectRange(call, s, "expect_cleared", [](const Game& g) { return static_cast<double>(g.totalCleared()); });
  });
  addSmokeCall(library, "expect_phase", [](script::Call& call, Smoke& s) {
    const std::string wanted = call.string(1);
    Game* game = call.failed() ? nullptr : s.game(call);
    if (game == nullptr) return;
    const std::string found = nameOf(game->hud().phase);
    s.check(call, "expect_phase", found == wanted, found, wanted);
  });
  addSmokeCall(library, "expect_room", [](script::Call& call, Smoke& s) {
    expectRange(call, s, "expect_room", [](const Game& g) { return static_cast<double>(g.roomNumber()); });
  });
  addSmokeCall(library, "expect_position", [](script::Call& call, Smoke& s) {
    expectNear(call, s, "expect_position", [](const Game& g) { return static_cast<double>(g.roomDistance()); });
  });
  addSmokeCall(library, "expect_speed", [](script::Call& call, Smoke& s) {
    expectNear(call, s, "expect_speed", [](const Game& g) { return static_cast<double>(g.camera().velocity.norm()); });
  });
  addSmokeCall(library, "expect_problems", [](script::Call& call, Smoke& s) {
    const double most = call.number(1);
    Game* game = call.failed() ? nullptr : s.game(call);
    if (game == nullptr) return;
    const auto& problems = game->problems();
    const double found = static_cast<double>(problems.size());
    s.check(call, "expect_problems", found <= most,
            problems.empty() ? "none" : smokeText(found) + " (" + problems.front().text + ")",
            "at most " + smokeText(most));
  });
  addSmokeCall(library, "expect_explosions", [](script::Call& call, Smoke& s) {
    expectRange(call, s, "expect_explosions", [](const Game& g) { return static_cast<double>(g.totalExplosions()); });
  });
  addSmokeCall(library, "expect_power_ups", [](script::Call& call, Smoke& s) {
    const std::string name = call.string(1);
    const double wanted = call.number(2);
    Game* game = call.failed() ? nullptr : s.game(call);
    if (game == nullptr) return;
    double found = 0.0;
    for (const PowerUpView& held : game->hud().powerUps)
      if (name == nameOf(held.kind)) found = held.count;
    s.check(call, "expect_power_ups", found == wanted, smokeText(found) + " " + name, smokeText(wanted));
  });
  addSmokeCall(library, "expect_finite", [](script::Call& call, Smoke& s) {
    Game* game = s.game(call);
    if (game == nullptr) return;
    const double found = game->totalQuarantined();
    s.check(call, "expect_finite", found == 0.0, smokeText(found) + " bodies removed", "none");
  });
}

const script::Library& smokeLibrary() {
  static const script::Library library = [] {
    script::Library made;
    addSetup(made);
    addExpectations(made);
    addPlayerCalls(made);
    addSmokeCall(made, "throw", throwBall);
    addSmokeCall(made, "run", [](script::Call& call, Smoke& s) { runTo(call, s); });
    addSmokeCall(made, "restore_at", restoreAt);
    return made;
  }();
  return library;
}

}  // namespace

std::string smokeText(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof(buffer), "%.6g", value);
  return buffer;
}

SmokeResult runSmoke(const content::AssetSource& assets, const std::string& name, const std::string& source,
                     const SmokeSettings& settings) {
  Smoke smoke(assets, settings);
  script::Limits limits;
  limits.instructions = kInstructions;
  script::Sandbox sandbox(smokeLibrary(), smoke.result.def.seed, limits, &smoke);
  const Status prelude = sandbox.load(kPrelude, "");
  BR_ASSERT(static_cast<bool>(prelude));
  const Status loaded = sandbox.load(source, name);
  smoke.finish();
  if (!loaded) smoke.result.failures.push_back({smoke.result.ticks, loaded.error().message});
  if (loaded && smoke.result.checks == 0)
    smoke.result.failures.push_back({smoke.result.ticks, name + ": expects nothing"});
  return std::move(smoke.result);
}

}  // namespace brittle::sim
