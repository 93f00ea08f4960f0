// The calls of obstacle scripts about the game itself: crystals, cleared obstacles, buttons, lasers, sound, time and
// parameters.
#include <cmath>
#include <vector>

#include "engine/effects/has/lasers.h"
#include "engine/geometry/make.h"
#include "engine/physics/world.h"
#include "game/content/number.h"
#include "game/sim/obstacle_api.h"
#include "game/sim/room.h"

namespace brittle::sim {

namespace {

constexpr int kEventPrice = 200;  // instructions: everyone who sees or hears it gets a copy

void score(script::Call& call, Obstacle& obstacle) {
  const int worth = call.integer(1);
  if (!call.failed()) obstacle.crystal = clampTo(worth, 0, 100);
}

void clear(script::Call&, Obstacle& obstacle) {
  obstacle.room->clearObstacle(obstacle);
}

void createButton(script::Call& call, Obstacle& obstacle) {
  const Vec3 position = readVector(call, 1, rules::kFarthest);
  if (call.failed()) return;
  if (!hasPlaceForBody(call, obstacle)) return;
  ScriptBody body;
  body.pose = {position, rotationAbout(Vec3::UnitX(), 0.5f * kPi)};  // its flat side towards the camera
  physics::World& world = obstacle.room->world();
  physics::BodyDef def;
  def.type = physics::BodyType::Static;
  def.pose = obstacle.pose() * body.pose;
  def.userData = obstacle.number;
  body.handle = world.createBody(def);
  body.assembly = world.body(body.handle).assembly;
  body.look = Look::Metal;
  physics::ShapeDef shape;
  shape.drawMaterial = static_cast<std::uint16_t>(Look::Stone);  // dull: its colour is seen in a dark room too
  world.addConvex(body.handle, shape, geometry::makeCylinder(rules::kButtonRadius, 0.05f, rules::kCylinderSides));
  obstacle.bodies.push_back(body);
  obstacle.buttons.push_back({static_cast<std::uint32_t>(obstacle.bodies.size()), false, false});
  obstacle.setDown(obstacle.buttons.back(), false);
  call.result(static_cast<int>(obstacle.buttons.size()));
}

ScriptButton* readButton(script::Call& call, Obstacle& obstacle) {
  const int number = call.integer(1);
  if (call.failed()) return nullptr;
  if (number >= 1 && number <= static_cast<int>(obstacle.buttons.size()))
    return &obstacle.buttons[static_cast<std::size_t>(number) - 1];
  call.fail("no button " + std::to_string(number));
  return nullptr;
}

void isButtonDown(script::Call& call, Obstacle& obstacle) {
  const bool onlyNow = call.boolean(2, false);
  const ScriptButton* button = readButton(call, obstacle);
  if (!call.failed()) call.result(onlyNow ? button->justPressed : button->down);
}

void setButtonDown(script::Call& call, Obstacle& obstacle) {
  const bool down = call.boolean(2, true);
  ScriptButton* button = readButton(call, obstacle);
  if (!call.failed()) obstacle.setDown(*button, down);
}

void laser(script::Call& call, Obstacle& obstacle) {
  if (!obstacle.room->effects().has(effects::Effect::Lasers))
    obstacle.room->demand(effects::Effect::Lasers, call.where());
  if constexpr (effects::kHasLasers)
    if (obstacle.room->runs(effects::Effect::Lasers)) castLaser(call, obstacle);
}

/// Something that is only seen, at the point that the first three arguments say.
void show(script::Call& call, Obstacle& obstacle, EventType type, const Vec3& direction) {
  const Vec3 point = readVector(call, 1, rules::kFarthest);
  if (call.failed()) return;
  call.charge(kEventPrice);
  Event event;
  event.type = type;
  event.point = obstacle.pose().toWorld(point);
  event.direction = obstacle.pose().rotate(direction);
  obstacle.room->emit(event);
}

void smoke(script::Call& call, Obstacle& obstacle) {
  if (!obstacle.room->effects().has(effects::Effect::Smoke))
    obstacle.room->demand(effects::Effect::Smoke, call.where());
  constexpr float fastest = 20.0f;  // [m/s]
  show(call, obstacle, EventType::Smoke, readVector(call, 4, fastest, Vec3::Zero()));
}

void glow(script::Call& call, Obstacle& obstacle) {
  show(call, obstacle, EventType::Glow, Vec3::Zero());
}

/// A picture on a body for this tick, in the pen's colour. What is left of a broken body may not reach there any more:
/// it shows none.
void bodyDecal(script::Call& call, Obstacle& obstacle) {
  const ScriptBody* body = readBody(call, obstacle, 1);
  const int tile = call.integer(2);
  const Vec2 size(call.real(3), call.real(4));
  const Vec3 position = readVector(call, 5, rules::kFarthest, Vec3::Zero());
  const Vec3 angles = readVector(call, 8, rules::kMostAngle, Vec3::Zero());
  if (call.failed()) return;
  call.charge(200);
  if (!(size.minCoeff() >= 0.001f && size.maxCoeff() <= 500.0f)) return call.fail("size: expected 0.001 to 500");
  if (obstacle.decals.size() >= rules::kMaxBodiesPerObstacle) return refuseMore(call, obstacle, "too many decals");
  if (!body->handle || !obstacle.room->world().isAlive(body->handle) || body->breaks > 0) return;
  if (!obstacle.paints) obstacle.room->demand(effects::Effect::Decals, call.where());
  obstacle.paints = true;
  const float* color = obstacle.pen.color;
  BodyDecal decal;
  decal.body = body->handle.index;
  decal.look = {
      position, rotationXyz(angles), size, clampTo(tile, -4, 63), Vec4(color[0], color[1], color[2], color[3]), 1.0f};
  obstacle.decals.push_back(decal);
}

void getBeat(script::Call& call, Obstacle& obstacle) {
  const float ease = clampTo(call.real(1, 0.3f), 0.01f, 1.0f);
  if (call.failed()) return;
  // Of the music, which begins with the room: negative before the camera is in it.
  const Viewpoint& viewpoint = obstacle.room->viewpoint();
  const float beats = (static_cast<float>(viewpoint.ticks) + viewpoint.tickPart) / rules::kBeatTicks;
  const float whole = std::floor(beats);
  const float ramp = clampTo((beats - whole) / ease, 0.0f, 1.0f);
  call.result(whole - 1.0f + ramp * ramp * (3.0f - 2.0f * ramp));
}

/// The parameter of this name from the segment, or null.
const std::string* findParameter(script::Call& call, const Obstacle& obstacle) {
  const auto found = obstacle.def->parameters.find(call.string(1));
  return call.failed() || found == obstacle.def->parameters.end() ? nullptr : &found->second;
}

template <bool whole>
void getNumber(script::Call& call, Obstacle& obstacle) {
  double number = call.number(2, 0.0);
  const std::string* text = findParameter(call, obstacle);
  if (call.failed()) return;
  const auto said = text != nullptr ? content::parseNumber(*text) : std::nullopt;
  if (said && *said > -1e9 && *said < 1e9) {
    number = *said;
  } else if (text != nullptr)
    obstacle.room->session().report(obstacle.def->where + ": parameter " + call.string(1) + "=" + *text +
                                    ": expected a number");
  call.result(whole ? static_cast<double>(static_cast<std::int64_t>(clampTo(number, -1e9, 1e9))) : number);
}

void getBool(script::Call& call, Obstacle& obstacle) {
  const bool otherwise = call.boolean(2, false);
  const std::string* text = findParameter(call, obstacle);
  if (call.failed()) return;
  call.result(text == nullptr ? otherwise : *text == "true" || *text == "1");
}

void getString(script::Call& call, Obstacle& obstacle) {
  const std::string otherwise = call.string(2, "");
  const std::string* text = findParameter(call, obstacle);
  if (!call.failed()) call.result(script::Value(text == nullptr ? otherwise : *text));
}

void getColor(script::Call& call, Obstacle& obstacle) {
  double values[3] = {call.number(2, 1.0), 1.0, 1.0};
  values[1] = call.number(3, 1.0);
  values[2] = call.number(4, 1.0);
  const std::string* text = findParameter(call, obstacle);
  if (call.failed()) return;
  const auto said = text != nullptr ? content::parseNumbers(*text) : std::nullopt;
  for (std::size_t i = 0; said && i < 3 && i < said->size(); ++i) values[i] = clampTo((*said)[i], -100.0, 100.0);
  for (const double value : values) call.result(value);
}

void playSound(script::Call& call, Obstacle& obstacle) {
  const int number = call.integer(1);
  const float volume = call.real(2, 1.0f);
  if (call.failed()) return;
  call.charge(kEventPrice);
  Event event;
  event.type = EventType::Sound;
  event.point = obstacle.pose().position;
  event.value = number - 1;
  event.size = clampTo(volume, 0.0f, 1.0f);
  obstacle.room->emit(event);
}

void addSoundCalls(script::Library& library) {
  addCall(library, "mgCreateSound", [](script::Call& call, Obstacle& o) {
    const std::string name = call.string(1);
    if (!call.failed()) call.result(o.room->session().soundIndex(name) + 1);
  });
  addCall(library, "mgPlaySound", playSound);
  addCall(library, "mgCameraShake", [](script::Call& call, Obstacle& o) {
    const float strength = call.real(1);
    if (!call.failed()) o.room->shakeCamera(clampTo(strength, 0.0f, 1.0f));
  });
}

void addParameterCalls(script::Library& library) {
  addCall(library, "mgGetFloat", getNumber<false>);
  addCall(library, "mgGetInt", getNumber<true>);
  addCall(library, "mgGetBool", getBool);
  addCall(library, "mgGetString", getString);
  addCall(library, "mgGetColor", getColor);
}

void addTimeCalls(script::Library& library) {
  addCall(library, "mgTime", [](script::Call& call, Obstacle& o) { call.result(o.room->age() * rules::kTickSeconds); });
  addCall(library, "mgObstacleTime",
          [](script::Call& call, Obstacle& o) { call.result(o.age() * rules::kTickSeconds); });
  addCall(library, "mgGetBeat", getBeat);
}

}  // namespace

void addPlayCalls(script::Library& library) {
  addCall(library, "mgScore", score);
  addCall(library, "mgClear", clear);
  addCall(library, "mgIsCleared", [](script::Call& call, Obstacle& o) { call.result(o.cleared); });
  addCall(library, "mgCreateButton", createButton);
  addCall(library, "mgIsButtonDown", isButtonDown);
  addCall(library, "mgSetButtonDown", setButtonDown);
  addCall(library, "mgLaser", laser);
  addCall(library, "mgSmoke", smoke);
  addCall(library, "mgGlow", glow);
  addSoundCalls(library);
  addParameterCalls(library);
  addTimeCalls(library);
  addCall(library, "mgBodyDecal", bodyDecal);
  // Only seen, and not shown here: accepted so that the levels that use them play.
  for (const char* name : {"mgRoundness", "mgShapeChamfer", "mgHideEdges", "mgTexture"})
    addCall(library, name, [](script::Call& call, Obstacle& o) {
      o.room->session().reportMissing(call.name(), call.where(), "accepted, but nothing here is drawn by it");
    });
}

}  // namespace brittle::sim
