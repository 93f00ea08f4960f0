// The calls of room scripts: they lay out segments and obstacles and set the room's length, light and sound while
// init() runs.
#include <cstdio>
#include <iterator>

#include "engine/core/random.h"
#include "engine/script/sandbox.h"
#include "game/content/number.h"
#include "game/sim/room_plan.h"
#include "game/sim/unread.h"

namespace brittle::sim {

namespace {

/// A segment that nextSegment() may pick.
struct Choice {
  std::string name;
  double weight = 1.0;
  int left = 1000;
};

struct Builder {
  Session& session;
  const RoomEntry& entry;
  std::map<std::string, std::string>& globals;
  RoomPlan plan;
  float placed = 0.0f;  // end of the last segment [m]
  std::vector<Choice> choices;
  int last = -1;  // the choice made last
  Vec3 boxColor = Vec3::Ones();
  int boxTile = 0;
};

using Native = void (*)(script::Call&, Builder&);

void add(script::Library& library, const char* name, Native native) {
  library.add(name, [native](script::Call& call) { native(call, call.user<Builder>()); });
}

Vec3 vectorAt(script::Call& call, int first) {
  const float x = call.real(first);
  const float y = call.real(first + 1);
  const float z = call.real(first + 2);
  return Vec3(x, y, z);
}

void segment(script::Call& call, Builder& builder) {
  const std::string name = call.string(1);
  const float start = call.has(2) ? -call.real(2) : builder.placed;
  call.charge(1000);  // a file may have to be found and read
  if (call.failed()) return;
  if (!(start > -1000.0f && start < 10000.0f))
    return call.fail("place " + std::to_string(start) + ": expected -1000 to 10000");
  const float length = placeSegment(builder.session, name, start, call.where(), builder.plan);
  builder.placed = maxOf(builder.placed, start + length);
  call.result(length);
}

void confSegment(script::Call& call, Builder& builder) {
  Choice choice;
  choice.name = call.string(1);
  choice.weight = call.number(2, 1.0);
  choice.left = maxOf(call.integer(3, 1000), 0);
  if (!call.failed() && choice.weight > 0.0 && builder.choices.size() < 1000) builder.choices.push_back(choice);
}

/// Weighted, never the same twice in a row unless there is no other. All used up: the last one goes on, so that a room
/// is always filled.
void nextSegment(script::Call& call, Builder& builder) {
  if (builder.choices.empty()) return call.fail("no segment has been offered with confSegment");
  double total = 0.0;
  const auto open = [&](std::size_t i) { return builder.choices[i].left > 0 && static_cast<int>(i) != builder.last; };
  for (std::size_t i = 0; i < builder.choices.size(); ++i) total += open(i) ? builder.choices[i].weight : 0.0;
  const double draw = static_cast<double>(call.random().nextFloat()) * total;
  std::size_t picked = builder.last >= 0 ? static_cast<std::size_t>(builder.last) : 0;
  double sum = 0.0;
  for (std::size_t i = 0; i < builder.choices.size(); ++i) {
    if (!open(i)) continue;
    picked = i;
    sum += builder.choices[i].weight;
    if (draw < sum) break;
  }
  builder.last = static_cast<int>(picked);
  if (builder.choices[picked].left > 0) --builder.choices[picked].left;
  call.result(script::Value(builder.choices[picked].name));
}

void length(script::Call& call, Builder& builder) {
  const float metres = call.real(1);
  if (call.failed()) return;
  if (!(metres >= 8.0f && metres <= 4000.0f))
    return call.fail("length " + std::to_string(metres) + ": expected 8 to 4000");
  builder.plan.settings.length = metres;
}

void obstacle(script::Call& call, Builder& builder) {
  ObstacleDef def;
  def.type = call.string(1);
  def.position = vectorAt(call, 2);
  def.where = call.where();
  int rotations = 0;
  for (int i = 5; i <= call.count() && i <= 24; ++i) {
    const std::string text = call.has(i) ? call.string(i) : "";
    const std::size_t equals = text.find('=');
    if (equals != std::string::npos) {
      def.parameters[text.substr(0, equals)] = text.substr(equals + 1);
    } else if (call.isNumber(i) && rotations < 3) {
      def.rotation[rotations++] = call.real(i);
    }
  }
  if (call.failed()) return;
  if (!(def.position.cwiseAbs().maxCoeff() <= rules::kFarthest &&
        def.rotation.cwiseAbs().maxCoeff() <= rules::kMostAngle))
    return call.fail("expected a place within 10000 m and angles within 1e6");
  if (def.type == kStone) {
    reportUnread(builder.session, def);
    return placeBox(builder.session, stoneLook(def), false, def.where, builder.plan);
  }
  placeObstacle(builder.session, std::move(def), builder.plan);
}

void powerUp(script::Call& call, Builder& builder) {
  const std::string type = call.string(1);
  const Vec3 position = vectorAt(call, 2);
  if (call.failed()) return;
  if (!(position.cwiseAbs().maxCoeff() <= rules::kFarthest)) return call.fail("expected a place within 10000 m");
  placePowerUp(builder.session, type, position, call.where(), builder.plan);
}

void box(script::Call& call, Builder& builder) {
  const Vec3 half = vectorAt(call, 1);
  const Vec3 center = vectorAt(call, 4);
  if (call.failed()) return;
  if (!(half.minCoeff() > 0.001f && half.maxCoeff() < 5000.0f))
    return call.fail("half extents: expected 0.001 to 5000");
  if (!(center.cwiseAbs().maxCoeff() <= rules::kFarthest)) return call.fail("expected a place within 10000 m");
  LookBox seen;
  seen.center = center;
  seen.halfExtents = half;
  for (int i = 0; i < 3; ++i) {
    seen.color[i] = builder.boxColor;
    seen.tile[i] = builder.boxTile;
  }
  placeBox(builder.session, seen, true, call.where(), builder.plan);
}

void fogColor(script::Call& call, Builder& builder) {
  const Vec3 first = vectorAt(call, 1);
  const Vec3 second = call.has(4) ? vectorAt(call, 4) : first;
  if (call.failed()) return;
  builder.plan.settings.fogBottom = first;
  builder.plan.settings.fogTop = second;
  builder.plan.effects.demand(effects::Effect::Fog, call.where());
}

struct Range {
  float low, high;
};
constexpr Range kReverb[] = {{0.0f, 1.0f}, {0.0f, 10.0f}, {0.0f, 1.0f}};  // volume, time [s], low-pass
constexpr Range kEcho[] = {
    {0.0f, 1.0f}, {0.0f, 2.0f}, {0.0f, 0.95f}, {0.0f, 1.0f}};  // volume, delay [s], feedback, low-pass
constexpr Range kLowPass = {0.0f, 1.0f};

/// What is beyond its range counts as the end of it, and is reported.
float limited(script::Call& call, Builder& builder, int index, float asked, const Range& range) {
  const float value = clampTo(asked, range.low, range.high);
  if (value == asked || call.failed()) return value;
  char text[80];
  std::snprintf(text, sizeof text, ": argument %d is %g, expected %g to %g", index, static_cast<double>(asked),
                static_cast<double>(range.low), static_cast<double>(range.high));
  builder.session.report(call.where() + ": " + call.name() + text);
  return value;
}

float limited(script::Call& call, Builder& builder, int index, const Range& range) {
  return limited(call, builder, index, call.real(index, 0.0f), range);
}

template <auto field, const auto& ranges, effects::Effect effect>
void setEcho(script::Call& call, Builder& builder) {
  float values[std::size(ranges)];
  for (std::size_t i = 0; i < std::size(ranges); ++i)
    values[i] = limited(call, builder, static_cast<int>(i) + 1, ranges[i]);
  if (call.failed()) return;
  for (std::size_t i = 0; i < std::size(ranges); ++i) (builder.plan.settings.*field)[i] = values[i];
  if (values[0] > 0.0f) builder.plan.effects.demand(effect, call.where());
}

void setLowPass(script::Call& call, Builder& builder) {
  const float amount = limited(call, builder, 1, kLowPass);
  if (call.failed()) return;
  builder.plan.settings.lowPass = amount;
  if (amount > 0.0f) builder.plan.effects.demand(effects::Effect::LowPass, call.where());
}

void setDifficulty(script::Call& call, Builder& builder) {
  const float value = call.real(1);
  if (!call.failed()) builder.plan.settings.difficulty = value;
}

constexpr Range kTimesGravity = {-10.0f, 10.0f};

void setGravity(script::Call& call, Builder& builder) {
  const float value = limited(call, builder, 1, call.real(1), kTimesGravity);
  if (!call.failed()) builder.plan.settings.gravity = value;
}

void setParticles(script::Call& call, Builder& builder) {
  const std::string name = call.string(1);
  if (call.failed()) return;
  builder.plan.settings.particles = name;
  if (!name.empty()) builder.plan.effects.demand(effects::Effect::Air, call.where());
}

void setMusic(script::Call& call, Builder& builder) {
  const std::string name = call.string(1);
  if (call.failed()) return;
  builder.plan.settings.music = name;
  if (!name.empty() && name != "silent") builder.plan.effects.demand(effects::Effect::Music, call.where());
}

constexpr Range kTurns = {-100.0f, 100.0f}, kTurnAngle = {-kPi, kPi};  // [turns], [rad]

void rotation(script::Call& call, Builder& builder) {
  const float turns = limited(call, builder, 1, call.real(1), kTurns);
  const float angle = limited(call, builder, 2, kTurnAngle);
  if (call.failed()) return;
  builder.plan.settings.turns = turns;
  builder.plan.settings.turnAngle = angle;
  if (builder.plan.settings.turns != 0.0f) builder.plan.effects.demand(effects::Effect::CameraRoll, call.where());
}

constexpr Range kFocusDistance = {0.0f, 100.0f}, kFocusRange = {0.1f, 100.0f}, kFocusStrength = {0.0f, 1.0f};

/// What is farther away than a distance is blurred, wholly so after a range more. [m]
void depthOfField(script::Call& call, Builder& builder) {
  RoomSettings& settings = builder.plan.settings;
  const float distance = limited(call, builder, 1, kFocusDistance);
  const float range = limited(call, builder, 2, kFocusRange);
  const float strength = call.has(3) ? limited(call, builder, 3, kFocusStrength) : 0.7f;
  if (call.failed()) return;
  settings.focus[0] = distance;
  settings.focus[1] = range;
  settings.focus[2] = strength;
  if (strength > 0.0f) builder.plan.effects.demand(effects::Effect::DepthOfField, call.where());
}

/// The room's attribute in the level file, or null.
const std::string* attribute(script::Call& call, const Builder& builder) {
  const auto found = builder.entry.attributes.find(call.string(1));
  return call.failed() || found == builder.entry.attributes.end() ? nullptr : &found->second;
}

template <bool whole>
void getNumber(script::Call& call, Builder& builder) {
  const double otherwise = call.number(2, 0.0);
  const std::string* text = attribute(call, builder);
  if (call.failed()) return;
  const auto found = text != nullptr ? content::parseNumber(*text) : std::nullopt;
  const double number = found && *found > -1e9 && *found < 1e9 ? *found : otherwise;
  call.result(whole ? static_cast<double>(static_cast<std::int64_t>(number)) : number);
}

void getBool(script::Call& call, Builder& builder) {
  const bool otherwise = call.boolean(2, false);
  const std::string* text = attribute(call, builder);
  if (!call.failed()) call.result(text == nullptr ? otherwise : *text == "true" || *text == "1");
}

void getString(script::Call& call, Builder& builder) {
  const std::string otherwise = call.string(2, "");
  const std::string* text = attribute(call, builder);
  if (!call.failed()) call.result(script::Value(text == nullptr ? otherwise : *text));
}

void getGlobal(script::Call& call, Builder& builder) {
  const std::string key = call.string(1);
  if (call.failed()) return;
  const auto found = builder.globals.find(key);
  call.result(script::Value(found == builder.globals.end() ? std::string() : found->second));
}

void setGlobal(script::Call& call, Builder& builder) {
  const std::string key = call.string(1);
  const std::string value = call.string(2, "");
  if (call.failed()) return;
  if (builder.globals.size() >= 1000) return call.fail("too many global strings");
  builder.globals[key] = value;
}

void randomFloat(script::Call& call, Builder&) {
  const float low = call.real(1);
  const float high = call.real(2);
  if (!call.failed()) call.result(call.random().nextFloat(low, high));
}

void randomInt(script::Call& call, Builder&) {
  const int low = call.integer(1);
  const int high = call.integer(2);
  if (call.failed()) return;
  const std::int64_t count = static_cast<std::int64_t>(high) - low + 1;
  if (count < 1 || count > 0x7fffffff) return call.fail("range: expected the lower end first");
  call.result(low + static_cast<int>(call.random().nextBelow(static_cast<std::uint32_t>(count))));
}

void randomize(script::Call& call, Builder&) {
  const double seed = call.number(1);
  if (!call.failed()) call.random() = Random(static_cast<std::uint64_t>(static_cast<std::int64_t>(seed)));
}

void addAttributeCalls(script::Library& library) {
  add(library, "mgGetFloat", getNumber<false>);
  add(library, "mgGetInt", getNumber<true>);
  add(library, "mgGetBool", getBool);
  add(library, "mgGetString", getString);
  add(library, "mgGet", getGlobal);
  add(library, "mgSet", setGlobal);
  add(library, "mgRndFloat", randomFloat);
  add(library, "mgRndInt", randomInt);
  add(library, "mgRndBool", [](script::Call& call, Builder&) { call.result(call.random().nextBelow(2) == 1); });
  add(library, "mgRandomize", randomize);
  add(library, "mgGetSplitExtraRoomLength", [](script::Call& call, Builder&) { call.result(0); });
}

void addLayoutCalls(script::Library& library) {
  add(library, "mgSegment", segment);
  add(library, "confSegment", confSegment);
  add(library, "nextSegment", nextSegment);
  add(library, "mgLength", length);
  add(library, "mgObstacle", obstacle);
  add(library, "mgBox", box);
  add(library, "mgColor", [](script::Call& call, Builder& builder) {
    const Vec3 color = vectorAt(call, 1);
    if (!call.failed()) builder.boxColor = color;
  });
  add(library, "mgTexture", [](script::Call& call, Builder& builder) {
    const int tile = call.integer(1);
    if (!call.failed()) builder.boxTile = clampTo(tile, 0, 63);
  });
  add(library, "mgPowerUp", powerUp);
}

void addMoodCalls(script::Library& library) {
  add(library, "mgFogColor", fogColor);
  add(library, "mgReverb", setEcho<&RoomSettings::reverb, kReverb, effects::Effect::Reverb>);
  add(library, "mgEcho", setEcho<&RoomSettings::echo, kEcho, effects::Effect::Echo>);
  add(library, "mgLowPass", setLowPass);
  add(library, "mgMusic", setMusic);
  add(library, "mgParticles", setParticles);
  add(library, "mgGravity", setGravity);
  add(library, "mgSetDifficulty", setDifficulty);
  add(library, "mgSetRotation", rotation);
  add(library, "mgRotation", rotation);
  add(library, "mgDepthOfField", depthOfField);
}

const script::Library& roomLibrary() {
  static const script::Library library = [] {
    script::Library made;
    addLayoutCalls(made);
    addMoodCalls(made);
    addAttributeCalls(made);
    return made;
  }();
  return library;
}

}  // namespace

RoomPlan planRoom(Session& session, const RoomEntry& entry, std::uint64_t seed,
                  std::map<std::string, std::string>& globals) {
  Builder builder{session, entry, globals, {}, 0.0f, {}, -1, Vec3::Ones(), 0};
  builder.plan.effects.switchOff(session.def.without);
  script::Sandbox sandbox(roomLibrary(), seed, {}, &builder);
  const std::string path = "rooms/" + entry.type + ".lua";
  const Result<std::string> include = session.files.text("rooms/include.lua");
  Status status = include ? sandbox.load(*include, "rooms/include.lua") : Status(Done{});
  if (!status) session.report(status.error().message);
  const Result<std::string> source = session.files.text(path);
  status = source ? sandbox.load(*source, path) : Status(source.error());
  if (status && sandbox.has("init")) {
    const Result<script::Value> called = sandbox.call("init");
    if (!called) status = called.error();
  }
  if (!status) session.report(entry.where + ": room " + entry.type + ": " + status.error().message);
  RoomSettings& settings = builder.plan.settings;
  if (settings.length == 0.0f) settings.length = builder.placed > 8.0f ? builder.placed : rules::kDefaultRoomLength;
  if (!builder.plan.effects.has(effects::Effect::Fog))
    builder.plan.effects.demand(effects::Effect::Fog, "by the game: every room has fog");
  return std::move(builder.plan);
}

}  // namespace brittle::sim
