// The calls of obstacle scripts that choose a material and build bodies and shapes.
#include <vector>

#include "engine/geometry/make.h"
#include "engine/physics/world.h"
#include "game/sim/obstacle_api.h"
#include "game/sim/room.h"
#include "game/sim/unit_mesh.h"

namespace brittle::sim {

namespace {

physics::BodyType bodyTypeOf(const Material& material) {
  if (material.staticMode == 1) return physics::BodyType::Static;
  if (material.staticMode == 2) return physics::BodyType::Animated;
  return physics::BodyType::Dynamic;
}

Vec3 extentOf(const geometry::Convex& convex) {
  Aabb box;
  for (const geometry::Vertex& vertex : convex.vertices) box.include(vertex.point);
  return box.extent();
}

/// The first shape decides what kind of body it is: only then is the sticky state known.
void makeBody(Obstacle& obstacle, ScriptBody& body, const physics::Breakable& breakable) {
  physics::BodyDef def;
  def.type = bodyTypeOf(obstacle.pen.material);
  def.pose = obstacle.pose() * body.pose;
  def.userData = obstacle.number;
  def.breakable = breakable;
  physics::World& world = obstacle.room->world();
  body.handle = world.createBody(def);
  body.assembly = world.body(body.handle).assembly;
}

Look lookOf(const Material& material) {
  return material.look == Look::Glass && material.category == rules::kCategoryCrystal ? Look::Crystal : material.look;
}

/// A body is as strong as its weakest shape, but never too weak for its own weight: the format's force limits do not
/// grow with size.
void strengthen(physics::World& world, ScriptBody& body, physics::Breakable breakable) {
  if (breakable.strength <= 0.0f) return;
  if (body.strength > 0.0f && body.strength < breakable.strength) breakable = world.body(body.handle).breaking;
  body.strength = body.strength > 0.0f ? minOf(body.strength, breakable.strength) : breakable.strength;
  const float weight = world.body(body.handle).mass * rules::kGravity * rules::kTickSeconds;
  breakable.strength = maxOf(body.strength, rules::kWeightsHeld * weight);
  world.setBreakable(body.handle, breakable);
}

/// What breaks leaves pieces too small to be bodies, and is seen to.
void demandBreaking(Room& room, const std::string& who) {
  room.demand(effects::Effect::Fracture, who);
  room.demand(effects::Effect::Debris, who);
  room.demand(effects::Effect::Splinters, who);
}

void addShape(script::Call& call, Obstacle& obstacle, geometry::Convex convex, int firstPlaceArgument) {
  ScriptBody* body = readBody(call, obstacle, 1);
  const Vec3 offset = readVector(call, firstPlaceArgument, rules::kFarthest, Vec3::Zero());
  const Vec3 angles = readVector(call, firstPlaceArgument + 3, rules::kMostAngle, Vec3::Zero());
  if (call.failed() || body == nullptr) return;
  if (obstacle.shapes.size() >= rules::kMaxShapesPerObstacle || !obstacle.room->hasPlaceForShape())
    return refuseMore(call, obstacle,
                      "too many shapes: expected at most " + std::to_string(rules::kMaxShapesPerObstacle) +
                          " of an obstacle and " + std::to_string(rules::kMaxShapesPerRoom) + " in a room");
  const Pen& pen = obstacle.pen;
  convex = geometry::transformed(convex, rotationXyz(angles), offset, pen.scale);
  const std::uint32_t color = packColor(pen.color[0], pen.color[1], pen.color[2], pen.color[3]);
  for (geometry::Vertex& vertex : convex.vertices) vertex.color = color;

  physics::World& world = obstacle.room->world();
  physics::Breakable breakable = breakableOf(pen.material, extentOf(convex));
  if (breakable.strength > 0.0f && body->strength <= 0.0f) demandBreaking(*obstacle.room, call.where());
  if (!obstacle.room->runs(effects::Effect::Fracture)) breakable.strength = 0.0f;
  if (!body->handle) {
    makeBody(obstacle, *body, breakable);
    body->look = lookOf(pen.material);
  } else if (!world.isAlive(body->handle)) {
    return call.result(0);
  }
  physics::ShapeDef def;
  def.surface = surfaceOf(pen.material);
  def.drawMaterial = static_cast<std::uint16_t>(lookOf(pen.material));
  def.userData = static_cast<std::uint32_t>(obstacle.shapes.size()) + 1;
  ScriptShape shape;
  shape.handle = world.addConvex(body->handle, def, convex);
  shape.body = static_cast<std::uint32_t>(body - obstacle.bodies.data()) + 1;
  body->volume += world.shape(shape.handle).massProperties.volume;
  strengthen(world, *body, breakable);
  obstacle.shapes.push_back(shape);
  call.result(static_cast<int>(obstacle.shapes.size()));
}

float sizeArgument(script::Call& call, int index) {
  const float size = call.real(index);
  if (!call.failed() && !(size >= 0.001f && size <= 500.0f))
    call.fail("size " + std::to_string(size) + ": expected 0.001 to 500");
  return size;
}

void createBody(script::Call& call, Obstacle& obstacle) {
  const Vec3 position = readVector(call, 1, rules::kFarthest, Vec3::Zero());
  const Vec3 angles = readVector(call, 4, rules::kMostAngle, Vec3::Zero());
  if (call.failed()) return;
  if (!hasPlaceForBody(call, obstacle)) return;
  ScriptBody body;
  body.pose = {position, rotationXyz(angles)};
  obstacle.bodies.push_back(body);
  call.result(static_cast<int>(obstacle.bodies.size()));
}

void createBox(script::Call& call, Obstacle& obstacle) {
  const float x = sizeArgument(call, 2);
  const float y = sizeArgument(call, 3);
  const float z = sizeArgument(call, 4);
  if (!call.failed()) addShape(call, obstacle, geometry::makeBox<float>(Vec3(x, y, z)), 5);
}

void createCylinder(script::Call& call, Obstacle& obstacle) {
  const float radius = sizeArgument(call, 2);
  const float half = sizeArgument(call, 3);
  if (!call.failed()) addShape(call, obstacle, geometry::makeCylinder(radius, half, rules::kCylinderSides), 4);
}

void createMesh(script::Call& call, Obstacle& obstacle) {
  Result<geometry::Convex> mesh = unitMesh(call.string(2));
  if (call.failed()) return;
  if (!mesh) return call.fail(mesh.error().message);
  addShape(call, obstacle, std::move(*mesh), 3);
}

void clearShapes(script::Call& call, Obstacle& obstacle) {
  ScriptBody* body = readBody(call, obstacle, 1);
  if (call.failed() || body == nullptr) return;
  physics::World& world = obstacle.room->world();
  for (const ScriptShape& shape : obstacle.shapes)
    if (world.isAlive(shape.handle) && world.bodyOf(shape.handle) == body->handle) world.removeShape(shape.handle);
}

/// The shape of argument 1 if it still is as it was made; null, without a failure, once it is broken or gone.
ScriptShape* readWholeShape(script::Call& call, Obstacle& obstacle) {
  const int number = call.integer(1);
  if (call.failed()) return nullptr;
  if (number < 1 || number > static_cast<int>(obstacle.shapes.size())) {
    call.fail("no shape " + std::to_string(number));
    return nullptr;
  }
  ScriptShape& shape = obstacle.shapes[static_cast<std::size_t>(number) - 1];
  const physics::World& world = obstacle.room->world();
  return world.isAlive(shape.handle) && !world.shape(shape.handle).isPiece ? &shape : nullptr;
}

/// A body's mass is summed up anew over its shapes.
void chargeForRemaking(script::Call& call, const Obstacle& obstacle, const ScriptShape& shape) {
  chargeForShapes(call, obstacle, obstacle.bodies[shape.body - 1], 500, 20);
}

/// The same shape with another surface, `offset` [m] away in its body's frame. Joints that held it are gone.
void remake(Obstacle& obstacle, ScriptShape& made, const physics::Surface& surface, const Vec3& offset) {
  physics::World& world = obstacle.room->world();
  const physics::Shape old = world.shape(made.handle);
  physics::ShapeDef def;
  def.surface = surface;
  def.anchored = old.anchored;
  def.drawMaterial = old.drawMaterial;
  def.drawFlags = old.drawFlags;
  def.userData = old.userData;
  const geometry::Convex convex = geometry::transformed(world.meshes().view(old.mesh), Quat::Identity(), offset);
  const physics::ShapeHandle moved = world.addConvex(old.body, def, convex);
  world.removeShape(made.handle);
  made.handle = moved;
}

/// Moves a shape within its body: by a way, or with a last argument of false to a place relative to where it was made.
void translateShape(script::Call& call, Obstacle& obstacle) {
  const Vec3 way = readVector(call, 2, rules::kFarthest);
  const bool isRelative = call.boolean(5, true);
  ScriptShape* shape = readWholeShape(call, obstacle);
  if (call.failed() || shape == nullptr) return;
  chargeForRemaking(call, obstacle, *shape);
  const Vec3 moved = isRelative ? Vec3(shape->moved + way) : way;
  if (!(moved.cwiseAbs().maxCoeff() <= rules::kFarthest)) return call.fail("the shape leaves the room");
  remake(obstacle, *shape, obstacle.room->world().shape(shape->handle).surface, moved - shape->moved);
  shape->moved = moved;
}

void setShapeMask(script::Call& call, Obstacle& obstacle) {
  Material bits = obstacle.pen.material;
  bits.mask = static_cast<std::uint32_t>(call.integer(2));
  const int category = call.integer(3, 0);
  ScriptShape* shape = readWholeShape(call, obstacle);
  if (call.failed() || shape == nullptr) return;
  chargeForRemaking(call, obstacle, *shape);
  physics::Surface surface = obstacle.room->world().shape(shape->handle).surface;
  surface.mask = surfaceOf(bits).mask;
  if (call.has(3)) surface.category = static_cast<std::uint32_t>(category);
  remake(obstacle, *shape, surface, Vec3::Zero());
}

void setMaterial(script::Call& call, Obstacle& obstacle) {
  const std::string name = call.string(1);
  if (call.failed()) return;
  const auto material = findMaterial(obstacle.room->session().files.materials(), name);
  if (!material) return call.fail("material \"" + name + "\": unknown");
  obstacle.pen.material = *material;
}

void setColor(script::Call& call, Obstacle& obstacle) {
  const float r = call.real(1);
  const float g = call.real(2);
  const float b = call.real(3);
  const float a = call.real(4, 1.0f);
  if (call.failed()) return;
  const float values[4] = {r, g, b, a};
  for (int i = 0; i < 4; ++i) obstacle.pen.color[i] = values[i];
}

void setShapeColor(script::Call& call, Obstacle& obstacle) {
  const int number = call.integer(1);
  const float r = call.real(2);
  const float g = call.real(3);
  const float b = call.real(4);
  if (call.failed()) return;
  if (number < 1 || number > static_cast<int>(obstacle.shapes.size()))
    return call.fail("no shape " + std::to_string(number));
  physics::World& world = obstacle.room->world();
  const physics::ShapeHandle shape = obstacle.shapes[static_cast<std::size_t>(number) - 1].handle;
  if (world.isAlive(shape)) world.meshes().setColor(world.shape(shape).mesh, packColor(r, g, b, 1.0f));
}

void addPenCalls(script::Library& library) {
  addCall(library, "mgMaterial", setMaterial);
  addCall(library, "mgColor", setColor);
  addCall(library, "mgDensity", [](script::Call& call, Obstacle& o) {
    const float density = call.real(1);
    if (!call.failed()) o.pen.material.density = clampTo(density, 0.001f, 1000.0f);
  });
  addCall(library, "mgForceLimit", [](script::Call& call, Obstacle& o) {
    const float limit = call.real(1);
    if (!call.failed()) o.pen.material.forceLimit = clampTo(limit, 0.0f, 1000.0f);
  });
  addCall(library, "mgStatic", [](script::Call& call, Obstacle& o) {
    const int mode = call.has(1) ? call.integer(1) : 1;
    if (!call.failed()) o.pen.material.staticMode = clampTo(mode, 0, 2);
  });
  addCall(library, "mgCategory", [](script::Call& call, Obstacle& o) {
    const int bits = call.integer(1);
    if (!call.failed()) o.pen.material.category = static_cast<std::uint32_t>(bits);
  });
  addCall(library, "mgMask", [](script::Call& call, Obstacle& o) {
    const int bits = call.integer(1);
    if (!call.failed()) o.pen.material.mask = static_cast<std::uint32_t>(bits);
  });
  addCall(library, "mgShapeScale", [](script::Call& call, Obstacle& o) {
    const float x = sizeArgument(call, 1);
    const float y = call.has(2) ? sizeArgument(call, 2) : x;
    const float z = call.has(3) ? sizeArgument(call, 3) : x;
    if (!call.failed()) o.pen.scale = Vec3(x, y, z);
  });
}

}  // namespace

void addShapeCalls(script::Library& library) {
  addPenCalls(library);
  addCall(library, "mgCreateBody", createBody);
  addCall(library, "mgCreateBox", createBox);
  addCall(library, "mgCreateCylinder", createCylinder);
  addCall(library, "mgCreateMesh", createMesh);
  addCall(library, "mgClearShapes", clearShapes);
  addCall(library, "mgSetShapeColor", setShapeColor);
  addCall(library, "mgTranslateShape", translateShape);
  addCall(library, "mgSetShapeMask", setShapeMask);
}

}  // namespace brittle::sim
