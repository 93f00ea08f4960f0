// view/statics.h - the baked meshes of the segments in sight, on the GPU: each look baked once and shared by all its
// places.
#pragma once

#include <map>
#include <span>
#include <string>

#include "engine/render/renderer.h"
#include "game/sim/frame_packet.h"

namespace brittle::view {

class Statics {
 public:
  /// `renderer` must outlive it.
  explicit Statics(render::Renderer& renderer) : renderer_(renderer) {}
  ~Statics() { clear(); }
  Statics(const Statics&) = delete;
  Statics& operator=(const Statics&) = delete;

  /// Appends the placed segments; bakes what is new, drops looks unseen for long.
  void show(std::span<const sim::RoomView> rooms, std::vector<render::VisibleStatic>& seen);
  void clear();
  std::size_t count() const { return meshes_.size(); }

 private:
  struct Mesh {
    render::StaticId id = 0;  // 0: nothing to see
    std::uint64_t lastSeen = 0;
  };
  render::StaticId meshOf(const sim::SegmentLook& look);
  void dropUnseen();

  render::Renderer& renderer_;
  std::map<std::string, Mesh> meshes_;  // by the look's name: one file, one look
  std::uint64_t shows_ = 0;
};

}  // namespace brittle::view
