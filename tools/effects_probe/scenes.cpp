#include "tools/effects_probe/scenes.h"

#include <string>

namespace brittle::probe {
namespace {

using effects::Effect;

/// What a version of the room has beside the crates.
struct Extra {
  int rows = 1;
  std::string room = {};                        // calls of the room's script
  std::string elements = {};                    // of its segment
  std::string crates = {};                      // calls at the end of the crates' init
  std::string tick = {};                        // and in each of their ticks
  std::string attributes = "softshadow=\"0\"";  // of the segment
  std::string floor = {};                       // of the floor's box
};

Extra extraOf(Effect effect) {
  switch (effect) {
    case Effect::Fracture:
      return {.elements = "<obstacle pos=\"0 1 -14\" type=\"panes\"/>"};
    case Effect::Joints:
      return {.crates = "for i = 1, #crates - 1 do mgCreateBallJoint(crates[i], crates[i + 1], i - 3, 1.5, 0) end"};
    case Effect::Drives:
      return {.tick = "for i, crate in ipairs(crates) do mgMove(crate, i - 3, 2, 0, 1, 2) end"};
    case Effect::Debris:
      return {.elements = "<obstacle pos=\"0 1 -14\" type=\"panes\"/>"};
    case Effect::Stacks:
      return {.crates =
                  "for i = 1, 12 do local b = mgCreateBody(3, -0.8 + 0.401 * i, -4) mgCreateBox(b, .2, .2, .2) end"};
    case Effect::Water:
      return {.elements = "<water pos=\"0 -0.2 -14\" size=\"4 6\"/>"};
    case Effect::Explosions:
      return {.elements = "<powerup pos=\"0 1 -6\" type=\"nitroballs\"/>"};
    case Effect::Lasers:
      return {.tick = "for i = 0, 4 do mgLaser(-3, 0.3 * i, -2, 1, 0, 0) end"};
    case Effect::SlowMotion:
      return {.elements = "<powerup pos=\"0 1 -6\" type=\"slowmotion\"/>"};
    case Effect::Bloom:
      return {.elements = "<box pos=\"0 4 -14\" size=\"1 .1 .1\" visible=\"1\" glow=\"1\"/>"};
    case Effect::Mirror:
      return {.floor = "reflection=\"1\""};
    case Effect::Shadows:
      return {.attributes = "softshadow=\"0.6\""};
    case Effect::Decals:
      return {.elements = "<decal pos=\"0 -0.99 -14\" rot=\"-1.57 0 0\" size=\"1 1\" tile=\"3\"/>"};
    case Effect::Air:
      return {.room = "mgParticles('dustyfalling') "};
    case Effect::Splinters:
      return {.elements = "<obstacle pos=\"0 1 -14\" type=\"panes\"/>"};
    case Effect::Smoke:
      return {.tick = "if mgTime() * 10 % 2 < 1 then mgSmoke(0, 1, 0, 0, 1, 0) end"};
    case Effect::DepthOfField:
      return {.room = "mgDepthOfField(8, 4) "};
    case Effect::CameraRoll:
      return {.room = "mgSetRotation(2) "};
    case Effect::Reverb:
      return {.room = "mgReverb(0.5, 1, 0.3) "};
    case Effect::Echo:
      return {.room = "mgEcho(0.5, 0.3, 0.5, 0.3) "};
    case Effect::LowPass:
      return {.room = "mgLowPass(0.5) "};
    case Effect::Music:
      return {.room = "mgMusic('hall') "};
    case Effect::Fog:
    case Effect::Count:
      break;
  }
  return {};
}

// Never asleep: each second every crate hops, towards a neighbour or back.
constexpr const char* kCrates = R"(
function init()
  mgMaterial("steel")
  crates = {}
  for i = 1, 6 do
    crates[i] = mgCreateBody(i - 3.5, 0.5 + 0.2 * i, 0)
    mgCreateBox(crates[i], 0.25, 0.25, 0.25)
  end
  ticks = 0
  EXTRA_CRATES
end

function tick()
  if ticks % 60 == 0 then
    local side = ticks % 120 == 0 and 1 or -1
    for i, crate in ipairs(crates) do
      mgSetVel(crate, (i % 2 == 0 and side or -side), 3, 0)
    end
  end
  ticks = ticks + 1
  EXTRA_TICK
end
)";

// Two panes that a falling weight breaks by itself, so that nobody need throw.
constexpr const char* kPanes = R"(
function init()
  mgMaterial("glass")
  mgForceLimit(0.05)
  for i = 1, 4 do
    mgStatic(1)
    local pane = mgCreateBody(1.8 * i - 4.5, -0.7, 0)
    mgCreateBox(pane, 0.7, 0.02, 0.7)
  end
  mgStatic(0)
  mgMaterial("steel")
  for i = 1, 4 do
    local weight = mgCreateBody(1.8 * i - 4.5, 1 + i, 0)
    mgCreateBox(weight, 0.15, 0.15, 0.15)
    mgSetVel(weight, 0, -8, 0)
  end
end
)";

std::string filled(std::string text, const std::string& name, const std::string& with) {
  const std::size_t at = text.find(name);
  return text.replace(at, name.size(), with);
}

content::MemorySource roomOf(const Extra& extra) {
  std::string crates;
  for (int row = 0; row < extra.rows; ++row)
    crates += "<obstacle pos=\"0 1 " + std::to_string(-14 - row) + "\" type=\"crates\"/>";
  content::MemorySource source;
  source.add("levels/probe.xml", "<level><room type=\"probe/room\" length=\"100\"/></level>");
  source.add("rooms/probe/room.lua", "function init() " + extra.room + "mgSegment(\"probe/room\", 0) mgLength(30) end");
  source.add("segments/probe/room.xml", "<segment size=\"12 10 32\" " + extra.attributes +
                                            "><box pos=\"0 -1.2 -16\" size=\"4 .2 16\" visible=\"1\" " + extra.floor +
                                            "/>" + extra.elements + crates + "</segment>");
  source.add("obstacles/crates.lua", filled(filled(kCrates, "EXTRA_CRATES", extra.crates), "EXTRA_TICK", extra.tick));
  source.add("obstacles/panes.lua", kPanes);
  return source;
}

}  // namespace

content::MemorySource plainRoom(int rows) {
  return roomOf({.rows = rows});
}

content::MemorySource roomWith(effects::Effect effect) {
  return roomOf(extraOf(effect));
}

}  // namespace brittle::probe
