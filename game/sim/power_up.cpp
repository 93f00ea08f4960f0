#include "game/sim/power_up.h"

#include <algorithm>
#include <array>

#include "engine/math/types.h"
#include "game/sim/constants.h"

namespace brittle::sim {
namespace {

constexpr std::size_t kKinds = static_cast<std::size_t>(PowerUp::Count);

struct Info {
  const char* name;
  std::optional<effects::Effect> effect;
  std::int32_t ticks;
};

constexpr std::array<Info, kKinds> kInfos = {{
    {"ballfrenzy", std::nullopt, rules::kFrenzyTicks},
    {"slowmotion", effects::Effect::SlowMotion, rules::kSlowTicks},
    {"nitroballs", effects::Effect::Explosions, rules::kNitroTicks},
    {"barrel", effects::Effect::Explosions, 0},
}};

const Info& infoOf(PowerUp kind) {
  return kInfos[static_cast<std::size_t>(kind)];
}

}  // namespace

const char* nameOf(PowerUp kind) {
  return infoOf(kind).name;
}

std::optional<PowerUp> powerUpNamed(const std::string& name) {
  for (std::size_t i = 0; i < kKinds; ++i)
    if (name == kInfos[i].name) return static_cast<PowerUp>(i);
  return std::nullopt;
}

std::optional<effects::Effect> effectOf(PowerUp kind) {
  return infoOf(kind).effect;
}

std::int32_t ticksOf(PowerUp kind) {
  return infoOf(kind).ticks;
}

PowerUpSlot* Inventory::find(PowerUp kind) {
  const auto found =
      std::find_if(slots_.begin(), slots_.end(), [kind](const PowerUpSlot& s) { return s.kind == kind; });
  return found == slots_.end() ? nullptr : &*found;
}

void Inventory::dropEmpty() {
  std::erase_if(slots_, [](const PowerUpSlot& slot) { return slot.count == 0 && !slot.runs; });
}

void Inventory::collect(PowerUp kind) {
  PowerUpSlot* slot = find(kind);
  if (slot == nullptr) slot = &slots_.emplace_back(PowerUpSlot{kind});
  slot->count = minOf(slot->count + 1, rules::kMostPowerUps);
}

std::optional<PowerUp> Inventory::use(std::size_t place) {
  if (place >= slots_.size()) return std::nullopt;
  PowerUpSlot& slot = slots_[place];
  const std::int32_t ticks = ticksOf(slot.kind);
  if (slot.count == 0 || (slot.runs && ticks == 0)) return std::nullopt;
  --slot.count;
  slot.runs = true;
  slot.ticksLeft += ticks;
  slot.ticksAll = slot.ticksLeft;
  return slot.kind;
}

bool Inventory::runs(PowerUp kind) const {
  return std::any_of(slots_.begin(), slots_.end(), [kind](const PowerUpSlot& s) { return s.kind == kind && s.runs; });
}

std::int32_t Inventory::count(PowerUp kind) const {
  for (const PowerUpSlot& slot : slots_)
    if (slot.kind == kind) return slot.count;
  return 0;
}

void Inventory::finish(PowerUp kind) {
  if (PowerUpSlot* slot = find(kind)) slot->runs = false;
  dropEmpty();
}

std::vector<PowerUp> Inventory::tick() {
  std::vector<PowerUp> ended;
  for (PowerUpSlot& slot : slots_) {
    if (!slot.runs || ticksOf(slot.kind) == 0 || --slot.ticksLeft > 0) continue;
    slot.runs = false;
    slot.ticksLeft = slot.ticksAll = 0;
    ended.push_back(slot.kind);
  }
  if (!ended.empty()) dropEmpty();
  return ended;
}

void Inventory::stop() {
  for (PowerUpSlot& slot : slots_) {
    slot.runs = false;
    slot.ticksLeft = slot.ticksAll = 0;
  }
  dropEmpty();
}

bool Inventory::isValid() const {
  std::array<bool, kKinds> seen{};
  for (const PowerUpSlot& slot : slots_) {
    if (slot.kind >= PowerUp::Count || seen[static_cast<std::size_t>(slot.kind)]) return false;
    seen[static_cast<std::size_t>(slot.kind)] = true;
    const std::int32_t longest = ticksOf(slot.kind) * (rules::kMostPowerUps + 1) * rules::kMostPowerUps;
    if (slot.count < 0 || slot.count > rules::kMostPowerUps || slot.ticksLeft < 0 || slot.ticksLeft > slot.ticksAll ||
        slot.ticksAll > longest)
      return false;
  }
  return true;
}

}  // namespace brittle::sim
