#include "game/sim/obstacle.h"

#include "engine/core/random.h"
#include "engine/physics/world.h"
#include "game/sim/obstacle_api.h"
#include "game/sim/room.h"

namespace brittle::sim {

Transform Obstacle::pose() const {
  return {Vec3(def->position + Vec3(0.0f, 0.0f, room->shift())), rotationXyz(def->rotation)};
}

float Obstacle::age() const {
  return static_cast<float>(ticks) + static_cast<float>(room->time().partAfter()) / kWholeTick;
}

int Obstacle::numberOf(physics::BodyHandle handle) {
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].handle == handle) return static_cast<int>(i) + 1;
  if (!room->world().isAlive(handle) || bodies.size() >= rules::kMaxBodiesPerObstacle) return 0;
  ScriptBody body;
  body.handle = handle;
  body.assembly = room->world().body(handle).assembly;
  bodies.push_back(body);
  return static_cast<int>(bodies.size());
}

Status Obstacle::load() {
  const std::string file = "obstacles/" + def->type + ".lua";
  const Result<std::string> source = room->readScript(file);
  if (!source) return source.error();
  if (source->size() > rules::kLongestScript)
    return errorAt(
        file, 0, std::to_string(source->size()) + " bytes, expected at most " + std::to_string(rules::kLongestScript));
  script::Limits limits;
  scriptHashed_ = false;
  limits.instructions = rules::kScriptInstructions;
  limits.memoryBytes = rules::kScriptMemory;
  limits.largestBlockBytes = rules::kScriptMemory / 4;
  limits.longestString = rules::kScriptMemory / 16;
  script = std::make_unique<script::Sandbox>(obstacleLibrary(), mixSeed(room->seed(), number), limits, this);
  return script->load(*source, file);
}

std::int64_t Obstacle::start() {
  stage = Stage::Alive;
  Status status = load();
  std::int64_t cost = rules::kStartPrice + (script ? script->instructionsUsed() : 0);
  if (status && script->has("init")) {
    const Result<script::Value> called = script->call("init");
    cost += script->instructionsUsed();
    if (!called) status = called.error();
  }
  if (!status) {
    room->session().reportMissing("obstacle " + def->type, def->where, status.error().message);
    failed = true;
  }
  physics::World& world = room->world();
  for (ScriptBody& body : bodies) {
    if (!body.handle || !world.isAlive(body.handle)) continue;
    const physics::Body& made = world.body(body.handle);
    if (made.userData == number && made.type == physics::BodyType::Static && made.breaking.strength > 0.0f)
      world.anchor(body.handle);
  }
  return cost;
}

void Obstacle::setDown(ScriptButton& button, bool down) {
  button.down = down;
  physics::World& world = room->world();
  const physics::BodyHandle handle = bodies[button.body - 1].handle;
  if (!world.isAlive(handle) || !world.body(handle).firstShape) return;
  const std::uint32_t color = down ? packColor(0.25f, 0.85f, 0.60f, 1.0f) : packColor(1.0f, 0.42f, 0.16f, 1.0f);
  world.meshes().setColor(world.shape(world.body(handle).firstShape).mesh, color);
}

std::int64_t Obstacle::tickScript(bool mayRun) {
  laser = false;
  beams.clear();
  decals.clear();
  if (room->time().isWhole()) ++ticks;
  const std::int64_t cost = mayRun ? callScript("tick") : 0;
  for (ScriptButton& button : buttons) button.justPressed = false;
  return cost;
}

std::int64_t Obstacle::drawScript(bool mayRun) {
  return mayRun ? callScript("draw") : 0;
}

std::int64_t Obstacle::callScript(const char* function) {
  if (failed || !script || !script->has(function)) return 0;
  scriptHashed_ = false;
  const Result<script::Value> called = script->call(function);
  if (!called) {
    room->session().reportMissing("obstacle " + def->type, def->where, called.error().message);
    failed = true;  // its bodies stay as they are
  }
  return script->instructionsUsed();
}

bool Obstacle::restoreScript(ByteReader& in) {
  const bool saved = in.read<bool>();
  script.reset();
  if (!saved) return in.ok();
  muted = true;
  const Status loaded = load();
  muted = false;
  // A script that failed while loading saved what it had by then: the same again.
  (void)loaded;
  return script && static_cast<bool>(script->restore(in)) && in.ok();
}

void Obstacle::saveScript(ByteWriter& out) const {
  ByteWriter saved;
  const bool isSaved = script && static_cast<bool>(script->save(saved));
  if (script && !isSaved)
    room->session().report(def->where + ": obstacle " + def->type + ": its state cannot be saved");
  out.write(isSaved);
  out.writeBytes(saved.bytes().data(), saved.bytes().size());
}

std::uint64_t Obstacle::scriptHash() const {
  if (!scriptHashed_ && script) {
    ByteWriter saved;
    const Status status = script->save(saved);
    scriptHash_ = status ? hashBytes(saved.bytes().data(), saved.bytes().size()) : 1;
    scriptHashed_ = true;
  }
  return script ? scriptHash_ : 0;
}

const script::Library& obstacleLibrary() {
  static const script::Library library = [] {
    script::Library made;
    addShapeCalls(made);
    addJointCalls(made);
    addMotionCalls(made);
    addQueryCalls(made);
    addPlayCalls(made);
    return made;
  }();
  return library;
}

void addCall(script::Library& library, const char* name, void (*native)(script::Call&, Obstacle&)) {
  library.add(name, [native](script::Call& call) {
    Obstacle& obstacle = call.user<Obstacle>();
    if (obstacle.muted) return call.result(0);
    native(call, obstacle);
  });
}

Vec3 readVector(script::Call& call, int first, float most) {
  const float x = call.real(first);
  const float y = call.real(first + 1);
  const float z = call.real(first + 2);
  const Vec3 vector(x, y, z);
  if (!(vector.cwiseAbs().maxCoeff() <= most))
    call.fail("arguments " + std::to_string(first) + " to " + std::to_string(first + 2) + ": expected numbers up to " +
              std::to_string(static_cast<int>(most)));
  return vector;
}

Vec3 readVector(script::Call& call, int first, float most, const Vec3& otherwise) {
  return call.has(first) ? readVector(call, first, most) : otherwise;
}

void answer(script::Call& call, const Vec3& vector) {
  for (int i = 0; i < 3; ++i) call.result(vector[i]);
}

Vec3 anglesOf(const Quat& rotation) {
  const Mat3 m = rotation.toRotationMatrix();
  return Vec3(arcTangent(m(2, 1), m(2, 2)), arcSine(-m(2, 0)), arcTangent(m(1, 0), m(0, 0)));
}

ScriptBody* readBody(script::Call& call, Obstacle& obstacle, int index) {
  constexpr int searchPrice = 500;  // of a broken one its pieces are looked for among all bodies
  const int number = call.integer(index);
  if (call.failed()) return nullptr;
  ScriptBody* body = obstacle.bodyAt(number);
  if (body == nullptr)
    call.fail("no body " + std::to_string(number));
  else if (body->handle && !obstacle.room->world().isAlive(body->handle))
    call.charge(searchPrice);
  return body;
}

void chargeForShapes(script::Call& call, const Obstacle& obstacle, const ScriptBody& body, int base, int each) {
  const physics::World& world = obstacle.room->world();
  const physics::BodyHandle handle = currentBody(obstacle, body);
  const std::int64_t shapes = handle && world.isAlive(handle) ? world.body(handle).shapeCount : 0;
  call.charge(base + each * shapes);
}

void chargeForRay(script::Call& call, const Obstacle& obstacle, const Vec3& from, const Vec3& to) {
  constexpr std::int64_t base = 200, each = 3;
  call.charge(base + each * obstacle.room->crowdBetween(from, to));
}

void refuseMore(script::Call& call, const Obstacle& obstacle, const std::string& why) {
  obstacle.room->session().omissions.add(Omission::RefusedContent);
  call.fail(why);
}

bool hasPlaceForBody(script::Call& call, const Obstacle& obstacle) {
  const bool hasPlace = obstacle.bodies.size() < rules::kMaxBodiesPerObstacle && obstacle.room->hasPlaceForBody();
  if (!hasPlace)
    refuseMore(call, obstacle,
               "too many bodies: expected at most " + std::to_string(rules::kMaxBodiesPerObstacle) +
                   " of an obstacle and " + std::to_string(rules::kMaxBodiesPerRoom) + " in a room");
  return hasPlace;
}

physics::BodyHandle currentBody(const Obstacle& obstacle, const ScriptBody& body) {
  const physics::World& world = obstacle.room->world();
  if (!body.handle || world.isAlive(body.handle)) return body.handle;
  std::vector<physics::BodyHandle> pieces;
  world.bodiesOf(body.assembly, pieces);
  return pieces.empty() ? physics::BodyHandle{} : pieces.front();
}

}  // namespace brittle::sim
