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

TEST(EffectSet, WhatIsDemandedRunsUnlessThePlayerSwitchedItOff) {
  EffectSet set;
  set.switchOff(EffectMask().with(Effect::Fog));
  set.demand(Effect::Fog, "room.lua:2");
  set.demand(Effect::Echo, "room.lua:3");
  EXPECT_TRUE(set.has(Effect::Fog)) << "the demand is still to be seen";
  EXPECT_FALSE(set.runs(Effect::Fog));
  EXPECT_TRUE(set.runs(Effect::Echo));
  EXPECT_FALSE(set.runs(Effect::Reverb));
  EXPECT_EQ(set.running(), EffectMask().with(Effect::Echo));
}

TEST(Effect, EveryOneHasANameOfItsOwnAndIsFoundByIt) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < kEffects; ++i) {
    const auto effect = static_cast<Effect>(i);
    ASSERT_NE(infoOf(effect).name, nullptr);
    ASSERT_NE(infoOf(effect).demandedBy, nullptr);
    names.insert(nameOf(effect));
    EXPECT_EQ(effectNamed(nameOf(effect)), effect);
  }
  EXPECT_EQ(names.size(), kEffects);
  EXPECT_FALSE(effectNamed("lightning").has_value());
}

TEST(EffectMask, KindsShareNothingAndCoverAll) {
  std::uint32_t all = 0;
  for (const Kind kind : {Kind::Physical, Kind::Seen, Kind::Heard}) {
    EXPECT_EQ(all & maskOf(kind).bits(), 0u);
    all |= maskOf(kind).bits();
  }
  EXPECT_EQ(all, EffectMask::ofBits(~0u).bits());
}

}  // namespace
}  // namespace brittle::effects
