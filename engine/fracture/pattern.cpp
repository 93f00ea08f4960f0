#include "engine/fracture/pattern.h"

#include <cmath>

#include "engine/math/trig.h"

namespace brittle::fracture {

namespace {

constexpr float kTurn = 2.0f * kPi;
constexpr float kClearance = 1.05f;  // how much wider than the striker's shadow the way through it is [-]
// All of these by eye, from pictures of the pattern.
constexpr float kEndShare = 0.5f;     // the hole ends so far beyond the sheet, of the radius [-]
constexpr float kThinRim = 0.12f;     // least depth beyond a wall, of the radius [-]
constexpr float kThinShard = 0.035f;  // least depth beside a crack, of the radius [-]
constexpr float kWidestCore = 1.45f;  // a wedge at the centre that is wider splits before its first ring [rad]
constexpr float kWidestBand = 1.5f;   // a piece of a ring that is longer than this many widths of the ring splits [-]
constexpr float kRimShare = 0.5f;     // pieces nearer to the centre do not stay in the rim, of the radius [-]
constexpr float kRingShare[2][3] = {{0.24f, 0.56f, 0.0f},
                                    {0.16f, 0.37f, 0.66f}};  // radii of 2 and 3 rings, of the radius [-]

Vec3 inSheet(const Strike& strike, float angle) {
  return strike.right * cosine(angle) + strike.up * sine(angle);
}

/// Distance [m] from the strike's centre beyond which nothing is in the striker's way, in the direction `outward`
/// within the sheet.
float clearDistance(const Strike& strike, const Vec3& outward) {
  const Vec3 aside = strike.passage - strike.center;
  return aside.dot(outward) + kClearance * reachWithinSheet(strike, strike.strikerRadius, outward);
}

/// Grows the tree wedge by wedge, in the angle about the centre.
class CrackGrower {
 public:
  CrackGrower(const Strike& strike, Random& random, CrackTree& tree) : strike_(strike), random_(random), tree_(tree) {}

  void grow(std::uint32_t radials, std::uint32_t rings, bool hasCore) {
    rings_ = rings;
    hasCore_ = hasCore;
    for (std::uint32_t i = 0; i < rings; ++i) radii_[i] = strike_.radius * kRingShare[rings == 3 ? 1 : 0][i];
    const float angle = random_.nextFloat(0.0f, kTurn);
    const std::uint32_t half = radials / 2;
    const std::int32_t first = add(radialPlane(angle, 0.0f, 0.0f));
    const std::int32_t above = growWedge({angle, angle + kPi, radials - half, 0});
    const std::int32_t below = growWedge({angle + kPi, angle + kTurn, half, 0});
    link(first, above, below);
  }

 private:
  struct Wedge {
    float from, to;         // [rad]
    std::uint32_t radials;  // sectors it has at the rim
    std::uint32_t ring;     // it begins beyond that many rings
  };

  std::int32_t add(const Plane& plane) {
    tree_.cracks.push_back({plane, kNoCrack, kNoCrack});
    return static_cast<std::int32_t>(tree_.cracks.size()) - 1;
  }
  void link(std::int32_t crack, std::int32_t above, std::int32_t below) {
    tree_.cracks[static_cast<std::size_t>(crack)].above = above;
    tree_.cracks[static_cast<std::size_t>(crack)].below = below;
  }

  /// Through the point at `radius` in direction `angle`, turned by `turn`. Above: larger angles.
  Plane radialPlane(float angle, float radius, float turn) const {
    const Vec3 point = strike_.center + inSheet(strike_, angle) * radius;
    return planeThrough(point, inSheet(strike_, angle + turn + 0.5f * kPi));
  }

  bool isTooWide(const Wedge& wedge) const {
    const float width = wedge.to - wedge.from;
    if (wedge.radials < 2) return false;
    if (wedge.ring == 0) return width > kWidestCore;
    if (wedge.ring == rings_) return true;
    const float inner = radii_[wedge.ring - 1], outer = radii_[wedge.ring];
    return width * 0.5f * (inner + outer) > kWidestBand * (outer - inner);
  }

  std::int32_t growWedge(const Wedge& wedge) {
    if (isTooWide(wedge)) return splitWedge(wedge);
    if (wedge.ring == rings_) return kNoCrack;
    return crossWedge(wedge);
  }

  std::int32_t splitWedge(const Wedge& wedge) {
    const std::uint32_t odd = wedge.radials & random_.nextBelow(2);
    const std::uint32_t lower = wedge.radials / 2 + odd;
    const float jitter = random_.nextFloat(-0.32f, 0.32f);
    const float share = (static_cast<float>(lower) + jitter) / static_cast<float>(wedge.radials);
    const float angle = wedge.from + (wedge.to - wedge.from) * share;
    const float turn = random_.nextFloat(-0.22f, 0.22f);
    const float radius = wedge.ring == 0 ? 0.0f : radii_[wedge.ring - 1];
    const std::int32_t crack = add(radialPlane(angle, radius, wedge.ring == 0 ? 0.25f * turn : turn));
    const std::int32_t above = growWedge({angle, wedge.to, wedge.radials - lower, wedge.ring});
    const std::int32_t below = growWedge({wedge.from, angle, lower, wedge.ring});
    link(crack, above, below);
    return crack;
  }

  /// A concentric crack: straight from one radial to the next, slanted at random, now and then missing.
  std::int32_t crossWedge(const Wedge& wedge) {
    const Wedge beyond{wedge.from, wedge.to, wedge.radials, wedge.ring + 1};
    const bool isMissing = random_.nextFloat() < 0.12f;
    const float radius = radii_[wedge.ring] * random_.nextFloat(0.72f, 1.28f);
    const float turn = random_.nextFloat(-0.42f, 0.42f);
    if (isMissing && wedge.ring > 0) return growWedge(beyond);
    const float middle = 0.5f * (wedge.from + wedge.to);
    const Vec3 outward = inSheet(strike_, middle + turn);
    const bool isCore = hasCore_ && wedge.ring == 0;
    // A crack that is left out for leaving a sliver must still be clear of the striker.
    const float distance = isCore ? clearDistance(strike_, outward) + tree_.minDepth : radius * cosine(turn);
    const std::int32_t crack = add(planeThrough(strike_.center + outward * distance, outward));
    const std::int32_t above = growWedge(beyond);
    link(crack, above, isCore ? kCore : kNoCrack);
    return crack;
  }

  const Strike& strike_;
  Random& random_;
  CrackTree& tree_;
  std::uint32_t rings_ = 0;
  bool hasCore_ = false;
  float radii_[3] = {};
};

/// Walls in an order that cuts opposite sides first: the rests of the body stay compact instead of becoming a pinwheel.
std::uint32_t wallAt(std::uint32_t position, std::uint32_t count) {
  const std::uint32_t half = (count + 1) / 2;
  const std::uint32_t pair = position / 2;
  const std::uint32_t quarter = (half + 1) / 2;
  const std::uint32_t base = pair % 2 == 0 ? pair / 2 : quarter + pair / 2;
  const std::uint32_t index = base + (position % 2 == 0 ? 0 : half);
  return index < count ? index : count;  // `count`: an odd wheel has one place without a wall
}

}  // namespace

Cell sheetCell(const Strike& strike, Random& random) {
  Cell cell;
  // What lies beyond the sheet belongs to another pane of the body: the far side of a glass box stays.
  const float end = 0.5f * strike.thickness + kEndShare * strike.radius;
  cell.walls[cell.count++] = {strike.normal, strike.middle + end};
  cell.walls[cell.count++] = {-strike.normal, end - strike.middle};
  const std::uint32_t count = kMinWalls + random.nextBelow(kMaxWalls - kMinWalls + 1);
  const float sector = kTurn / static_cast<float>(count);
  const float start = random.nextFloat(0.0f, kTurn);
  Plane walls[kMaxWalls];
  for (std::uint32_t i = 0; i < count; ++i) {
    const float jitter = random.nextFloat(-0.3f, 0.3f);
    const Vec3 outward = inSheet(strike, start + (static_cast<float>(i) + jitter) * sector);
    const float wanted = strike.radius * random.nextFloat(0.8f, 1.12f);
    walls[i] = planeThrough(strike.center + outward * maxOf(wanted, clearDistance(strike, outward)), outward);
  }
  for (std::uint32_t position = 0; cell.count < count + 2; ++position) {
    const std::uint32_t index = wallAt(position, count);
    if (index < count) cell.walls[cell.count++] = walls[index];
  }
  cell.minDepth = kThinRim * strike.radius;
  return cell;
}

bool isAtRim(const Strike& strike, const geometry::ConvexView& convex, const Vec3& center) {
  const Vec3 offset = center - strike.center;
  const Vec3 outward = normalizedOr(offset - strike.normal * strike.normal.dot(offset), strike.right);
  const float least = maxOf(clearDistance(strike, outward), kRimShare * strike.radius);
  for (const geometry::Vertex& vertex : convex.vertices) {
    if (outward.dot(vertex.point - strike.center) < least) return false;
  }
  return true;
}

Cell blockCell(const Strike& strike, Random& random) {
  Cell cell;
  cell.count = kMinWalls + random.nextBelow(kMaxWalls - kMinWalls + 1);
  const float roll = random.nextFloat(0.0f, kTurn);
  constexpr float kGoldenAngle = 2.39996323f;
  for (std::uint32_t i = 0; i < cell.count; ++i) {
    // A spiral over the sphere, shaken: even enough that the cell is always closed.
    const float jitterHeight = random.nextFloat(-0.25f, 0.25f);
    const float jitterAngle = random.nextFloat(-0.3f, 0.3f);
    const float height = 1.0f - (2.0f * static_cast<float>(i) + 1.0f + jitterHeight) / static_cast<float>(cell.count);
    const float angle = roll + kGoldenAngle * static_cast<float>(i) + jitterAngle;
    const float ring = std::sqrt(maxOf(1.0f - height * height, 0.0f));
    const Vec3 outward = (inSheet(strike, angle) * ring + strike.normal * height).normalized();
    const float wanted = strike.radius * random.nextFloat(0.7f, 1.0f);
    cell.walls[i] = planeThrough(strike.center + outward * maxOf(wanted, 1.05f * strike.strikerRadius), outward);
  }
  cell.minDepth = kThinRim * strike.radius;
  return cell;
}

std::uint32_t radialCount(const FractureMaterial& material, float speed) {
  const float wanted = 10.0f * material.density * std::sqrt(maxOf(speed, 0.0f) / 10.0f);
  return static_cast<std::uint32_t>(clampTo(wanted, 4.0f, 40.0f) + 0.5f);
}

void growSheetCracks(const Strike& strike, const FractureMaterial& material, float speed, Random& random,
                     CrackTree& tree) {
  tree.cracks.clear();
  tree.minDepth = kThinShard * strike.radius;
  const std::uint32_t rings = 2 + random.nextBelow(2);
  const bool hasCore = material.pattern == Pattern::Laminated;
  CrackGrower(strike, random, tree).grow(radialCount(material, speed), rings, hasCore);
}

}  // namespace brittle::fracture
