#include "engine/render/renderer.h"

#include <algorithm>
#include <map>

#include "engine/core/assert.h"
#include "engine/core/profile.h"
#include "engine/effects/has/decals.h"
#include "engine/effects/has/depth_of_field.h"
#include "engine/effects/has/lasers.h"
#include "engine/effects/has/mirror.h"
#include "engine/effects/has/shadows.h"
#include "engine/effects/has/smoke.h"
#include "engine/effects/has/water.h"
#include "engine/render/passes.h"

namespace brittle::render {

namespace {

constexpr int kMaxPicture = 16384;  // [pixels]
bool blurs(const Frame& frame) {
  return effects::kHasDepthOfField && frame.focus.strength > 0.0f;
}

constexpr float kRefraction = 0.07f;  // how far aside tilted glass looks [picture heights]; chosen by eye

}  // namespace

/// A mesh group's GPU side and what the front end made of it this frame.
struct Group {
  std::uint64_t poolId;
  const geometry::MeshPool* pool;
  std::unique_ptr<MeshStore> store;
  DrawList list;
};

struct Renderer::Parts {
  Parts(const Gl& table, const RendererDef& definition, std::unique_ptr<Passes> made)
      : gl(table), def(definition), passes(std::move(made)) {}

  const Gl& gl;
  RendererDef def;
  std::unique_ptr<Passes> passes;
  std::unique_ptr<Target> target;
  std::vector<Material> materials;
  std::map<StaticId, StaticMesh> statics;
  StaticId nextStatic = 1;
  std::vector<Group> stores;   // of the pools seen in the last frame
  std::vector<Group*> groups;  // of this frame, farthest first
  DrawListBuilder builder;
  Instances instances;

  Group& storeOf(const MeshGroup& group);
  void syncGroups(const Frame& frame, const View& view);
  void drawRooms(const Frame& frame, bool polished);
  void drawMirrored(const Frame& frame, const FrameUniforms& uniforms);
  void drawOpaque(const Frame& frame);
  void drawShadows(const Frame& frame);
  void drawWaters(const Frame& frame);
  void drawTranslucent(const Frame& frame);
  void drawGlass();
  bool refracts() const;
};

Group& Renderer::Parts::storeOf(const MeshGroup& group) {
  const auto known = std::find_if(stores.begin(), stores.end(),
                                  [&](const Group& g) { return g.pool == group.pool && g.poolId == group.poolId; });
  if (known != stores.end()) return *known;
  stores.push_back({group.poolId, group.pool, std::make_unique<MeshStore>(gl), {}});
  return stores.back();
}

void Renderer::Parts::syncGroups(const Frame& frame, const View& view) {
  const auto isUsed = [&](const Group& g) {
    return std::any_of(frame.groups.begin(), frame.groups.end(),
                       [&](const MeshGroup& m) { return m.pool == g.pool && m.poolId == g.poolId; });
  };
  std::erase_if(stores, [&](const Group& g) { return !isUsed(g); });
  stores.reserve(kMaxGroups);  // pointers into it live as long as the frame
  groups.clear();
  const float farthest = minOf(frame.camera.farPlane, frame.fog.end);
  for (const MeshGroup& mesh : frame.groups) {
    if (mesh.pool == nullptr) continue;
    Group& group = storeOf(mesh);
    passes->counters().verticesUploaded += group.store->syncVertices(*mesh.pool);
    group.store->syncTables(mesh);
    builder.build(mesh, materials, view, farthest, group.list);
    groups.push_back(&group);
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const Group* a, const Group* b) { return a->list.nearestGlass > b->list.nearestGlass; });
}

void Renderer::Parts::drawRooms(const Frame& frame, bool polished) {
  for (const VisibleStatic& visible : frame.statics) {
    const auto mesh = statics.find(visible.id);
    if (mesh != statics.end()) passes->room(mesh->second, visible.offset, polished);
  }
}

void Renderer::Parts::drawMirrored(const Frame& frame, const FrameUniforms& uniforms) {
  if constexpr (effects::kHasMirror) {
    BR_ZONE("render mirror");
    passes->beginMirror(uniforms);
    drawRooms(frame, false);
    for (const Group* group : groups) passes->solid(*group->store, group->list.opaque);
    passes->spheres(instances.spheres);
    if constexpr (effects::kHasLasers) passes->lasers(instances.lasers);
    passes->endMirror();
  }
}

void Renderer::Parts::drawOpaque(const Frame& frame) {
  BR_ZONE("render opaque");
  for (const bool polished : {false, true}) drawRooms(frame, polished);
  for (const Group* group : groups) passes->solid(*group->store, group->list.opaque);
  passes->spheres(instances.spheres);
  passes->crumbs(instances.crumbs);
  if constexpr (effects::kHasDecals) passes->decals(instances.decals);
}

/// Whether something in this frame is looked through.
bool Renderer::Parts::refracts() const {
  return def.refraction && std::any_of(groups.begin(), groups.end(),
                                       [](const Group* g) { return !g->list.glass.empty() || !g->list.cuts.empty(); });
}

/// What lies on opaque surfaces: it is as much in focus as they are.
void Renderer::Parts::drawShadows(const Frame& frame) {
  BR_ZONE("render shadows");
  const bool seesThrough = refracts() || (!frame.waters.empty() && def.refraction);
  if (seesThrough || blurs(frame) || !instances.shadows.empty() || !instances.puffs.empty())
    target->copyDepth(kUnitDepth);
  if constexpr (effects::kHasShadows) passes->shadows(instances.shadows);
  drawWaters(frame);
}

void Renderer::Parts::drawWaters(const Frame& frame) {
  if (frame.waters.empty()) return;
  BR_ZONE("render water");
  if (def.refraction) target->copyColor(kUnitColor);
  if constexpr (effects::kHasWater)
    for (const Water& water : frame.waters) passes->water(water, def.refraction ? kRefraction : 0.0f);
}

void Renderer::Parts::drawGlass() {
  BR_ZONE("render glass");
  if (refracts()) target->copyColor(kUnitColor);
  for (const Group* group : groups) {
    for (const bool cut : {false, true})
      passes->glass(*group->store, cut ? group->list.cuts : group->list.glass, def.refraction ? kRefraction : 0.0f,
                    cut);
    passes->edges(*group->store, group->list.edges);
  }
  passes->beams(instances.beams);
  if constexpr (effects::kHasLasers) passes->lasers(instances.lasers);
  if constexpr (effects::kHasSmoke) passes->puffs(instances.puffs);
  passes->glows(instances.glows);
}

/// Nothing translucent is in the depth buffer, which the blur goes by: what of it is far away is drawn before the blur.
void Renderer::Parts::drawTranslucent(const Frame& frame) {
  drawShadows(frame);
  if constexpr (effects::kHasDepthOfField)
    if (blurs(frame)) {
      passes->choose(Passes::Part::Far, frame.focus);
      drawGlass();
      passes->focus(*target, frame.focus);
      passes->choose(Passes::Part::Near, frame.focus);
    }
  drawGlass();
}

Renderer::Renderer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Renderer::~Renderer() = default;

Result<std::unique_ptr<Renderer>> Renderer::create(Gl& gl, const RendererDef& def) {
  BR_ASSERT(def.samples == 0 || def.samples == 4);
  Result<std::unique_ptr<Passes>> passes = Passes::create(gl);
  if (!passes) return passes.error();
  std::unique_ptr<Parts> parts(new Parts(gl, def, std::move(*passes)));
  std::unique_ptr<Renderer> renderer(new Renderer(std::move(parts)));
  renderer->setMaterials(builtInMaterials());
  if (!renderer->makeTarget(def.width, def.height))
    return Error{"a picture of " + std::to_string(def.width) + " x " + std::to_string(def.height) +
                 " pixels: larger than the driver can make"};
  return renderer;
}

void Renderer::setMaterials(std::span<const Material> materials) {
  parts_->materials.assign(materials.begin(), materials.end());
  parts_->passes->setMaterials(makeMaterialUniforms(materials));
}

bool Renderer::makeTarget(int width, int height) {
  BR_ASSERT(width > 0 && height > 0 && width <= kMaxPicture && height <= kMaxPicture);
  parts_->target.reset();  // first, so that both never take memory at once
  parts_->target = std::make_unique<Target>(parts_->gl, width, height, parts_->def.samples, parts_->def.offscreen);
  return parts_->target->isComplete();
}

void Renderer::resize(int width, int height) {
  const bool isMade = makeTarget(width, height);
  BR_ASSERT(isMade);
}

StaticId Renderer::createStatic(std::span<const StaticVertex> vertices, std::span<const std::uint32_t> indices,
                                std::uint32_t polished) {
  BR_ASSERT(indices.size() % 3 == 0 && polished % 3 == 0 && polished <= indices.size());
  parts_->statics.try_emplace(parts_->nextStatic, parts_->gl, vertices, indices, polished);
  return parts_->nextStatic++;
}

void Renderer::destroyStatic(StaticId id) {
  parts_->statics.erase(id);
}

void Renderer::draw(const Frame& frame, const Overlay* overlay) {
  BR_ZONE("render");
  Parts& p = *parts_;
  const int width = p.target->width(), height = p.target->height();
  const View view = makeView(frame.camera, width, height);
  const FrameUniforms uniforms = makeFrameUniforms(frame, view, width, height);
  p.passes->begin(uniforms);
  p.syncGroups(frame, view);
  p.instances.pack(frame, view, width, height, p.def.shadows);

  p.target->bindScene();
  p.passes->background();
  if (frame.mirrorHeight) p.drawMirrored(frame, mirrored(uniforms, view, *frame.mirrorHeight));
  p.drawOpaque(frame);
  p.drawTranslucent(frame);
  p.passes->composite(*p.target, frame.bloom, frame.tint, frame.border);
  p.passes->hud(p.instances.hud);
  if (overlay != nullptr) p.passes->overlay(*overlay, width, height);
}

Image Renderer::readBack() {
  return parts_->target->readPicture();
}

const FrameCounters& Renderer::counters() const {
  return parts_->passes->counters();
}

}  // namespace brittle::render
