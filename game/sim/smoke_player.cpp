// The calls of smoke scripts that play by what is seen.
#include <optional>

#include "engine/script/call.h"
#include "game/sim/constants.h"
#include "game/sim/smoke_state.h"

namespace brittle::sim {

namespace {

template <class Value>
void addFact(script::Library& library, const char* name, Value (*fact)(const Game&)) {
  library.add(name, [fact](script::Call& call) {
    const Game* game = call.user<Smoke>().game(call);
    if (game != nullptr) call.result(script::Value(fact(*game)));
  });
}

void look(script::Call& call, Smoke& smoke) {
  const Game* game = smoke.game(call);
  if (game == nullptr) return;
  game->look(smoke.sights);
  call.result(static_cast<int>(smoke.sights.size()));
}

const char* nameOf(SightKind kind) {
  if (kind == SightKind::Crystal) return "crystal";
  if (kind == SightKind::PowerUp) return "power-up";
  return kind == SightKind::Threat ? "threat" : "button";
}

void seen(script::Call& call, Smoke& smoke) {
  const int number = call.integer(1);
  if (call.failed()) return;
  if (number < 1 || number > static_cast<int>(smoke.sights.size()))
    return call.fail("sight " + std::to_string(number) + ": expected 1 to " + std::to_string(smoke.sights.size()));
  const Sight& sight = smoke.sights[static_cast<std::size_t>(number) - 1];
  call.result(nameOf(sight.kind));
  for (int i = 0; i < 3; ++i) call.result(sight.position[i]);
  for (int i = 0; i < 3; ++i) call.result(sight.velocity[i]);
  call.result(static_cast<double>(sight.id));
  call.result(sight.clear);
  call.result(sight.aside);
  call.result(sight.gives);
  call.result(sight.type);
  call.result(sight.center.x());
}

/// Of the kind that argument 1 names; null, with the call failed, if it names none.
const PowerUpView* heldAt(script::Call& call, Smoke& smoke) {
  static const PowerUpView none;
  const std::string name = call.string(1);
  if (call.failed()) return nullptr;
  const std::optional<PowerUp> kind = powerUpNamed(name);
  if (!kind) call.fail("power-up " + name + ": expected ballfrenzy, slowmotion, nitroballs or barrel");
  const Game* game = call.failed() ? nullptr : smoke.game(call);
  if (game == nullptr) return nullptr;
  for (const PowerUpView& held : game->hud().powerUps)
    if (held.kind == *kind) return &held;
  return &none;
}

void powerUps(script::Call& call, Smoke& smoke) {
  const PowerUpView* held = heldAt(call, smoke);
  if (held == nullptr) return;
  call.result(held->count);
  call.result(held->left);
}

void use(script::Call& call, Smoke& smoke) {
  const PowerUpView* held = heldAt(call, smoke);
  if (held == nullptr) return;
  if (held->count == 0) return call.fail("there is none to use");
  const std::vector<PowerUpView>& all = smoke.game(call)->hud().powerUps;
  smoke.useAt(smoke.game(call)->tickCount(), static_cast<int>(held - all.data()));
}

void setting(script::Call& call, Smoke& smoke) {
  const std::string name = call.string(1);
  const std::string otherwise = call.string(2);
  if (call.failed()) return;
  smoke.result.asked.insert(name);
  const auto found = smoke.settings.values.find(name);
  call.result(script::Value(found == smoke.settings.values.end() ? otherwise : found->second));
}

}  // namespace

void addPlayerCalls(script::Library& library) {
  addFact<double>(library, "tick", [](const Game& g) { return static_cast<double>(g.tickCount()); });
  addFact<int>(library, "balls", [](const Game& g) { return static_cast<int>(g.hud().balls); });
  addFact<int>(library, "streak", [](const Game& g) { return static_cast<int>(g.hud().streak); });
  addFact<int>(library, "balls_per_throw", [](const Game& g) { return static_cast<int>(g.hud().ballsPerThrow); });
  addFact<int>(library, "room_number", [](const Game& g) { return static_cast<int>(g.hud().room); });
  addFact<float>(library, "speed", [](const Game& g) { return g.camera().velocity.norm(); });
  addFact<float>(library, "gravity", [](const Game& g) { return g.gravity(); });
  addFact<float>(library, "time_share", [](const Game& g) { return g.timeShare(); });
  addFact<const char*>(library, "phase", [](const Game& g) { return nameOf(g.hud().phase); });
  addSmokeCall(library, "look", look);
  addSmokeCall(library, "seen", seen);
  addSmokeCall(library, "power_ups", powerUps);
  addSmokeCall(library, "use", use);
  addSmokeCall(library, "setting", setting);
}

}  // namespace brittle::sim
