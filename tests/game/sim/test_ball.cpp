#include "game/sim/ball.h"

#include <gtest/gtest.h>

#include "game/sim/constants.h"

namespace brittle::sim {
namespace {

Camera cameraAt(float speed) {
  Camera camera;
  camera.velocity = Vec3(0.0f, 0.0f, -speed);
  return camera;
}

TEST(Ball, CrossesTheAimedLineAtTheAimedDistance) {
  for (const float speed : {3.0f, 5.0f, 14.0f}) {
    const replay::Throw aim = replay::quantizeAim(0.2f, -0.1f);
    const Camera camera = cameraAt(speed);
    const BallStart start = throwBalls(camera, aim, 1, rules::kGravity).front();
    const Vec3 direction = Vec3(0.2f, -0.1f, -1.0f).normalized();
    const float time = rules::kAimDistance / (rules::kThrowSpeed + speed);
    const Vec3 at = start.position + start.velocity * time - Vec3(0.0f, 0.5f * rules::kGravity * time * time, 0.0f);
    const Vec3 aimed = camera.position + direction * (rules::kThrowAhead + rules::kAimDistance);
    EXPECT_LT((at - aimed).norm(), 0.01f);
  }
}

TEST(Ball, BallsOfOneThrowDoNotTouch) {
  const auto starts = throwBalls(cameraAt(5.0f), {}, 5, rules::kGravity);
  ASSERT_EQ(starts.size(), 5u);
  for (std::size_t i = 1; i < starts.size(); ++i)
    EXPECT_GT((starts[i].position - starts[i - 1].position).norm(), 2.0f * rules::kBallRadius);
}

TEST(Ball, TheSlowestThrowBreaksTheStrongestPane) {
  const float volume = 4.18879f * rules::kBallRadius * rules::kBallRadius * rules::kBallRadius;
  EXPECT_GT(volume * rules::kBallDensity * rules::kThrowSpeed, 0.5f * rules::kForceUnit);
}

}  // namespace
}  // namespace brittle::sim
