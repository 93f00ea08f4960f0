#include "tools/brittle/picture.h"

#include <optional>
#include <utility>

#include "engine/render/gl.h"
#include "engine/render/renderer.h"
#include "game/view/scene.h"

namespace brittle::program {
namespace {

std::optional<view::Timings> timingsOf(const runtime::FrameTimes* times, const std::vector<NamedCount>& heard) {
  if (times == nullptr) return std::nullopt;
  const auto ms = [](double seconds) { return static_cast<float>(seconds * 1000.0); };
  return view::Timings{ms(times->frame), ms(times->simulate), ms(times->draw),
                       ms(times->swap),  ms(times->longest),  heard};
}

}  // namespace

struct Picture::Parts {
  render::Gl gl;
  std::unique_ptr<render::Renderer> renderer;
  std::unique_ptr<view::Scene> scene;
  runtime::PictureSize size;
  sim::FramePacket packet;  // kept for its memory
};

Picture::Picture(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Picture::~Picture() = default;

Result<std::unique_ptr<Picture>> Picture::create(runtime::Platform& platform, int samples,
                                                 const content::AssetSource& assets) {
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
  parts->scene = std::make_unique<view::Scene>(*parts->renderer, &assets);
  return std::unique_ptr<Picture>(new Picture(std::move(parts)));
}

void Picture::ticked(sim::Game& game) {
  game.copyFrame(parts_->packet);
  parts_->scene->tick(parts_->packet);
}

const sim::FramePacket& Picture::packet() const {
  return parts_->packet;
}

void Picture::restarted() {
  parts_->scene->reset();
}

void Picture::draw(sim::Game& game, const runtime::Shown& shown, const render::Overlay* overlay,
                   const std::vector<NamedCount>& heard) {
  const runtime::PictureSize size = shown.size;
  if (size.width < 1 || size.height < 1) return;  // a window that is minimised
  if (!(size == parts_->size)) parts_->renderer->resize(size.width, size.height);
  parts_->size = size;
  const float aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
  const std::optional<view::Timings> timings = timingsOf(shown.times, heard);
  parts_->renderer->draw(parts_->scene->build(shown.alpha, aspect, {game.meshes(0), game.meshes(1)}, shown.paused,
                                              timings ? &*timings : nullptr),
                         overlay);
}

std::vector<NamedCount> Picture::omissions() const {
  return parts_->scene->omissions();
}

render::Image Picture::readBack() {
  return parts_->renderer->readBack();
}

}  // namespace brittle::program
