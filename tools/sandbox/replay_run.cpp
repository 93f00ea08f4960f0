#include "tools/sandbox/replay_run.h"

#include <imgui.h>

#include <chrono>
#include <cstdio>

#include "engine/core/archive.h"
#include "game/view/memory.h"

namespace brittle::sandbox {
namespace {

constexpr std::chrono::milliseconds kWorkPerPicture(12);

}  // namespace

/// With the accuracy asked for then, which a snapshot of a game leaves out: rooms to come take it from there.
void GameTimelineSimulation::save(ByteWriter& out) const {
  physics::Accuracy accuracy = game->game().accuracy();
  SaveArchive archive(out);
  accuracy.serialize(archive);
  game->save(out);
}

bool GameTimelineSimulation::restore(ByteReader& in) {
  physics::Accuracy accuracy;
  RestoreArchive archive(in);
  accuracy.serialize(archive);
  if (!game->restore(in)) return false;
  game->game().setAccuracy(accuracy);
  return true;
}

ReplayRun::ReplayRun(const content::AssetSource& assets, replay::Replay replay,
                     std::unique_ptr<program::GameSimulation> game, render::Renderer& renderer)
    : assets_(assets),
      replay_(std::move(replay)),
      simulation_{std::move(game)},
      scene_(renderer),
      recorded_(accuracy()) {
  timeline_ = std::make_unique<Timeline<GameTimelineSimulation>>(simulation_, replay_.frames);
  show();
}

void ReplayRun::show() {
  game().copyFrame(packet_);
  scene_.tick(packet_);
}

void ReplayRun::step() {
  if (!target_ && tick() < end()) forward();
}

void ReplayRun::forward() {
  timeline_->step();
  show();
}

void ReplayRun::seek(std::uint32_t tick) {
  isSearching_ = false;
  target_ = tick;
  if (tick < timeline_->tick()) goTo(tick);
}

/// The picture depends on some ticks before: they are shown too.
void ReplayRun::goTo(std::uint32_t tick) {
  target_.reset();
  timeline_->seek(tick > view::kMemoryTicks ? tick - view::kMemoryTicks : 0);
  scene_.reset();
  show();
  while (timeline_->tick() < tick) forward();
}

void ReplayRun::restart() {
  sim::GameDef def = game().def();
  auto fresh = program::openGame(assets_, def);
  if (!fresh) return;  // the level was deleted meanwhile: go on with this game
  simulation_.game = std::move(*fresh);
  timeline_ = std::make_unique<Timeline<GameTimelineSimulation>>(simulation_, replay_.frames);
  target_.reset();
  isSearching_ = false;
  finding_.clear();
  scene_.reset();
  show();
}

void ReplayRun::setAccuracy(const physics::Accuracy& accuracy) {
  game().setAccuracy(accuracy);
  timeline_->changed();
}

void ReplayRun::findDifference() {
  finding_.clear();
  isSearching_ = true;
  target_ = end();
}

/// Of what was recorded: the settings themselves, which the hash covers, do not count.
bool ReplayRun::differs() {
  const physics::Accuracy now = accuracy();
  game().setAccuracy(recorded_);
  const bool isSame = simulation_.game->hash() == replay_.hashes[tick() - 1];
  game().setAccuracy(now);
  return !isSame;
}

void ReplayRun::advance() {
  const auto start = std::chrono::steady_clock::now();
  while (target_ && std::chrono::steady_clock::now() - start < kWorkPerPicture) {
    if (tick() >= *target_) {
      if (isSearching_) finding_ = "the same to the end";
      isSearching_ = false;
      target_.reset();
      return;
    }
    forward();
    if (!isSearching_ || !differs()) continue;
    finding_ = "tick " + std::to_string(tick()) + " is the first that differs";
    isSearching_ = false;
    target_.reset();
  }
}

void ReplayRun::showPanel() {
  int sought = static_cast<int>(target_.value_or(tick()));
  ImGui::PushItemWidth(-1.0f);
  if (ImGui::SliderInt("##scrubber", &sought, 0, static_cast<int>(end()), "tick %d", ImGuiSliderFlags_AlwaysClamp))
    seek(static_cast<std::uint32_t>(sought));
  ImGui::PopItemWidth();
  if (target_)
    ImGui::ProgressBar(static_cast<float>(tick()) / static_cast<float>(*target_), ImVec2(-1.0f, 0.0f),
                       isSearching_ ? "searching" : "on the way");
  if (ImGui::Button("to the first tick that differs")) findDifference();
  ImGui::TextWrapped("%s", finding_.c_str());
  ImGui::Text("%d balls, %.0f metres, %u breaks", game().hud().balls, static_cast<double>(game().hud().distance),
              game().totalBreaks());
}

void ReplayRun::draw(render::Renderer& renderer, runtime::PictureSize size, const render::Overlay* overlay) {
  advance();
  const float aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
  renderer.draw(scene_.build(1.0f, aspect, {game().meshes(0), game().meshes(1)}), overlay);
}

}  // namespace brittle::sandbox
