#include "tools/sandbox/scene_run.h"

#include <imgui.h>

#include <cmath>
#include <string>

namespace brittle::sandbox {
namespace {

constexpr float kBallRadius = 0.08f;  // [m]
constexpr float kOrbitStep = 0.05f;   // [rad]
constexpr float kMostSpeed = 200.0f;  // [m/s]

float volumeOf(float radius) {
  return 4.0f / 3.0f * kPi * radius * radius * radius;
}

}  // namespace

void SceneSimulation::tick(const Input& balls) {
  for (const Ball& ball : balls) {
    physics::BodyDef def;
    def.pose.position = ball.position;
    def.velocity = ball.velocity;
    physics::ShapeDef shape;
    shape.surface.density = ball.density;
    world->addSphere(world->createBody(def), shape, kBallRadius);
  }
  world->step(accuracy::kTick);
}

SceneRun::SceneRun(const accuracy::Scene& scene, int variant, const physics::Accuracy& accuracy)
    : scene_(&scene), variant_(variant) {
  begin(accuracy);
  orbit_ = orbitFor(world());
}

void SceneRun::choose(const accuracy::Scene& scene) {
  scene_ = &scene;
  variant_ = 0;
  begin(accuracy());
  orbit_ = orbitFor(world());
}

void SceneRun::begin(const physics::Accuracy& accuracy) {
  simulation_.world = accuracy::makeWorld(*scene_, accuracy, variant_);
  stage_ = scene_->build(*simulation_.world, variant_);
  timeline_ = std::make_unique<Timeline<SceneSimulation>>(simulation_);
  thrown_.clear();
  ++worlds_;
}

void SceneRun::step() {
  timeline_->step(thrown_);
  thrown_.clear();
}

void SceneRun::restart() {
  begin(accuracy());
}

void SceneRun::setAccuracy(const physics::Accuracy& accuracy) {
  simulation_.world->setAccuracy(accuracy);
  timeline_->changed();
}

void SceneRun::throwBall(float right, float up) {
  const Transform view = viewFrom(orbit_);
  const float width = frame_.camera.tanHalfWidth;
  const Vec3 way = view.rotate(Vec3(right * width, up * width / aspect_, -1.0f)).normalized();
  thrown_.push_back({view.position, ballSpeed_ * way, ballMass_ / volumeOf(kBallRadius)});
}

void SceneRun::orbit(int right, int up) {
  orbit_.turn += kOrbitStep * static_cast<float>(right);
  orbit_.rise += kOrbitStep * static_cast<float>(up);
}

void SceneRun::showScenes() {
  if (ImGui::BeginCombo("scene", std::string(scene_->name).c_str())) {
    for (const accuracy::Scene& one : accuracy::allScenes())
      if (ImGui::Selectable(std::string(one.name).c_str(), &one == scene_)) choose(one);
    ImGui::EndCombo();
  }
  ImGui::TextWrapped("%s", std::string(scene_->what).c_str());
  if (ImGui::SliderInt("variant", &variant_, 0, scene_->variants - 1, "%d", ImGuiSliderFlags_AlwaysClamp)) restart();
}

void SceneRun::showErrors() const {
  if (stage_.analytics.empty()) ImGui::TextDisabled("nothing is known exactly of this scene");
  for (const accuracy::Analytic& one : stage_.analytics) {
    const double time = static_cast<double>(accuracy::kTick) * tick();
    const double value = one.value(world()), exact = one.exact(time);
    ImGui::TextWrapped("%s: %.4g %s, exactly %.4g, off by %.2g", std::string(one.what).c_str(), value,
                       std::string(one.unit).c_str(), exact, value - exact);
  }
  const physics::Counters& counters = world().counters();
  ImGui::Text("%u bodies, %u awake, %u contacts", counters.bodies, counters.awakeBodies, counters.contacts);
  ImGui::Text("%llu breaks, %llu held, %u rounds", static_cast<unsigned long long>(counters.totalBreaks),
              static_cast<unsigned long long>(counters.omissions[physics::Omission::HeldBreak]), counters.rounds);
}

void SceneRun::showPanel() {
  showScenes();
  ImGui::SliderFloat("ball's speed", &ballSpeed_, 1.0f, kMostSpeed, "%.0f m/s", ImGuiSliderFlags_AlwaysClamp);
  ImGui::SliderFloat("ball's mass", &ballMass_, 0.01f, 100.0f, "%.2f kg",
                     ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
  ImGui::SliderFloat("distance", &orbit_.distance, 0.3f, 30.0f, "%.1f m", ImGuiSliderFlags_Logarithmic);
  ImGui::Checkbox("what rests is dark", &restDark_);
  ImGui::Separator();
  showErrors();
}

void SceneRun::draw(render::Renderer& renderer, runtime::PictureSize size, const render::Overlay* overlay) {
  aspect_ = static_cast<float>(size.width) / static_cast<float>(size.height);
  fillFrame(*simulation_.world, worlds_, orbit_, restDark_, frame_);
  renderer.draw(frame_, overlay);
}

}  // namespace brittle::sandbox
