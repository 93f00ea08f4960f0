// geometry/clip.h - convex polygons in the plane of a face: clipping one face by another, areas.
// Source: Sutherland and Hodgman, Reentrant Polygon Clipping, 1974.
#pragma once

#include <vector>

#include "engine/geometry/convex.h"
#include "engine/math/transform.h"

namespace brittle::geometry {

/// The corners of a face, counter-clockwise seen from outside, moved by `pose`. Written into `polygon`.
void facePolygon(const ConvexView& convex, std::uint32_t face, const Transform& pose, std::vector<Vec3>& polygon);

/// Keeps the part of `polygon` below the plane (distance <= 0). May empty it.
void clipPolygon(const Plane& plane, std::vector<Vec3>& scratch, std::vector<Vec3>& polygon);

/// Clips `polygon` by the side planes of a face (planes through its edges, perpendicular to the face).
void clipToFace(const ConvexView& convex, std::uint32_t face, const Transform& pose, std::vector<Vec3>& scratch,
                std::vector<Vec3>& polygon);

/// Area [m2] of a planar polygon.
float polygonArea(const std::vector<Vec3>& polygon);

/// The face whose outward normal (in the convex's frame) is most along `directionLocal`; ties: lowest index.
std::uint32_t supportFace(const ConvexView& convex, const Vec3& directionLocal);

}  // namespace brittle::geometry
