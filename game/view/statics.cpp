#include "game/view/statics.h"

#include "engine/core/log.h"
#include "game/view/look.h"
#include "game/view/ready_mesh.h"

namespace brittle::view {
namespace {

/// Looks kept although nobody sees them, so that a repeated segment is not baked again. A mesh is about 100 kB, and may
/// have 8 MB if a file carries it.
constexpr std::size_t kKept = 64;
constexpr std::size_t kKeptBytes = 32u << 20;

std::size_t bytesOf(const render::BakedMesh& mesh) {
  return mesh.vertices.size() * sizeof(render::StaticVertex) + mesh.indices.size() * sizeof(std::uint32_t);
}

}  // namespace

render::StaticId Statics::meshOf(const sim::SegmentLook& look) {
  const auto known = meshes_.find(look.name);
  if (known != meshes_.end()) {
    known->second.lastSeen = shows_;
    return known->second.id;
  }
  Baking baking = take(look);
  render::BakedMesh mesh = std::move(baking.carried);
  append(baking.baker.finish(), mesh);
  const render::StaticId id =
      mesh.indices.empty() ? 0 : renderer_.createStatic(mesh.vertices, mesh.indices, mesh.polished);
  meshes_[look.name] = {id, bytesOf(mesh), shows_};
  bytes_ += bytesOf(mesh);
  return id;
}

void Statics::dropUnseen() {
  for (auto it = meshes_.begin(); it != meshes_.end() && (meshes_.size() > kKept || bytes_ > kKeptBytes);) {
    if (it->second.lastSeen == shows_) {
      ++it;
      continue;
    }
    if (it->second.id != 0) renderer_.destroyStatic(it->second.id);
    bytes_ -= it->second.bytes;
    ++dropped_;
    it = meshes_.erase(it);
  }
}

std::optional<render::BakedMesh> Statics::carriedBy(const sim::SegmentLook& look) {
  const std::string file = "segments/" + look.name + ".mesh";
  if (assets_ == nullptr || !assets_->has(file)) return std::nullopt;
  const Result<std::string> bytes = assets_->readStored(file);
  const content::BakedMesh mesh = bytes ? content::readBakedMesh(*bytes, file) : content::BakedMesh{};
  if (bytes && mesh.problems.empty()) return readyMesh(mesh, look);
  if (faulty_.insert(file).second) logWarning("content: " + (bytes ? mesh.problems[0].text() : bytes.error().message));
  return std::nullopt;
}

Statics::Baking Statics::begin(const sim::SegmentLook& look) {
  std::optional<render::BakedMesh> carried = carriedBy(look);
  const Baked rest = carried ? Baked::Stones : Baked::All;
  return {look.name, carried ? std::move(*carried) : render::BakedMesh{}, bakerOf(look, rest)};
}

Statics::Baking Statics::take(const sim::SegmentLook& look) {
  if (!baking_ || baking_->name != look.name) return begin(look);
  Baking baking = std::move(*baking_);
  baking_.reset();
  return baking;
}

void Statics::bakeAhead(const sim::SegmentLook& look) {
  if (!baking_ || baking_->name != look.name) {
    baking_ = begin(look);
  } else if (!baking_->baker.step()) {
    meshOf(look);
  }
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
  bytes_ = 0;
  baking_.reset();
}

}  // namespace brittle::view
