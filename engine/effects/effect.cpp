#include "engine/effects/effect.h"

#include <array>

namespace brittle::effects {
namespace {

// In the order of the enumerators; the test of names sees a gap.
constexpr std::array<EffectInfo, kEffects> kInfos = {{
    {"fracture", Kind::Physical, "a shape with a force limit"},
    {"joints", Kind::Physical, "mgCreateHingeJoint, -BallJoint, -SliderJoint, -Rope"},
    {"drives", Kind::Physical, "mgMove and mgRotate with a strength"},
    {"debris", Kind::Physical, "a shape with a force limit"},
    {"stacks", Kind::Physical, "slow bodies that stand on one another"},
    {"water", Kind::Physical, "<water>"},
    {"explosions", Kind::Physical, "<powerup type=\"nitroballs\"> or \"barrel\""},
    {"lasers", Kind::Physical, "mgLaser"},
    {"slow-motion", Kind::Physical, "<powerup type=\"slowmotion\">"},
    {"camera-roll", Kind::Physical, "mgSetRotation"},
    {"fog", Kind::Seen, "mgFogColor"},
    {"bloom", Kind::Seen, "a box with glow"},
    {"mirror", Kind::Seen, "a box with reflection"},
    {"shadows", Kind::Seen, "a segment with softshadow"},
    {"decals", Kind::Seen, "<decal> and mgBodyDecal"},
    {"air", Kind::Seen, "mgParticles"},
    {"splinters", Kind::Seen, "a shape with a force limit"},
    {"smoke", Kind::Seen, "mgSmoke"},
    {"depth-of-field", Kind::Seen, "mgDepthOfField"},
    {"reverb", Kind::Heard, "mgReverb"},
    {"echo", Kind::Heard, "mgEcho"},
    {"low-pass", Kind::Heard, "mgLowPass"},
    {"music", Kind::Heard, "mgMusic"},
}};

}  // namespace

const EffectInfo& infoOf(Effect effect) {
  return kInfos[static_cast<std::size_t>(effect)];
}

EffectMask maskOf(Kind kind) {
  EffectMask mask;
  for (std::size_t i = 0; i < kEffects; ++i)
    if (kInfos[i].kind == kind) mask = mask.with(static_cast<Effect>(i));
  return mask;
}

std::optional<Effect> effectNamed(std::string_view name) {
  for (std::size_t i = 0; i < kEffects; ++i)
    if (name == kInfos[i].name) return static_cast<Effect>(i);
  return std::nullopt;
}

}  // namespace brittle::effects
