// sandbox/replay_run.h - a recorded game with a scrubber, and the search for the first tick that no longer comes out as
// it was recorded: with another build, other content, or other settings of accuracy.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engine/replay/replay.h"
#include "game/view/scene.h"
#include "tools/brittle/game.h"
#include "tools/sandbox/run.h"
#include "tools/sandbox/timeline.h"

namespace brittle::sandbox {

struct GameTimelineSimulation {
  using Input = replay::InputFrame;

  void tick(const Input& input) { game->tick(input); }
  void save(ByteWriter& out) const;
  bool restore(ByteReader& in);

  std::unique_ptr<program::GameSimulation> game;
};

class ReplayRun : public Run {
 public:
  /// `game`: in the replay's start state. `assets` and `renderer` must outlive it.
  ReplayRun(const content::AssetSource& assets, replay::Replay replay, std::unique_ptr<program::GameSimulation> game,
            render::Renderer& renderer);

  std::uint32_t tick() const override { return timeline_->tick(); }
  std::uint32_t end() const override { return replay_.ticks(); }
  void step() override;
  void seek(std::uint32_t tick) override;
  void restart() override;
  physics::Accuracy accuracy() const override { return game().accuracy(); }
  void setAccuracy(const physics::Accuracy& accuracy) override;
  void throwBall(float, float) override {}
  void orbit(int, int) override {}
  void showPanel() override;
  void draw(render::Renderer& renderer, runtime::PictureSize size, const render::Overlay* overlay) override;

  /// Searches from where it stands on, some ticks with each picture.
  void findDifference();
  /// What the last search found; empty before it ended.
  const std::string& finding() const { return finding_; }

 private:
  sim::Game& game() const { return simulation_.game->game(); }
  void show();
  void forward();
  void advance();
  bool differs();
  void goTo(std::uint32_t tick);

  const content::AssetSource& assets_;
  replay::Replay replay_;
  GameTimelineSimulation simulation_;
  std::unique_ptr<Timeline<GameTimelineSimulation>> timeline_;
  view::Scene scene_;
  sim::FramePacket packet_;  // kept for its memory
  const physics::Accuracy recorded_;
  std::optional<std::uint32_t> target_;  // a tick it is on its way to
  bool isSearching_ = false;
  std::string finding_;
};

}  // namespace brittle::sandbox
