// What the children of a cut share with their parent and with each other, bit for bit. The first rule broken, as a
// sentence; null: none.
#pragma once

#include <algorithm>

#include "tests/engine/geometry/cutting.h"

namespace brittle::geometry {

/// Every vertex of the parent stands in one child, in the parent's order, and both caps have the same corners, once
/// round each way.
inline const char* findSharingError(const Convex& parent, const Convex& above, const Convex& below) {
  const std::vector<Vec3> capAbove = capOf(above), capBelow = capOf(below);
  const std::size_t count = capAbove.size();
  if (count != capBelow.size()) return "the caps differ in their corners' number";
  if (above.vertices.size() + below.vertices.size() != parent.vertices.size() + 2 * count)
    return "vertices are lost or doubled";
  for (std::size_t i = 0; i < count; ++i)
    if (!isSame(capAbove[i], capBelow[i == 0 ? 0 : count - i])) return "the caps differ in a corner";
  // Corners that coincide may be on different sides: every number of vertices above so far that fits is kept in mind.
  std::vector<std::size_t> fitting = {0}, next;
  for (std::size_t i = 0; i < parent.vertices.size(); ++i) {
    next.clear();
    const Vec3& point = parent.vertices[i].point;
    for (const std::size_t taken : fitting) {
      const bool isAbove = taken + count < above.vertices.size() && isSame(point, above.vertices[taken].point);
      const bool isBelow = i - taken + count < below.vertices.size() && isSame(point, below.vertices[i - taken].point);
      if (isBelow && (next.empty() || next.back() != taken)) next.push_back(taken);
      if (isAbove) next.push_back(taken + 1);
    }
    if (next.empty()) return "a vertex of the parent stands in neither child";
    fitting.swap(next);
  }
  return nullptr;
}

/// Other faces keep the parent's planes; the caps have the cutting plane, facing out.
inline const char* findPlaneError(const Convex& parent, const Plane& plane, const Convex& above, const Convex& below) {
  if (!isSame(above.faces.back().plane, plane.flipped()) || !isSame(below.faces.back().plane, plane))
    return "a cap has another plane than the cut";
  for (const Convex* child : {&above, &below}) {
    std::size_t next = 0;
    for (const Face& face : parent.faces)
      if (next + 1 < child->faces.size() && isSame(face.plane, child->faces[next].plane)) ++next;
    if (next + 1 != child->faces.size()) return "a face has another plane than the parent's";
  }
  return nullptr;
}

/// From each corner of a cap along the edge that was cut, to the end on the child's side. [m]
inline std::vector<double> stumpsOf(const Convex& child) {
  const std::size_t cap = child.faces.size() - 1, first = child.vertices.size() - capOf(child).size();
  std::vector<double> lengths(child.vertices.size() - first, 0.0);
  for (const Edge& edge : child.edges) {
    const Edge& opposite = child.edges[edge.opposite];
    if (edge.vertex < first || edge.face == cap || opposite.face == cap) continue;
    const Vec3d along = (child.vertices[opposite.vertex].point - child.vertices[edge.vertex].point).cast<double>();
    lengths[edge.vertex - first] = along.norm();
  }
  return lengths;
}

/// A corner of a cap keeps off both ends of its edge: by 2^-20 of the extent, or a quarter of a short edge; rounding
/// may take a quarter of that and the last two units of the coordinates.
inline const char* findCloseCornerError(const Convex& parent, const Convex& above, const Convex& below) {
  double reach = 0.0;
  for (const Vertex& vertex : parent.vertices) reach = std::max<double>(reach, vertex.point.cwiseAbs().maxCoeff());
  const std::vector<double> up = stumpsOf(above), down = stumpsOf(below);
  for (std::size_t i = 0; i < up.size(); ++i) {
    const double least = std::min<double>(0x1p-20 * extentOf(parent.view()), 0.25 * (up[i] + down[i]));
    if (std::min(up[i], down[i]) < 0.75 * least - 0x1p-22 * reach) return "a corner of a cap meets an end of its edge";
  }
  return nullptr;
}

/// The same of both, and of their topology.
inline const char* findCutError(const Convex& parent, const Plane& plane, const Convex& above, const Convex& below) {
  const char* error = findTopologyError(above.view());
  if (error == nullptr) error = findTopologyError(below.view());
  if (error == nullptr) error = findSharingError(parent, above, below);
  if (error == nullptr) error = findCloseCornerError(parent, above, below);
  return error != nullptr ? error : findPlaneError(parent, plane, above, below);
}

}  // namespace brittle::geometry
