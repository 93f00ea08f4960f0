#include "engine/physics/budgets.h"

#include <algorithm>

#include "engine/physics/state.h"

namespace brittle::physics {
namespace {

constexpr std::int32_t kOwnedTicks = 15;  // how long a piece spends its maker's budget (a quarter of a second)

/// Where the budget of a pair is, or would be: budgets are sorted by striker, then struck.
std::size_t budgetIndex(const State& state, BodyHandle striker, BodyHandle struck) {
  const auto isBefore = [](const Budget& budget, const Budget& key) {
    return budget.striker == key.striker ? budget.struck < key.struck : budget.striker < key.striker;
  };
  const auto it = std::lower_bound(state.budgets.begin(), state.budgets.end(), Budget{striker, struck}, isBefore);
  return static_cast<std::size_t>(it - state.budgets.begin());
}

bool isBudgetOf(const State& state, std::size_t i, BodyHandle striker, BodyHandle struck) {
  return i < state.budgets.size() && state.budgets[i].striker == striker && state.budgets[i].struck == struck;
}

}  // namespace

BodyHandle payerOf(const State& state, BodyHandle handle) {
  const Body& body = state.bodies[handle];
  const bool owned = body.striker && state.tick - body.bornTick <= kOwnedTicks && state.bodies.contains(body.striker);
  return owned ? body.striker : handle;
}

float spentOn(const State& state, BodyHandle striker, BodyHandle struck) {
  const std::size_t i = budgetIndex(state, striker, struck);
  return isBudgetOf(state, i, striker, struck) ? state.budgets[i].spent : 0.0f;
}

void charge(State& state, BodyHandle striker, BodyHandle struck, float impulse) {
  const std::size_t i = budgetIndex(state, striker, struck);
  if (!isBudgetOf(state, i, striker, struck))
    state.budgets.insert(state.budgets.begin() + static_cast<std::ptrdiff_t>(i), Budget{striker, struck, 0.0f});
  state.budgets[i].spent += impulse;
}

void fadeBudgets(State& state, float dt) {
  const float keep = maxOf(0.0f, 1.0f - 60.0f * dt);
  std::erase_if(state.budgets, [&](Budget& budget) {
    const Body* struck = state.bodies.find(budget.struck);
    if (struck == nullptr || !state.bodies.contains(budget.striker)) return true;
    if (struck->brokenTick != state.tick) budget.spent *= keep;
    return budget.spent < 1e-12f;
  });
}

void closeBudgets(State& state) {
  std::erase_if(state.budgets, [&](const Budget& budget) {
    const Body* struck = state.bodies.find(budget.struck);
    return struck != nullptr && struck->brokenTick == state.tick;
  });
}

}  // namespace brittle::physics
