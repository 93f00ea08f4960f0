// brittle/picture.h - draws a game through game/view, off-screen or into a window. The one place of the program that
// holds GL.
#pragma once

#include <memory>

#include "engine/core/result.h"
#include "engine/render/capture.h"
#include "engine/render/overlay.h"
#include "engine/runtime/loop.h"
#include "game/content/asset_source.h"
#include "game/sim/game.h"

namespace brittle::program {

class Picture {
 public:
  /// For the platform's current context. `samples`: multisampling, 0 or 4. `assets`: the games'; must outlive it.
  static Result<std::unique_ptr<Picture>> create(runtime::Platform& platform, int samples,
                                                 const content::AssetSource& assets);
  ~Picture();
  Picture(const Picture&) = delete;
  Picture& operator=(const Picture&) = delete;

  /// Tells the view what a tick brought; after every tick.
  void ticked(sim::Game& game);
  /// What the last tick brought.
  const sim::FramePacket& packet() const;
  /// Another game follows: forgets everything about the last one.
  void restarted();
  /// `overlay`: on top, unless null.
  /// `heard`: what the sound left out, shown beside what the picture did.
  void draw(sim::Game& game, const runtime::Shown& shown, const render::Overlay* overlay = nullptr,
            const std::vector<NamedCount>& heard = {});
  /// What the pictures so far left out.
  std::vector<NamedCount> omissions() const;
  render::Image readBack();

 private:
  struct Parts;
  explicit Picture(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace brittle::program
