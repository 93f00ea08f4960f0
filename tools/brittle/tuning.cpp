#include "tools/brittle/tuning.h"

#include <imgui.h>

#include "tools/panels/knobs.h"

namespace brittle::program {

Tuning::Tuning(runtime::Platform& window)
    : window_(window), listening_(window, [this](const runtime::Event& event) { return hear(event); }) {}

bool Tuning::hear(const runtime::Event& event) {
  if (event.kind == runtime::EventKind::KeyDown && event.key == runtime::Key::F4 && !event.repeated) {
    panels_ = panels_ ? nullptr : std::make_unique<Panels>();
    return true;
  }
  return panels_ && panels_->gui.take(event);
}

void Tuning::tickBegins() {
  if (panels_) panels_->phases.tickBegins();
}

void Tuning::tickEnds() {
  if (panels_) panels_->phases.tickEnds();
}

const render::Overlay* Tuning::build(sim::Game& game, runtime::PictureSize size) {
  hasChanged_ = false;
  if (!panels_) return nullptr;
  panels_->gui.begin(size, window_.seconds());
  ImGui::SetNextWindowPos(ImVec2(10.0f, 10.0f), ImGuiCond_Once);
  ImGui::Begin("Accuracy and its cost", nullptr, ImGuiWindowFlags_AlwaysAutoResize);
  physics::Accuracy accuracy = game.accuracy();
  hasChanged_ = panels::showKnobs(accuracy);
  if (hasChanged_) game.setAccuracy(accuracy);
  ImGui::Separator();
  panels_->phases.show();
  ImGui::End();
  return &panels_->gui.end();
}

}  // namespace brittle::program
