#include "game/view/look.h"

namespace brittle::view {
namespace {

render::BakeBox boxOf(const sim::LookBox& from) {
  render::BakeBox box;
  box.center = from.center;
  box.halfExtents = from.halfExtents;
  for (std::size_t i = 0; i < 3; ++i) {
    box.color[i] = from.color[i];
    box.tile[i] = from.tile[i];
    box.tileSize[i] = from.tileSize[i];
    box.tileRotation[i] = from.tileRotation[i];
  }
  box.glow = from.glow;
  box.reflects = from.reflects;
  return box;
}

/// What reaches an end of the segment goes on in its neighbour, as far as it can darken: else walls would be lighter at
/// every seam. Lamps are taken to go on in the same distances.
void addContinuation(const render::BakeBox& box, float length, std::vector<render::BakeBox>& beyond) {
  constexpr float kReach = 4.0f, kNear = 0.05f;  // [m]
  const float front = box.center.z() + box.halfExtents.z(), back = box.center.z() - box.halfExtents.z();
  render::BakeBox next = box;
  if (box.glow > 0.0f) {
    for (const float shift : {length, -length}) {
      next.center.z() = box.center.z() + shift;
      beyond.push_back(next);
    }
    return;
  }
  next.halfExtents.z() = 0.5f * kReach;
  next.center.z() = front + 0.5f * kReach;
  if (front > -kNear) beyond.push_back(next);
  next.center.z() = back - 0.5f * kReach;
  if (back < kNear - length) beyond.push_back(next);
}

}  // namespace

std::vector<render::Material> materials() {
  using enum sim::Look;
  std::vector<render::Material> table(static_cast<std::size_t>(PowerUp) + 1);
  const auto of = [&table](sim::Look look) -> render::Material& { return table[static_cast<std::size_t>(look)]; };
  of(Static) = {.color = {0.80f, 0.82f, 0.84f}, .gloss = 0.2f};
  of(Glass) = {
      .look = render::Look::Glass, .color = {0.97f, 1.0f, 1.0f}, .gloss = 0.9f, .clarity = 0.94f, .edge = 0.9f};
  of(Metal) = {.color = {0.86f, 0.88f, 0.92f}, .metalness = 1.0f, .gloss = 0.55f};
  of(Wood) = {.color = {0.74f, 0.55f, 0.38f}, .gloss = 0.25f};
  of(Stone) = {.color = {0.72f, 0.72f, 0.74f}, .gloss = 0.15f};
  of(Crystal) = {.look = render::Look::Glass, .gloss = 1.0f, .clarity = 0.5f, .edge = 1.0f};
  of(Ball) = {.color = {0.86f, 0.87f, 0.90f}, .metalness = 1.0f, .gloss = 0.9f};
  of(PowerUp) = {.look = render::Look::Glass, .gloss = 1.0f, .clarity = 0.25f, .edge = 1.0f};
  of(Door) = {.color = {0.90f, 0.92f, 0.96f}, .metalness = 0.6f, .gloss = 0.45f};
  return table;
}

render::Baker bakerOf(const sim::SegmentLook& look, Baked baked) {
  std::vector<render::BakeBox> boxes, beyond;
  for (const sim::LookBox& from : look.boxes) {
    const render::BakeBox box = boxOf(from);
    (baked == Baked::All || from.isStone ? boxes : beyond).push_back(box);
    addContinuation(box, look.length, beyond);
  }
  render::BakeDef def;
  def.light = {look.light[0], look.light[1], look.light[2], look.light[3], look.light[4], look.light[5]};
  def.beyond = beyond;
  return render::Baker(boxes, def);
}

}  // namespace brittle::view
