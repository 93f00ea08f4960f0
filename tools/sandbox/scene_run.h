// sandbox/scene_run.h - a scene of the accuracy study, with its exact results beside those of the world.
#pragma once

#include <memory>
#include <vector>

#include "tools/accuracy/scenes.h"
#include "tools/sandbox/run.h"
#include "tools/sandbox/timeline.h"
#include "tools/sandbox/world_frame.h"

namespace brittle::sandbox {

/// A world and the balls thrown into it.
struct SceneSimulation {
  struct Ball {
    Vec3 position, velocity;  // [m], [m/s]
    float density;            // [kg/m3]
    friend bool operator==(const Ball&, const Ball&) = default;
  };
  using Input = std::vector<Ball>;

  void tick(const Input& balls);
  void save(ByteWriter& out) const { world->save(out); }
  bool restore(ByteReader& in) { return world->restore(in); }

  std::unique_ptr<physics::World> world;
};

class SceneRun : public Run {
 public:
  SceneRun(const accuracy::Scene& scene, int variant, const physics::Accuracy& accuracy);

  std::uint32_t tick() const override { return timeline_->tick(); }
  std::uint32_t end() const override { return timeline_->end(); }
  void step() override;
  void seek(std::uint32_t tick) override { timeline_->seek(tick); }
  void restart() override;
  physics::Accuracy accuracy() const override { return world().accuracy(); }
  void setAccuracy(const physics::Accuracy& accuracy) override;
  void throwBall(float right, float up) override;
  void orbit(int right, int up) override;
  void showPanel() override;
  void draw(render::Renderer& renderer, runtime::PictureSize size, const render::Overlay* overlay) override;

  const physics::World& world() const { return *simulation_.world; }

 private:
  void begin(const physics::Accuracy& accuracy);
  void choose(const accuracy::Scene& scene);
  void showScenes();
  void showErrors() const;

  const accuracy::Scene* scene_;
  int variant_;
  SceneSimulation simulation_;
  accuracy::Stage stage_;
  std::unique_ptr<Timeline<SceneSimulation>> timeline_;
  SceneSimulation::Input thrown_;  // into the next tick
  Orbit orbit_;
  float ballSpeed_ = 20.0f, ballMass_ = 1.0f;  // [m/s], [kg]
  bool restDark_ = false;
  float aspect_ = 16.0f / 9.0f;
  std::uint64_t worlds_ = 0;  // made so far: another number for another mesh pool
  render::Frame frame_;
};

}  // namespace brittle::sandbox
