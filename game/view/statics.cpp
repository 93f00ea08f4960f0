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
  const render::BakedMesh baked = bakeSegment(look);
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

void Statics::show(std::span<const sim::RoomView> rooms, std::vector<render::VisibleStatic>& seen) {
  ++shows_;
  for (const sim::RoomView& room : rooms)
    for (const sim::PlacedSegment& segment : room.segments)
      if (const render::StaticId id = meshOf(*segment.look)) seen.push_back({id, segment.origin});
  dropUnseen();
}

void Statics::clear() {
  for (const auto& [name, mesh] : meshes_)
    if (mesh.id != 0) renderer_.destroyStatic(mesh.id);
  meshes_.clear();
}

}  // namespace brittle::view
