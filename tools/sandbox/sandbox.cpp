#include "tools/sandbox/sandbox.h"

#include <imgui.h>

#include "tools/panels/knobs.h"

namespace brittle::sandbox {
namespace {

constexpr float kPanelWidth = 330.0f, kMargin = 10.0f;  // [pixels]

/// A panel along one side of the picture.
void beginPanel(const char* title, bool onTheRight, runtime::PictureSize size) {
  const auto width = static_cast<float>(size.width), height = static_cast<float>(size.height);
  ImGui::SetNextWindowPos(ImVec2(onTheRight ? width - kPanelWidth - kMargin : kMargin, kMargin), ImGuiCond_Once);
  ImGui::SetNextWindowSizeConstraints(ImVec2(kPanelWidth, 0.0f), ImVec2(kPanelWidth, height - 2.0f * kMargin));
  ImGui::Begin(title, nullptr, ImGuiWindowFlags_AlwaysAutoResize);
}

}  // namespace

bool Sandbox::hear(const runtime::Event& event) {
  using runtime::EventKind;
  if (gui_.take(event)) return true;
  if (event.kind == EventKind::PointerDown) {
    const runtime::PictureSize size = platform_.size();
    run_.throwBall(2.0f * event.x / static_cast<float>(size.width) - 1.0f,
                   1.0f - 2.0f * event.y / static_cast<float>(size.height));
    return true;
  }
  return event.kind == EventKind::KeyDown && press(event);
}

bool Sandbox::press(const runtime::Event& event) {
  using runtime::Key;
  switch (event.key) {
    case Key::Left:
    case Key::Right:
      run_.orbit(event.key == Key::Left ? -1 : 1, 0);
      return true;
    case Key::Up:
    case Key::Down:
      run_.orbit(0, event.key == Key::Up ? 1 : -1);
      return true;
    case Key::Space:
      if (!event.repeated) isPaused_ = !isPaused_;
      return true;
    case Key::Character:
      break;
    default:
      return false;
  }
  switch (event.character) {
    case 'b':
      if (!event.repeated) run_.throwBall(0.0f, 0.0f);
      return true;
    case 'r':
      if (!event.repeated) run_.restart();
      return true;
    case '.':
      step();
      return true;
    case ',':
      back();
      return true;
    case 'p':  // the loop's own pause would stop the panels' scene without telling them
      if (!event.repeated) isPaused_ = !isPaused_;
      return true;
    default:
      return false;
  }
}

void Sandbox::play() {
  phases_.tickBegins();
  run_.step();
  phases_.tickEnds();
}

void Sandbox::step() {
  isPaused_ = true;
  play();
}

void Sandbox::back() {
  isPaused_ = true;
  if (run_.tick() > 0) run_.seek(run_.tick() - 1);
}

void Sandbox::tick(const replay::InputFrame&) {
  if (isPaused_ || ++ticks_ % static_cast<std::uint32_t>(slowness_) != 0) return;
  play();
}

void Sandbox::showControls() {
  if (ImGui::Button(isPaused_ ? "go on" : "pause")) isPaused_ = !isPaused_;
  ImGui::SameLine();
  if (ImGui::Button("step")) step();
  ImGui::SameLine();
  if (ImGui::Button("back")) back();
  ImGui::SameLine();
  if (ImGui::Button("restart")) run_.restart();
  ImGui::SameLine();
  ImGui::Text("tick %u", run_.tick());
  ImGui::SliderInt("times slower", &slowness_, 1, 60, "%d", ImGuiSliderFlags_AlwaysClamp);
}

void Sandbox::showSettings() {
  physics::Accuracy accuracy = run_.accuracy();
  if (panels::showKnobs(accuracy)) run_.setAccuracy(accuracy);
}

void Sandbox::draw(const runtime::Shown& shown) {
  if (shown.size.width < 1 || shown.size.height < 1) return;  // a window that is minimised
  if (!(shown.size == size_)) renderer_.resize(shown.size.width, shown.size.height);
  size_ = shown.size;
  gui_.begin(size_, platform_.seconds());
  beginPanel("Run", false, size_);
  showControls();
  run_.showPanel();
  ImGui::Separator();
  phases_.show();
  ImGui::End();
  beginPanel("Accuracy", true, size_);
  showSettings();
  ImGui::End();
  run_.draw(renderer_, size_, &gui_.end());
  ++drawn_;
}

}  // namespace brittle::sandbox
