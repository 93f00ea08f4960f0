// view/statics.h - the baked meshes of the segments in sight, on the GPU: each look read or baked once and shared by
// all its places.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>

#include "engine/render/bake.h"
#include "game/content/asset_source.h"
#include "game/sim/frame_packet.h"

namespace brittle::view {

class Statics {
 public:
  /// `renderer` and `assets` must outlive it. `assets`: holds meshes that were baked by a segment's author
  /// (content/baked_mesh.h), drawn in place of its boxes; null: none are looked for. What is wrong with one is logged
  /// once, and its boxes are drawn.
  explicit Statics(render::Renderer& renderer, const content::AssetSource* assets = nullptr)
      : renderer_(renderer), assets_(assets) {}
  ~Statics() { clear(); }
  Statics(const Statics&) = delete;
  Statics& operator=(const Statics&) = delete;

  /// Appends the placed segments of which something lies before the depth `farthest` [m] from a camera at `cameraZ`,
  /// and bakes those that are new. What comes into sight later is read and baked ahead, a face a call, so that no call
  /// takes long. Drops looks unseen for long.
  void show(std::span<const sim::RoomView> rooms, float cameraZ, float farthest,
            std::vector<render::VisibleStatic>& seen);
  void clear();
  std::size_t count() const { return meshes_.size(); }
  /// Looks dropped so far because nobody saw them.
  std::uint64_t dropped() const { return dropped_; }

 private:
  struct Mesh {
    render::StaticId id = 0;  // 0: nothing to see
    std::size_t bytes = 0;    // of it on the GPU
    std::uint64_t lastSeen = 0;
  };
  /// A look on its way.
  struct Baking {
    std::string name;
    render::BakedMesh carried;  // by its file
    render::Baker baker;        // of the boxes that are not in it
  };
  render::StaticId meshOf(const sim::SegmentLook& look);
  std::optional<render::BakedMesh> carriedBy(const sim::SegmentLook& look);
  Baking begin(const sim::SegmentLook& look);
  Baking take(const sim::SegmentLook& look);
  void bakeAhead(const sim::SegmentLook& look);
  void dropUnseen();

  render::Renderer& renderer_;
  const content::AssetSource* assets_;
  std::set<std::string> faulty_;        // files that something was wrong with
  std::map<std::string, Mesh> meshes_;  // by the look's name: one file, one look
  std::size_t bytes_ = 0;               // of all of them
  std::optional<Baking> baking_;
  std::uint64_t shows_ = 0, dropped_ = 0;
};

}  // namespace brittle::view
