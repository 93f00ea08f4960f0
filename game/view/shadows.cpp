#include "game/view/shadows.h"

#include <cmath>

#include "engine/math/aabb.h"
#include "engine/math/trig.h"

namespace brittle::view {
namespace {

// Sizes of outlines, as the square root of half their area [m]. A shadow below the smallest is not worth drawing, and
// fades in above it; beyond the largest (walls of glass) one rectangle is too coarse. Chosen by eye.
constexpr float kSmallest = 0.05f, kFull = 0.14f, kLargest = 2.5f;
constexpr float kThinnest = 0.03f;              // half the depth of a pane's shadow at least [m]
constexpr float kDark = 0.85f, kClear = 0.42f;  // opacity of what light does not pass through, and of glass

/// A body's outline in the frame turned as it stands.
struct Outline {
  Aabb box;
  float turn = 0.0f, cosine = 1.0f, sine = 0.0f;
  float opacity = 0.0f;

  void face(const Quat& rotation);
  void include(const Vec3& p) {
    box.include(Vec3(cosine * p.x() - sine * p.z(), p.y(), sine * p.x() + cosine * p.z()));
  }
  Vec3 underside() const {
    const Vec3 center = box.center();
    return {cosine * center.x() + sine * center.z(), box.low.y(), cosine * center.z() - sine * center.x()};
  }
};

/// About Y, as the body's X axis lies, or its Z axis where X stands upright.
void Outline::face(const Quat& rotation) {
  const Vec3 x = rotation * Vec3::UnitX(), z = rotation * Vec3::UnitZ();
  turn = x.y() * x.y() > 0.8f ? arcTangent(z.x(), z.z()) : arcTangent(-x.z(), x.x());
  cosine = brittle::cosine(turn);
  sine = brittle::sine(turn);
}

}  // namespace

void addShadows(const render::MeshGroup& group, std::span<const render::Material> materials, float strength,
                std::vector<render::Shadow>& shadows) {
  if (strength <= 0.0f) return;
  std::vector<Outline> outlines(group.bodies.size());
  for (const render::VisibleMesh& mesh : group.meshes) {
    if (mesh.body >= outlines.size()) continue;
    Outline& outline = outlines[mesh.body];
    const Transform& pose = group.bodies[mesh.body];
    if (outline.box.isEmpty()) outline.face(pose.rotation);
    const bool isGlass = materials[minOf<std::size_t>(mesh.material, materials.size() - 1)].look == render::Look::Glass;
    outline.opacity = maxOf(outline.opacity, isGlass ? kClear : kDark);
    for (const geometry::Vertex& vertex : group.pool->view(mesh.slot).vertices)
      outline.include(pose.toWorld(vertex.point));
  }
  for (const Outline& outline : outlines) {
    if (outline.box.isEmpty()) continue;
    const Vec3 half = 0.5f * outline.box.extent();
    const float widest = maxOf(half.x(), half.z());
    if (widest <= kSmallest || std::sqrt(half.x() * half.z()) >= kLargest) continue;
    const float share = clampTo((widest - kSmallest) / (kFull - kSmallest), 0.0f, 1.0f);
    const Vec2 halfSize(maxOf(half.x(), kThinnest), maxOf(half.z(), kThinnest));
    shadows.push_back({outline.underside(), halfSize, outline.turn, outline.opacity * share * strength});
  }
}

}  // namespace brittle::view
