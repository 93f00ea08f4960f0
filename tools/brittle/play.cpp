#include <cstdio>
#include <optional>

#include "engine/core/file.h"
#include "engine/replay/recorder.h"
#include "engine/replay/replay_file.h"
#include "engine/runtime/loop.h"
#include "game/content/level.h"
#include "game/sim/constants.h"
#include "game/view/hud.h"
#include "platform/sdl/window.h"
#include "tools/brittle/faults.h"
#include "tools/brittle/game.h"
#include "tools/brittle/interrupt.h"
#include "tools/brittle/picture.h"
#include "tools/brittle/saved.h"
#include "tools/brittle/speakers.h"
#include "tools/brittle/tuning.h"

namespace brittle::program {
namespace {

constexpr std::uint32_t kEndTicks = 60;  // the end is shown for a second before a touch goes on [ticks]

/// The names of game.xml, which says what follows a level; none if it cannot be read.
std::vector<std::string> levelNames(const content::AssetSource& assets) {
  std::vector<std::string> names;
  const Result<std::string> text = assets.read("game.xml");
  if (!text) return names;
  for (content::LevelEntry& entry : content::readGameList(*text, "game.xml").levels)
    names.push_back(std::move(entry.name));
  return names;
}

/// Games in a window, from title to checkpoint and on: ticks, draws, records. Each game is a recording of its own.
class Player : public runtime::Client {
 public:
  Player(const content::AssetSource& assets, std::unique_ptr<GameSimulation> simulation, Picture& picture,
         Speakers* speakers, Tuning& tuning, const PlayOptions& options, sim::Progress& progress)
      : assets_(assets),
        simulation_(std::move(simulation)),
        picture_(picture),
        speakers_(speakers),
        tuning_(tuning),
        options_(options),
        progress_(progress),
        levels_(levelNames(assets)) {
    begin();
  }

  void tick(const replay::InputFrame& input) override {
    if (wantsNext(input)) return next();
    tuning_.tickBegins();
    simulation_->tick(input);
    tuning_.tickEnds();
    keepCheckpoint();
    if (recorder_ && isRecording_) recorder_->record(input, *simulation_);
    show();
  }
  void draw(const runtime::Shown& shown) override {
    const render::Overlay* panels = tuning_.build(simulation_->game(), shown.size);
    if (tuning_.hasChanged()) endRecording();
    std::vector<NamedCount> heard;
    if (speakers_ != nullptr && shown.times != nullptr) heard = speakers_->omissions();
    picture_.draw(simulation_->game(), shown, panels, heard);
    ++frames_;
  }
  float tanHalfWidth(runtime::PictureSize size) const override {
    const float aspect = static_cast<float>(maxOf(size.width, 1)) / static_cast<float>(maxOf(size.height, 1));
    return simulation_->game().camera().halfWidthTangentIn(aspect);
  }
  runtime::Controls controls(runtime::PictureSize size) const override {
    runtime::Controls controls;
    const sim::Hud& hud = simulation_->game().hud();
    for (const view::TouchSpot& spot :
         view::powerUpSpots(hud, static_cast<float>(size.width), static_cast<float>(size.height)))
      controls.uses.push_back({spot.left, spot.top, spot.right, spot.bottom});
    controls.throwEvery = hud.throwsAreFree ? sim::rules::kSprayTicks : 0;
    return controls;
  }
  bool isDone() const override { return isInterrupted() || (options_.frames != 0 && frames_ >= options_.frames); }

  Status saveRecording() const {
    return recorder_ ? replay::save(recorder_->replay(), options_.record) : Status(Done{});
  }
  const sim::Game& game() const { return simulation_->game(); }

 private:
  void begin() {
    faults_.restart();
    if (!options_.record.empty()) recorder_.emplace(startOf(simulation_->game()));
    isRecording_ = recorder_.has_value();
    show();
  }
  /// A replay has the same accuracy from its first tick to its last.
  void endRecording() {
    if (isRecording_) std::fprintf(stderr, "brittle: the recording ends here: the accuracy was changed\n");
    isRecording_ = false;
  }
  void show() {
    picture_.ticked(simulation_->game());
    faults_.show(simulation_->game());
    if (speakers_ != nullptr) speakers_->ticked(picture_.packet());
  }
  bool wantsNext(const replay::InputFrame& input) const {
    const bool isAtEnd = game().isOver() && game().hud().phaseTicks > kEndTicks;
    return (input.buttons & static_cast<std::uint8_t>(replay::Button::Restart)) != 0 ||
           (isAtEnd && !input.throws.empty());
  }
  void keepCheckpoint() {
    if (!game().hud().countsBalls) return;  // there is nothing to keep
    for (const sim::Event& event : game().events())
      if (event.type == sim::EventType::Checkpoint)
        progress_.pass(game().def().level, game().checkpoint().room, game().checkpoint().balls);
  }
  void next() {
    auto fresh = openGame(assets_, sim::nextGame(game(), progress_, levels_));
    if (!fresh) return;  // the level was deleted while it was played: go on with this game
    simulation_ = std::move(*fresh);
    picture_.restarted();
    if (speakers_ != nullptr) speakers_->restarted();
    begin();
  }

  const content::AssetSource& assets_;
  std::unique_ptr<GameSimulation> simulation_;
  Picture& picture_;
  Speakers* speakers_;  // null: in silence
  Tuning& tuning_;
  const PlayOptions& options_;
  sim::Progress& progress_;
  const std::vector<std::string> levels_;
  std::optional<replay::Recorder> recorder_;
  bool isRecording_ = false;
  Faults faults_;
  std::uint32_t frames_ = 0;
};

}  // namespace

int play(const PlayOptions& options) {
  const Result<Size> size = parseSize(options.size);
  if (!size) return refuse(size.error());
  Result<sim::GameDef> def = defOf(options.game);
  if (!def) return refuse(def.error());
  const auto assets = openAssets(options.game.assets);
  if (!assets) return refuse(assets.error());
  Saved saved = loadProgress(progressPath());
  def->title = true;
  def->balls = saved.progress.ballsAt(def->level, def->firstRoom);
  auto simulation = openGame(**assets, *def);
  if (!simulation) return refuse(simulation.error());
  const Status writable = options.record.empty() ? Status(Done{}) : checkWritable(options.record);
  if (!writable) return refuse(writable.error());
  catchInterrupts();  // before SDL, which would take Ctrl-C for a closed window
  platform::WindowDef window;
  window.size = {size->width, size->height};
  const auto opened = platform::openWindow(window);
  if (!opened) return refuse(opened.error());
  const auto picture = Picture::create(**opened, 4, **assets);
  if (!picture) return refuse(picture.error());

  const std::unique_ptr<Speakers> speakers = options.mute ? nullptr : Speakers::open();

  Tuning tuning(**opened);
  Player player(**assets, std::move(*simulation), **picture, speakers.get(), tuning, options, saved.progress);
  runtime::Loop loop(tuning.platform(), player);
  while (loop.frame()) {
  }
  for (const Status& written : {player.saveRecording(), saveProgress(saved)}) {
    if (!written) complain(written.error());
    if (!written) return kWrongInput;
  }
  if (isInterrupted()) return refuse(interruption());
  std::printf("%.0f metres, %d balls left\n", static_cast<double>(player.game().hud().distance),
              player.game().hud().balls);
  return kDone;
}

}  // namespace brittle::program
