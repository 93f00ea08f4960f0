#include "engine/effects/effect_set.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace brittle::effects {
namespace {

TEST(EffectSet, StartsWithNothingOn) {
  const EffectSet set;
  for (int i = 0; i < static_cast<int>(Effect::Count); ++i) EXPECT_FALSE(set.has(static_cast<Effect>(i)));
}

TEST(EffectSet, ADemandIsOnAndNamesWhoAsked) {
  EffectSet set;
  set.demand(Effect::Fracture, "a.xml:3");
  set.demand(Effect::Fracture, "a.xml:9");
  EXPECT_TRUE(set.has(Effect::Fracture));
  EXPECT_EQ(set.count(Effect::Fracture), 2u);
  EXPECT_FALSE(set.has(Effect::Joints));
  ASSERT_EQ(set.demands().size(), 2u);
  EXPECT_EQ(set.demands()[1].who, "a.xml:9");
  set.clear();
  EXPECT_FALSE(set.has(Effect::Fracture));
  EXPECT_TRUE(set.demands().empty());
}

TEST(EffectSet, EveryEffectHasANameOfItsOwn) {
  std::set<std::string> names;
  for (int i = 0; i < static_cast<int>(Effect::Count); ++i) names.insert(nameOf(static_cast<Effect>(i)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(Effect::Count));
  EXPECT_FALSE(names.contains("none"));
}

}  // namespace
}  // namespace brittle::effects
