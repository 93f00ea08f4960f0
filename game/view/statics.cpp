#include "game/view/statics.h"

#include "game/view/look.h"

namespace brittle::view {
namespace {

/// Looks kept although nobody sees them, so that a repeated segment is not baked again. A mesh is about 100 kB.
constexpr std::size_t kKept = 64;

}  // namespace

render::StaticId Statics::meshOf(const sim::SegmentLook& look) {
  const auto known = meshes_.find(look.name);
  if (known != meshes_.end()) {
    known->second.lastSeen = shows_;
    return known->second.id;
  }
  const render::BakedMesh baked = takeBaker(look).finish();
  const render::StaticId id =
      baked.indices.empty() ? 0 : renderer_.createStatic(baked.vertices, baked.indices, baked.polished);
  meshes_[look.name] = {id, shows_};
  return id;
}

void Statics::dropUnseen() {
  for (auto it = meshes_.begin(); it != meshes_.end() && meshes_.size() > kKept;) {
    if (it->second.lastSeen == shows_) {
      ++it;
      continue;
    }
    if (it->second.id != 0) renderer_.destroyStatic(it->second.id);
    it = meshes_.erase(it);
  }
}

render::Baker Statics::takeBaker(const sim::SegmentLook& look) {
  if (!baking_ || baking_->name != look.name) return bakerOf(look);
  render::Baker baker = std::move(baking_->baker);
  baking_.reset();
  return baker;
}

void Statics::bakeAhead(const sim::SegmentLook& look) {
  if (!baking_ || baking_->name != look.name) baking_ = {look.name, bakerOf(look)};
  if (!baking_->baker.step()) meshOf(look);
}

void Statics::show(std::span<const sim::RoomView> rooms, float cameraZ, float farthest,
                   std::vector<render::VisibleStatic>& seen) {
  ++shows_;
  const sim::SegmentLook* next = nullptr;  // to come into sight
  for (const sim::RoomView& room : rooms)
    for (const sim::PlacedSegment& segment : room.segments) {
      if (cameraZ - segment.origin.z() < farthest) {
        if (const render::StaticId id = meshOf(*segment.look)) seen.push_back({id, segment.origin});
      } else if (next == nullptr && !meshes_.contains(segment.look->name)) {
        next = segment.look.get();
      }
    }
  if (next != nullptr) bakeAhead(*next);
  dropUnseen();
}

void Statics::clear() {
  for (const auto& [name, mesh] : meshes_)
    if (mesh.id != 0) renderer_.destroyStatic(mesh.id);
  meshes_.clear();
  baking_.reset();
}

}  // namespace brittle::view
