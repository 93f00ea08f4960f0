// view/statics.h - the baked meshes of the segments in sight, on the GPU: each look baked once and shared by all its
// places.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>

#include "engine/render/bake.h"
#include "game/sim/frame_packet.h"

namespace brittle::view {

class Statics {
 public:
  /// `renderer` must outlive it.
  explicit Statics(render::Renderer& renderer) : renderer_(renderer) {}
  ~Statics() { clear(); }
  Statics(const Statics&) = delete;
  Statics& operator=(const Statics&) = delete;

  /// Appends the placed segments of which something lies before the depth `farthest` [m] from a camera at `cameraZ`,
  /// and bakes those that are new. What comes into sight later is baked ahead, a face a call, so that no call takes
  /// long. Drops looks unseen for long.
  void show(std::span<const sim::RoomView> rooms, float cameraZ, float farthest,
            std::vector<render::VisibleStatic>& seen);
  void clear();
  std::size_t count() const { return meshes_.size(); }

 private:
  struct Mesh {
    render::StaticId id = 0;  // 0: nothing to see
    std::uint64_t lastSeen = 0;
  };
  /// A look on its way.
  struct Baking {
    std::string name;
    render::Baker baker;
  };
  render::StaticId meshOf(const sim::SegmentLook& look);
  render::Baker takeBaker(const sim::SegmentLook& look);
  void bakeAhead(const sim::SegmentLook& look);
  void dropUnseen();

  render::Renderer& renderer_;
  std::map<std::string, Mesh> meshes_;  // by the look's name: one file, one look
  std::optional<Baking> baking_;
  std::uint64_t shows_ = 0;
};

}  // namespace brittle::view
