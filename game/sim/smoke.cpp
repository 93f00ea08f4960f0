#include "game/sim/smoke.h"

#include <cstdio>

#include "engine/script/sandbox.h"

namespace brittle::sim {

namespace {

/// Named arguments are tables, which stay inside Lua: unpacked here into plain numbers.
constexpr const char* kPrelude = R"(
function throw(t) smokeThrow(t.tick or -1, t.x or 0, t.y or 0) end
function expect_position(t) smokePosition(t.z, t.within or 0.01) end
function expect_speed(t) smokeSpeed(t.v, t.within or 0.01) end
)";

constexpr std::uint64_t kLongestRun = 200'000;  // [ticks]: nearly an hour of play

class Smoke {
 public:
  Smoke(const content::AssetSource& assets, const std::string& name, const physics::Accuracy& accuracy)
      : assets_(assets), name_(name) {
    result.def.accuracy = accuracy;
  }

  bool started() const { return game_ != nullptr; }
  /// The game, made at the first call that needs it; null, with the call failed, if that does not work.
  Game* game(script::Call& call) {
    if (game_) return game_.get();
    Result<std::unique_ptr<Game>> made = Game::create(assets_, result.def);
    if (!made) {
      call.fail(made.error().message);
      return nullptr;
    }
    game_ = std::move(*made);
    return game_.get();
  }
  void throwAt(std::uint64_t tick, const replay::Throw& aim) {
    if (throws_.size() <= tick) throws_.resize(tick + 1);
    throws_[tick].push_back(aim);
  }
  void run(Game& game, std::uint64_t until) {
    while (game.tickCount() < until) {
      replay::InputFrame frame;
      if (game.tickCount() < throws_.size()) frame.throws = throws_[game.tickCount()];
      result.inputs.push_back(frame);
      game.tick(frame);
    }
  }
  bool saveAndRestore(Game& game) {
    ByteWriter out;
    game.save(out);
    const std::uint64_t before = game.stateHash();
    Result<std::unique_ptr<Game>> fresh = Game::create(assets_, result.def);
    ByteReader in(out.bytes());
    if (!fresh || !(*fresh)->restore(in) || (*fresh)->stateHash() != before) return false;
    game_ = std::move(*fresh);
    return true;
  }
  void check(script::Call& call, const char* what, bool holds, const std::string& found, const std::string& expected) {
    ++result.checks;
    if (holds) return;
    const std::string place = call.file() == name_ ? call.where() : name_;
    result.failures.push_back({game_->tickCount(), place + ": " + what + ": " + found + ", expected " + expected});
  }
  void finish() {
    if (!game_) return;
    result.ticks = game_->tickCount();
    result.stateHash = game_->stateHash();
    for (const Problem& problem : game_->problems()) result.problems.push_back(problem.text);
  }

  SmokeResult result;

 private:
  const content::AssetSource& assets_;
  std::string name_;
  std::unique_ptr<Game> game_;
  std::vector<std::vector<replay::Throw>> throws_;
};

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof(buffer), "%.6g", value);
  return buffer;
}

using Native = void (*)(script::Call&, Smoke&);

void add(script::Library& library, const char* name, Native native) {
  library.add(name, [native](script::Call& call) { native(call, call.user<Smoke>()); });
}

/// A count between arguments 1 and 2 (the same if there is no second).
void expectRange(script::Call& call, Smoke& smoke, const char* what, double (*count)(const Game&)) {
  const double least = call.number(1);
  const double most = call.number(2, least);
  if (call.failed()) return;
  Game* game = smoke.game(call);
  if (game == nullptr) return;
  const double found = count(*game);
  smoke.check(call, what, found >= least && found <= most, text(found), least == most ? text(least) : text(least) + " to " + text(most));
}

/// A value within argument 2 of argument 1.
void expectNear(script::Call& call, Smoke& smoke, const char* what, double (*value)(const Game&)) {
  const double wanted = call.number(1);
  const double within = call.number(2);
  if (call.failed()) return;
  Game* game = smoke.game(call);
  if (game == nullptr) return;
  const double found = value(*game);
  smoke.check(call, what, found >= wanted - within && found <= wanted + within, text(found), text(wanted) + " within " + text(within));
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
  if (at < now || at > kLongestRun) return call.fail("tick " + text(tick) + ": expected " + text(static_cast<double>(now)) + " or later");
  smoke.throwAt(at, replay::quantizeAim(x, y));
}

/// Plays until the tick of argument 1; false if the call failed.
Game* runTo(script::Call& call, Smoke& smoke) {
  const double tick = call.number(1);
  if (call.failed()) return nullptr;
  if (!(tick >= 0.0 && tick <= static_cast<double>(kLongestRun))) call.fail("tick " + text(tick) + ": expected 0 to " + text(kLongestRun));
  Game* game = call.failed() ? nullptr : smoke.game(call);
  if (game != nullptr) smoke.run(*game, static_cast<std::uint64_t>(tick));
  return game;
}

void restoreAt(script::Call& call, Smoke& smoke) {
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
  add(library, "level", [](script::Call& call, Smoke& s) {
    const std::string name = call.string(1);
    if (s.started()) return call.fail("the game has begun already");
    if (!call.failed()) s.result.def.level = name;
  });
  add(library, "seed", [](script::Call& call, Smoke& s) {
    const int number = call.integer(1);
    if (s.started()) return call.fail("the game has begun already");
    if (!call.failed()) s.result.def.seed = static_cast<std::uint64_t>(number);
  });
  add(library, "room", [](script::Call& call, Smoke& s) {
    const int number = call.integer(1);
    if (s.started()) return call.fail("the game has begun already");
    if (!call.failed()) s.result.def.firstRoom = static_cast<std::uint32_t>(number);
  });
  add(library, "mode", chooseMode);
}

void addExpectations(script::Library& library) {
  add(library, "expect_broken", [](script::Call& call, Smoke& s) {
    expectRange(call, s, "expect_broken", [](const Game& g) { return static_cast<double>(g.totalBreaks()); });
  });
  add(library, "expect_balls", [](script::Call& call, Smoke& s) {
    expectRange(call, s, "expect_balls", [](const Game& g) { return static_cast<double>(g.hud().balls); });
  });
  add(library, "expect_crashes", [](script::Call& call, Smoke& s) {
    expectRange(call, s, "expect_crashes", [](const Game& g) { return static_cast<double>(g.totalCrashes()); });
  });
  add(library, "expect_streak", [](script::Call& call, Smoke& s) {
    expectRange(call, s, "expect_streak", [](const Game& g) { return static_cast<double>(g.hud().streak); });
  });
  add(library, "expect_room", [](script::Call& call, Smoke& s) {
    expectRange(call, s, "expect_room", [](const Game& g) { return static_cast<double>(g.roomNumber()); });
  });
  add(library, "smokePosition", [](script::Call& call, Smoke& s) {
    expectNear(call, s, "expect_position", [](const Game& g) { return static_cast<double>(g.roomDistance()); });
  });
  add(library, "smokeSpeed", [](script::Call& call, Smoke& s) {
    expectNear(call, s, "expect_speed", [](const Game& g) { return static_cast<double>(g.camera().velocity.norm()); });
  });
  add(library, "expect_problems", [](script::Call& call, Smoke& s) {
    const double most = call.number(1);
    Game* game = call.failed() ? nullptr : s.game(call);
    if (game == nullptr) return;
    const auto& problems = game->problems();
    const double found = static_cast<double>(problems.size());
    s.check(call, "expect_problems", found <= most, problems.empty() ? "none" : text(found) + " (" + problems.front().text + ")",
            "at most " + text(most));
  });
  add(library, "expect_finite", [](script::Call& call, Smoke& s) {
    Game* game = s.game(call);
    if (game == nullptr) return;
    const double found = game->totalQuarantined();
    s.check(call, "expect_finite", found == 0.0, text(found) + " bodies removed", "none");
  });
}

const script::Library& smokeLibrary() {
  static const script::Library library = [] {
    script::Library made;
    addSetup(made);
    addExpectations(made);
    add(made, "smokeThrow", throwBall);
    add(made, "run", [](script::Call& call, Smoke& s) { runTo(call, s); });
    add(made, "restore_at", restoreAt);
    return made;
  }();
  return library;
}

}  // namespace

SmokeResult runSmoke(const content::AssetSource& assets, const std::string& name, const std::string& source,
                     const physics::Accuracy& accuracy) {
  Smoke smoke(assets, name, accuracy);
  script::Sandbox sandbox(smokeLibrary(), 0, {}, &smoke);
  const Status prelude = sandbox.load(kPrelude, "smoke prelude");
  BR_ASSERT(static_cast<bool>(prelude));
  const Status loaded = sandbox.load(source, name);
  smoke.finish();
  if (!loaded) smoke.result.failures.push_back({smoke.result.ticks, loaded.error().message});
  if (loaded && smoke.result.checks == 0) smoke.result.failures.push_back({smoke.result.ticks, name + ": expects nothing"});
  return std::move(smoke.result);
}

}  // namespace brittle::sim
