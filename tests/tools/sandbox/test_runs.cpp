// The two things the sandbox plays, on a GL without a driver.
#include <gtest/gtest.h>

#include "engine/render/gl_null.h"
#include "engine/replay/recorder.h"
#include "tools/sandbox/replay_run.h"
#include "tools/sandbox/scene_run.h"

namespace brittle::sandbox {
namespace {

constexpr runtime::PictureSize kSize = {320, 180};

struct Studio {
  Studio() {
    render::RendererDef def;
    def.width = kSize.width;
    def.height = kSize.height;
    auto made = render::Renderer::create(null.table(), def);
    EXPECT_TRUE(static_cast<bool>(made));
    renderer = std::move(*made);
  }
  ~Studio() {
    renderer.reset();
    EXPECT_EQ(null.complaints().size(), 0u);
  }
  render::NullGl null;
  std::unique_ptr<render::Renderer> renderer;
};

TEST(SceneRun, ComesBackToTheSameBits) {
  SceneRun run(*accuracy::findScene("panes"), 5, {});
  std::vector<std::uint64_t> hashes{run.world().stateHash()};
  for (int i = 0; i < 30; ++i) {
    run.step();
    hashes.push_back(run.world().stateHash());
  }
  EXPECT_EQ(run.world().counters().totalBreaks, 6u);
  for (const std::uint32_t tick : {29u, 3u, 17u, 0u, 30u}) {
    run.seek(tick);
    EXPECT_EQ(run.world().stateHash(), hashes[tick]) << tick;
  }
  run.restart();
  EXPECT_EQ(run.tick(), 0u);
  EXPECT_EQ(run.world().stateHash(), hashes[0]);
}

TEST(SceneRun, ThrowsABallWhereItWasAimed) {
  SceneRun run(*accuracy::findScene("stack"), 0, {});
  Studio studio;
  run.draw(*studio.renderer, kSize, nullptr);  // from now on the aim knows the picture
  const std::uint32_t before = run.world().counters().bodies;
  run.step();
  const std::uint32_t without = run.world().counters().bodies;
  run.throwBall(0.0f, 0.0f);
  run.step();
  EXPECT_EQ(run.world().counters().bodies, without + 1) << before;
  run.seek(1);
  run.step();  // the throw is remembered
  EXPECT_EQ(run.world().counters().bodies, without + 1);
}

TEST(SceneRun, TakesAnotherAccuracyFromATickOn) {
  SceneRun run(*accuracy::findScene("panes"), 5, {});
  physics::Accuracy rigid;
  rigid.fractureMode = physics::FractureMode::AfterStep;
  rigid.impulseCap = false;
  run.seek(0);
  run.setAccuracy(rigid);
  for (int i = 0; i < 30; ++i) run.step();
  EXPECT_EQ(run.accuracy().fractureMode, physics::FractureMode::AfterStep);
  EXPECT_LT(run.world().counters().totalBreaks, 6u);  // the ball bounces off before the glass breaks
}

/// Two seconds of the shipped level, with a throw.
replay::Replay record(const content::AssetSource& assets) {
  sim::GameDef def;
  def.seed = 3;
  auto game = program::openGame(assets, def);
  EXPECT_TRUE(static_cast<bool>(game));
  replay::Recorder recorder(program::startOf((*game)->game()));
  for (int tick = 0; tick < 240; ++tick) {
    replay::InputFrame input;
    if (tick % 30 == 10) input.throws.push_back(replay::quantizeAim(0.0f, 0.02f));
    (*game)->tick(input);
    recorder.record(input, **game);
  }
  return recorder.replay();
}

class ReplayRunOfALevel : public ::testing::Test {
 protected:
  std::unique_ptr<ReplayRun> open(replay::Replay replay) {
    auto game = program::openReplay(*assets_, replay, "test.brt");
    EXPECT_TRUE(static_cast<bool>(game));
    return std::make_unique<ReplayRun>(*assets_, std::move(replay), std::move(*game), *studio_.renderer);
  }
  std::string findingOf(ReplayRun& run) {
    run.findDifference();
    for (int picture = 0; run.finding().empty() && picture < 100'000; ++picture)
      run.draw(*studio_.renderer, kSize, nullptr);
    return run.finding();
  }

  std::unique_ptr<content::AssetSource> assets_ = std::move(*program::openAssets(BRITTLE_SOURCE_DIR "/assets"));
  Studio studio_;
};

TEST_F(ReplayRunOfALevel, FindsNothingWhereNothingDiffers) {
  EXPECT_EQ(findingOf(*open(record(*assets_))), "the same to the end");
}

TEST_F(ReplayRunOfALevel, StopsAtTheFirstTickThatWasRecordedOtherwise) {
  replay::Replay replay = record(*assets_);
  replay.hashes[99] ^= 1;
  const auto run = open(replay);
  EXPECT_EQ(findingOf(*run), "tick 100 is the first that differs");
  EXPECT_EQ(run->tick(), 100u);
}

TEST_F(ReplayRunOfALevel, FindsWhereAnotherAccuracyFirstMatters) {
  const auto run = open(record(*assets_));
  physics::Accuracy accuracy = run->accuracy();
  accuracy.maxDebris -= 1;  // by itself no difference
  run->setAccuracy(accuracy);
  EXPECT_EQ(findingOf(*run), "the same to the end");
  run->restart();
  accuracy.patternDensity = 2.0f;  // shows with the first pane that breaks
  run->setAccuracy(accuracy);
  EXPECT_NE(findingOf(*run), "the same to the end");
  EXPECT_GT(run->tick(), 10u);
}

TEST_F(ReplayRunOfALevel, ASliderLeavesTheSettingsOfWhatIsSwitchedOffAndGoingBackTakesItBack) {
  replay::Replay replay = record(*assets_);
  program::Otherwise otherwise;
  otherwise.without = effects::EffectMask().with(effects::Effect::Debris).with(effects::Effect::Stacks);
  ASSERT_TRUE(program::playOtherwise(otherwise, "test.brt", replay));
  const auto run = open(replay);
  const physics::Accuracy before = run->accuracy();
  EXPECT_EQ(before.maxDebris, physics::Accuracy().maxDebris);
  for (int tick = 0; tick < 40; ++tick) run->step();
  physics::Accuracy moved = before;
  ++moved.iterations;
  run->setAccuracy(moved);
  EXPECT_EQ(run->accuracy().maxDebris, before.maxDebris);
  EXPECT_EQ(run->accuracy().iterations, moved.iterations);
  run->seek(20);
  EXPECT_EQ(run->accuracy().iterations, before.iterations);
  EXPECT_EQ(run->accuracy().maxDebris, before.maxDebris);
}

TEST_F(ReplayRunOfALevel, GoesWhereItIsSentForwardAndBack) {
  const replay::Replay replay = record(*assets_);
  const auto run = open(replay);
  for (const std::uint32_t tick : {200u, 37u, 36u, 0u, 240u}) {
    run->seek(tick);
    for (int picture = 0; run->tick() != tick && picture < 100'000; ++picture)
      run->draw(*studio_.renderer, kSize, nullptr);
    EXPECT_EQ(run->tick(), tick);
  }
}

}  // namespace
}  // namespace brittle::sandbox
