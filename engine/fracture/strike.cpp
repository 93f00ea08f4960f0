#include "engine/fracture/strike.h"

#include <cmath>

namespace brittle::fracture {

namespace {

// The hole is this much wider than the striker, so that it passes without scraping. [-], [m] By eye.
constexpr float kHoleWidening = 1.35f, kHoleMargin = 0.002f;
// A part thicker than this share of its width is no sheet by itself. [-] By eye.
constexpr float kSheetThickness = 0.5f;
// Slants beyond 70 degrees are treated as 70: the passage would otherwise grow without bounds. [-]
constexpr float kLeastCosine = 0.342f;
// Speed at which a hole has the material's carve radius. [m/s]
constexpr float kReferenceSpeed = 10.0f;

/// The point of a face closest to a point above it. Outside an edge the closest point lies on the rim, else straight
/// below.
Vec3 closestOnFace(const geometry::ConvexView& convex, const geometry::Face& face, const Vec3& point) {
  Vec3 best = point - face.plane.normal * face.plane.distance(point);
  float bestSquared = 3.0e38f;
  std::uint32_t edge = face.edge;
  do {
    const Vec3 start = convex.startOf(edge);
    const Vec3 along = convex.endOf(edge) - start;
    const Vec3 offset = point - start;
    if (face.plane.normal.cross(along).dot(offset) < 0.0f) {
      const float lengthSquared = along.squaredNorm();
      const float t = lengthSquared > 0.0f ? clampTo(offset.dot(along) / lengthSquared, 0.0f, 1.0f) : 0.0f;
      const Vec3 candidate = start + along * t;
      const float squared = (candidate - point).squaredNorm();
      if (squared < bestSquared) {
        bestSquared = squared;
        best = candidate;
      }
    }
    edge = convex.edges[edge].next;
  } while (edge != face.edge);
  return best;
}

struct BroadFace {
  float score = -1.0f;  // area, a little more if hit head-on, so that a cube is struck where it is struck
  float area = 0.0f;    // [m2]
  Vec3 normal = Vec3::UnitZ();
};

void considerFaces(const geometry::ConvexView& convex, const Vec3& direction, BroadFace& best) {
  for (const geometry::Face& face : convex.faces) {
    const Vec3 origin = convex.startOf(face.edge);
    Vec3 doubled = Vec3::Zero();
    for (std::uint32_t edge = face.edge;;) {
      doubled += (convex.startOf(edge) - origin).cross(convex.endOf(edge) - origin);
      edge = convex.edges[edge].next;
      if (edge == face.edge) break;
    }
    const float area = 0.5f * doubled.norm();
    const float score = area * (1.0f + 0.25f * std::fabs(face.plane.normal.dot(direction)));
    if (score > best.score * 1.0001f) best = {score, area, face.plane.normal};
  }
}

/// Least and largest coordinate of the convex along `axis`.
struct Span {
  float low = 3.0e38f, high = -3.0e38f;
};

Span spanAlong(const geometry::ConvexView& convex, const Vec3& axis) {
  Span span;
  for (const geometry::Vertex& vertex : convex.vertices) {
    const float at = axis.dot(vertex.point);
    span.low = minOf(span.low, at);
    span.high = maxOf(span.high, at);
  }
  return span;
}

/// The broadest face says which way the sheet lies: that of the part hit, or of the whole body if the part is a mere
/// rod of it.
void findSheet(std::span<const Part> parts, Strike& strike) {
  BroadFace broad;
  considerFaces(parts[strike.part].convex, strike.direction, broad);
  Span span = spanAlong(parts[strike.part].convex, broad.normal);
  if (span.high - span.low > kSheetThickness * std::sqrt(broad.area)) {
    for (const Part& part : parts) considerFaces(part.convex, strike.direction, broad);
    span = spanAlong(parts[strike.part].convex, broad.normal);
  }
  strike.normal = broad.normal;
  strike.right = perpendicular(strike.normal);
  strike.up = strike.normal.cross(strike.right);
  strike.middle = 0.5f * (span.low + span.high);
  strike.thickness = span.high - span.low;
}

/// Cosine of the slant, with its sign.
float slantCosine(const Strike& strike) {
  const float cosine = strike.normal.dot(strike.direction);
  if (cosine < 0.0f) return minOf(cosine, -kLeastCosine);
  return maxOf(cosine, kLeastCosine);
}

}  // namespace

Vec3 closestPoint(const geometry::ConvexView& convex, const Vec3& point) {
  Vec3 best = point;
  float bestSquared = 3.0e38f;
  for (const geometry::Face& face : convex.faces) {
    if (face.plane.distance(point) <= 0.0f) continue;
    const Vec3 candidate = closestOnFace(convex, face, point);
    const float squared = (candidate - point).squaredNorm();
    if (squared < bestSquared) {
      bestSquared = squared;
      best = candidate;
    }
  }
  return best;
}

Strike strikeOf(std::span<const Part> parts, const Impact& impact, const FractureMaterial& material) {
  Strike strike;
  float bestSquared = 3.0e38f;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Vec3 candidate = closestPoint(parts[i].convex, impact.point);
    const float squared = (candidate - impact.point).squaredNorm();
    if (squared < bestSquared) {
      bestSquared = squared;
      strike.center = candidate;
      strike.part = static_cast<std::uint32_t>(i);
    }
  }
  strike.direction = normalizedOr(impact.direction, -Vec3::UnitZ());
  strike.strikerRadius = maxOf(impact.strikerRadius, 0.0f);
  const float grown = material.carveRadius * std::sqrt(maxOf(impact.speed, 0.0f) / kReferenceSpeed);
  strike.radius = maxOf(kHoleWidening * strike.strikerRadius + kHoleMargin, grown);
  findSheet(parts, strike);
  const Vec3 onPath = impact.point + impact.toCenter;
  const float toMiddle = strike.middle - strike.normal.dot(onPath);
  strike.passage = onPath + strike.direction * (toMiddle / slantCosine(strike));
  // With the slant limited the point just found is off the middle plane: only its place within the sheet counts.
  strike.passage += strike.normal * (strike.middle - strike.normal.dot(strike.passage));
  return strike;
}

float reachWithinSheet(const Strike& strike, float strikerRadius, const Vec3& along) {
  // The cylinder cuts a plane parallel to the sheet in an ellipse with half axes r and r / cos, whose centre moves by
  // thickness/2 * tan from the middle of the sheet to either side. u = along . slant:
  // reach = r sqrt(1 - u^2 + u^2 / cos^2) + |u| thickness/2 tan
  const float cosine = std::fabs(slantCosine(strike));
  const float tangentOfSlant = std::sqrt(maxOf(1.0f - cosine * cosine, 0.0f)) / cosine;
  const Vec3 slantRaw = strike.direction - strike.normal * strike.normal.dot(strike.direction);
  const Vec3 slant = normalizedOr(slantRaw, strike.right);
  const float u = minOf(std::fabs(along.dot(slant)), 1.0f);
  const float ellipse = strikerRadius * std::sqrt((1.0f - u * u) + u * u / (cosine * cosine));
  return ellipse + 0.5f * u * strike.thickness * tangentOfSlant;
}

}  // namespace brittle::fracture
