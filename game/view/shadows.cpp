#include "game/view/shadows.h"

#include <cmath>

#include "engine/math/aabb.h"

namespace brittle::view {
namespace {

// Footprints [m]. A blob below the smallest is not worth drawing, and fades in above it; beyond the largest (walls of
// glass) a round blob looks wrong. Chosen by eye.
constexpr float kSmallest = 0.06f, kFull = 0.16f, kLargest = 0.9f;
constexpr float kOpacity = 0.38f;

}  // namespace

void addShadows(const render::MeshGroup& group, std::vector<render::Shadow>& shadows) {
  std::vector<Aabb> boxes(group.bodies.size());
  std::vector<bool> isUsed(group.bodies.size());
  for (const render::VisibleMesh& mesh : group.meshes) {
    if (mesh.body >= boxes.size()) continue;
    const Transform& pose = group.bodies[mesh.body];
    for (const geometry::Vertex& vertex : group.pool->view(mesh.slot).vertices)
      boxes[mesh.body].include(pose.toWorld(vertex.point));
    isUsed[mesh.body] = true;
  }
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!isUsed[i]) continue;
    const Vec3 half = 0.5f * boxes[i].extent();
    const float radius = std::sqrt(half.x() * half.z());
    if (radius <= kSmallest || radius >= kLargest) continue;
    const float share = clampTo((radius - kSmallest) / (kFull - kSmallest), 0.0f, 1.0f) *
                        clampTo((kLargest - radius) / (0.4f * kLargest), 0.0f, 1.0f);
    shadows.push_back({boxes[i].center(), radius, kOpacity * share});
  }
}

}  // namespace brittle::view
