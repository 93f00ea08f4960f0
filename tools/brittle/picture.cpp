#include "tools/brittle/picture.h"

#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "engine/render/bake.h"
#include "engine/render/gl.h"
#include "engine/render/renderer.h"

namespace brittle::program {
namespace {

/// By sim::Look.
std::vector<render::Material> materials() {
  using render::Look;
  return {{Look::Opaque, {0.80f, 0.82f, 0.84f}, 0.0f, 0.3f, 0.0f, 0.0f},
          {Look::Glass, {0.82f, 0.95f, 1.00f}, 0.0f, 0.9f, 0.85f, 0.9f},
          {Look::Opaque, {0.70f, 0.72f, 0.76f}, 0.9f, 0.7f, 0.0f, 0.0f},
          {Look::Opaque, {0.62f, 0.45f, 0.30f}, 0.0f, 0.2f, 0.0f, 0.0f},
          {Look::Opaque, {0.60f, 0.60f, 0.62f}, 0.0f, 0.2f, 0.0f, 0.0f},
          {Look::Glass, {0.55f, 0.85f, 1.00f}, 0.0f, 1.0f, 0.65f, 1.0f},
          {Look::Opaque, {0.85f, 0.86f, 0.90f}, 1.0f, 0.85f, 0.0f, 0.0f},
          {Look::Opaque, {0.75f, 0.76f, 0.80f}, 0.2f, 0.5f, 0.0f, 0.0f}};
}

/// The renderer wants colours as displays show them.
float encoded(float linear) {
  return linear <= 0.0f ? linear : std::pow(linear, 1.0f / 2.2f);
}
Vec3 encoded(const Vec3& color) {
  return {encoded(color.x()), encoded(color.y()), encoded(color.z())};
}

render::BakedMesh bakeLook(const sim::SegmentLook& look) {
  std::vector<render::BakeBox> boxes;
  for (const sim::LookBox& from : look.boxes) {
    render::BakeBox box;
    box.center = from.center;
    box.halfExtents = from.halfExtents;
    for (std::size_t i = 0; i < 3; ++i) {
      box.color[i] = encoded(from.color[i]);
      box.tile[i] = from.tile[i];
      box.tileSize[i] = from.tileSize[i];
      box.tileRotation[i] = from.tileRotation[i];
    }
    boxes.push_back(box);
  }
  render::BakeDef def;
  def.light = {look.light[0], look.light[1], look.light[2], look.light[3], look.light[4], look.light[5]};
  return render::bake(boxes, def);
}

}  // namespace

struct Picture::Parts {
  render::Gl gl;
  std::unique_ptr<render::Renderer> renderer;
  runtime::PictureSize size;
  sim::FramePacket packet;
  render::Frame frame;
  std::map<std::uint64_t, render::StaticId> statics;  // by PlacedSegment::id

  render::StaticId staticOf(const sim::PlacedSegment& segment) {
    const auto known = statics.find(segment.id);
    if (known != statics.end()) return known->second;
    const render::BakedMesh mesh = bakeLook(*segment.look);
    return statics[segment.id] = mesh.indices.empty() ? 0 : renderer->createStatic(mesh.vertices, mesh.indices);
  }

  void dropStatics() {
    std::map<std::uint64_t, render::StaticId> kept;
    for (const sim::RoomView& room : packet.rooms)
      for (const sim::PlacedSegment& segment : room.segments)
        if (const auto known = statics.find(segment.id); known != statics.end()) kept.insert(*known);
    for (const auto& [id, mesh] : statics)
      if (mesh != 0 && !kept.contains(id)) renderer->destroyStatic(mesh);
    statics = std::move(kept);
  }

  void addRoom(sim::Game& game, const sim::RoomView& room) {
    for (const sim::PlacedSegment& segment : room.segments)
      if (const render::StaticId id = staticOf(segment)) frame.statics.push_back({id, segment.origin});
    for (const sim::CrumbView& crumb : room.crumbs) frame.crumbs.push_back({crumb.position, crumb.radius, crumb.color});
    render::MeshGroup& group = frame.groups[room.slot];
    group.pool = game.meshes(room.slot);
    group.poolId = room.number + 1;
    for (const sim::BodyPose& body : room.bodies) group.bodies.push_back(body.pose);
    for (geometry::MeshSlot slot = 0; group.pool != nullptr && slot < group.pool->slotCount(); ++slot)
      if (group.pool->isAlive(slot) &&
          group.pool->info(slot).material != static_cast<std::uint16_t>(sim::Look::Static))  // baked already
        group.meshes.push_back(
            {slot, group.pool->info(slot).bodySlot, group.pool->info(slot).material, render::kWhite});
  }

  void addHud() {
    render::HudText balls;
    balls.at.anchor = Vec2(0.5f, 0.0f);
    balls.at.offset = Vec2(0.0f, 0.08f);
    balls.align = render::HudAlign::Center;
    balls.text = std::to_string(packet.hud.balls);
    frame.texts.push_back(balls);
    frame.border = Vec4(0.9f, 0.1f, 0.1f, packet.hud.pain);
  }

  void fill(sim::Game& game) {
    frame.clear();
    game.copyFrame(packet);
    dropStatics();
    frame.camera = {packet.camera.position, packet.camera.rotation, packet.camera.halfWidthTangent, 0.0f,
                    packet.camera.near,     packet.camera.far};
    for (const sim::RoomView& room : packet.rooms) addRoom(game, room);
    if (!packet.rooms.empty())
      frame.fog = {encoded(packet.rooms[0].fogBottom), encoded(packet.rooms[0].fogTop), packet.fogNear, packet.fogFull};
    for (const sim::BallView& ball : packet.balls)
      frame.spheres.push_back({ball.pose.position, ball.radius, ball.pose.rotation,
                               static_cast<std::uint16_t>(sim::Look::Ball), render::kWhite});
    addHud();
  }
};

Picture::Picture(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Picture::~Picture() = default;

Result<std::unique_ptr<Picture>> Picture::create(runtime::Platform& platform, int samples) {
  auto parts = std::make_unique<Parts>();
  Result<render::Gl> gl = render::loadGl(platform.glLoader());
  if (!gl) return gl.error();
  parts->gl = std::move(*gl);
  parts->size = platform.size();
  render::RendererDef def;
  def.width = parts->size.width;
  def.height = parts->size.height;
  def.samples = samples;
  def.offscreen = !platform.hasDefaultFramebuffer();
  auto renderer = render::Renderer::create(parts->gl, def);
  if (!renderer) return renderer.error();
  parts->renderer = std::move(*renderer);
  parts->renderer->setMaterials(materials());
  return std::unique_ptr<Picture>(new Picture(std::move(parts)));
}

void Picture::ticked(sim::Game&) {}

void Picture::restarted() {}

void Picture::draw(sim::Game& game, float, runtime::PictureSize size, bool) {
  if (size.width < 1 || size.height < 1) return;  // a window that is minimised
  if (!(size == parts_->size)) parts_->renderer->resize(size.width, size.height);
  parts_->size = size;
  parts_->fill(game);
  parts_->renderer->draw(parts_->frame);
}

render::Image Picture::readBack() {
  return parts_->renderer->readBack();
}

}  // namespace brittle::program
