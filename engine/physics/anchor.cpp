#include "engine/physics/anchor.h"

#include "engine/geometry/clip.h"
#include "engine/physics/contact_graph.h"

namespace brittle::physics {
namespace {

constexpr float kAnchorSlop = 2e-3f;  // level files put panes this near to their frames [m]

/// What of a face of `shape` lies within `support` grown by the slop, in world space.
void coveredPart(const geometry::ConvexView& convex, std::uint32_t face, const Transform& pose,
                 const geometry::ConvexView& support, const Transform& supportPose, std::vector<Vec3>& scratch,
                 std::vector<Vec3>& polygon) {
  geometry::facePolygon(convex, face, pose, polygon);
  for (const geometry::Face& side : support.faces) {
    if (polygon.size() < 3) return;
    const Vec3 normal = supportPose.rotate(side.plane.normal);
    const float offset = side.plane.offset + normal.dot(supportPose.position) + kAnchorSlop;
    geometry::clipPolygon({normal, offset}, scratch, polygon);
  }
}

/// The largest covered part of any face becomes the anchor.
bool findAnchor(const State& state, const Shape& shape, const Shape& support, fracture::Anchor& anchor) {
  const Transform& pose = state.bodyOf(shape).pose;
  const geometry::ConvexView convex = state.meshes.view(shape.mesh);
  std::vector<Vec3> polygon, scratch, largest;
  float largestArea = 4.0f * kAnchorSlop * kAnchorSlop;
  for (std::uint32_t face = 0; face < convex.faces.size(); ++face) {
    coveredPart(convex, face, pose, state.meshes.view(support.mesh), state.bodyOf(support).pose, scratch, polygon);
    if (polygon.size() < 3) continue;
    const float area = geometry::polygonArea(polygon);
    if (area <= largestArea) continue;
    largestArea = area;
    largest = polygon;
  }
  if (largest.empty()) return false;
  const std::size_t step = (largest.size() + 7) / 8;  // at most eight corners
  anchor.pointCount = 0;
  for (std::size_t i = 0; i < largest.size() && anchor.pointCount < 8; i += step)
    anchor.points[anchor.pointCount++] = pose.toLocal(largest[i]);
  return true;
}

void anchorShape(State& state, Shape& shape) {
  shape.anchored = false;
  shape.anchorCount = 0;
  state.tree.query(state.tree.box(shape.proxy).grownBy(kAnchorSlop), [&](std::uint32_t slot) {
    const Shape& support = state.shapes.at(slot);
    const Body& body = state.bodyOf(support);
    if (support.body == shape.body || body.type != BodyType::Static || body.breakable || support.isSphere())
      return true;
    if (findAnchor(state, shape, support, shape.anchors[shape.anchorCount])) {
      shape.anchored = true;
      ++shape.anchorCount;
    }
    return shape.anchorCount < kMaxAnchors;
  });
}

}  // namespace

std::uint32_t findAnchors(State& state, BodyHandle handle) {
  Body& body = state.bodies[handle];
  std::uint32_t anchored = 0;
  forEachShape(state, body, [&](ShapeHandle, Shape& shape) {
    if (shape.isSphere()) return;
    anchorShape(state, shape);
    anchored += shape.anchored ? 1 : 0;
  });
  if (anchored > 0 || body.type != BodyType::Static) return anchored;
  forEachShape(state, body, [&](ShapeHandle, Shape& shape) {
    shape.anchored = true;
    ++anchored;
  });
  return anchored;
}

}  // namespace brittle::physics
