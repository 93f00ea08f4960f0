// view/scene.h - a game as a picture: the packets of the last ticks become a render::Frame. Reads copied packets only,
// never the live simulation; the mesh pools are passed in for the renderer to mirror. Used by the program, for windows
// and for replays alike.
#pragma once

#include <array>

#include "game/view/hud.h"
#include "game/view/memory.h"
#include "game/view/omission.h"
#include "game/view/statics.h"

namespace brittle::view {

/// By room slot (Game::meshes); null where there is no room.
using MeshPools = std::array<geometry::MeshPool*, render::kMaxGroups>;

class Scene {
 public:
  /// `renderer` and `assets` must outlive it; the renderer gets this view's materials. `assets`: the game's, where
  /// segments may carry meshes (Statics); null: without.
  explicit Scene(render::Renderer& renderer, const content::AssetSource* assets = nullptr);

  /// After each tick of the game, and once before the first.
  void tick(const sim::FramePacket& packet);
  /// Another game, or another place in a replay, follows: forgets everything.
  void reset();

  /// The picture `alpha` of the way (0 to 1) between the last two ticks. Depends on the packets of the last
  /// kMemoryTicks ticks, the pools and the arguments only. The frame points into `pools`: draw it before the game goes
  /// on. `aspect`: width over height. `timings`: shown unless null.
  const render::Frame& build(float alpha, float aspect, const MeshPools& pools, bool paused = false,
                             const Timings* timings = nullptr);
  /// What was left out of the pictures built so far: of each kind that is not zero.
  std::vector<NamedCount> omissions() const;

 private:
  void addRooms(const MeshPools& pools);
  void addLamps();
  void addThings();
  void addGlows(double tick);
  void placeFocus(float entered);
  void placeCamera(double tick, float aspect);
  /// The game's time, `alpha` of the way between the last two ticks. [ticks]
  double timeAt(float alpha) const;

  Statics statics_;
  std::vector<render::Material> materials_;
  Memory memory_;
  sim::FramePacket before_, now_, seen_;
  float alpha_ = 1.0f;  // of the picture that is built
  render::Frame frame_;
  Bounds bounds_;
  std::uint64_t resets_ = 0;
};

}  // namespace brittle::view
