// fracture/fracture.h - breaking as pure geometry: (compound, impacts, material, seed) -> pieces. Knows no bodies;
// physics/breakage swaps the bodies. Carve the hole, shatter what is inside it, find what still hangs together.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/core/random.h"
#include "engine/fracture/material.h"
#include "engine/geometry/convex.h"
#include "engine/geometry/mass.h"
#include "engine/geometry/split.h"

namespace brittle::fracture {

/// Where and how it was hit, in the compound's local frame.
struct Impact {
  Vec3 point = Vec3::Zero();        // contact: where the cracks run from [m]; outside the body: the nearest point of it
  Vec3 direction = -Vec3::UnitZ();  // unit, the way the striker goes, relative to the compound
  float speed = 0.0f;               // [m/s], along `direction`
  float strikerRadius = 0.0f;       // bounding radius of the striker across `direction` [m]; the hole lets it through
  Vec3 toCenter = Vec3::Zero();     // from `point` to any point of the line on which the striker's centre goes [m]
};

/// Where a part touches static geometry: the corners of the contact area, a convex polygon in the compound's frame. One
/// or two points stand for themselves.
struct Anchor {
  Vec3 points[8];                // in order around the area [m]
  std::uint32_t pointCount = 0;  // up to 8
};

/// One convex of the compound that breaks.
struct Part {
  geometry::ConvexView convex;
  bool anchored = false;  // touches static geometry: what is connected to it stays
  std::uint32_t id = 0;   // the caller's, handed back in Piece::source
  std::span<const Anchor> anchors =
      {};  // where; a piece holds only if it still touches one. Empty: every remaining piece does
};

/// A convex of the result.
struct Piece {
  std::uint32_t source = 0;  // Part::id it came from
  bool isWhole = false;      // the source part itself, uncut
  bool anchored = false;
  bool isFragment = false;        // inside the carved volume
  std::uint32_t group = 0;        // pieces of one group hang together: one body
  std::uint32_t convex = 0;       // index into Fracture::convexes, unless isWhole
  geometry::MassProperties mass;  // unit density
};

/// A set of pieces that become (or stay) one body.
struct Group {
  bool anchored = false;   // stays with the static world
  bool keepsBody = false;  // the group that stays in the old body (the anchored ones; else the largest by volume)
  geometry::MassProperties mass;  // unit density, of all its pieces
};

/// Two pieces that share a cut face: where the first contact between their bodies will be. Local frame.
struct Neighbours {
  std::uint32_t pieceA = 0, pieceB = 0;
  Vec3 normal = Vec3::UnitY();  // unit, from A towards B
  Vec3 points[4];               // corners of the shared area, up to 4
  std::uint32_t pointCount = 0;
};

/// A piece too small to be a body.
struct Crumb {
  Vec3 center = Vec3::Zero();  // [m]
  float volume = 0.0f;         // [m3]
};

/// What a breaking makes. Reused from call to call: its vectors keep their capacity.
struct Fracture {
  std::vector<Piece> pieces;               // parts in order, each part's pieces in cutting order
  std::vector<geometry::Convex> convexes;  // only the first `convexCount` are of this breaking
  std::uint32_t convexCount = 0;
  std::vector<Group> groups;           // anchored ones first
  std::vector<Neighbours> neighbours;  // between pieces of different groups
  std::vector<Crumb> crumbs;
  std::uint32_t refusedCuts = 0;  // splits that answered TooThin, TooManyIndices or TooFarOff
};

/// All scratch memory of a breaking, so that a warm one allocates nothing.
class Fracturer {
 public:
  Fracturer();
  ~Fracturer();
  Fracturer(Fracturer&& other) noexcept;
  Fracturer& operator=(Fracturer&& other) noexcept;

  /// Breaks the compound `parts` hit by `impacts` (at least one; all carved). `crackSlop` [m] is the gap below which
  /// facing faces still hang together. Sum of piece and crumb volumes equals the parts' to 1e-6. The same arguments
  /// give the same bits.
  const Fracture& fracture(std::span<const Part> parts, std::span<const Impact> impacts,
                           const FractureMaterial& material, float crackSlop, std::uint64_t seed);

 private:
  struct Scratch;
  std::unique_ptr<Scratch> scratch_;
};

/// Groups a compound by connection without cutting anything: what tests compare a breaking with. For each part its
/// group; groups are numbered by their lowest part.
void connectParts(std::span<const Part> parts, float slop, std::vector<std::uint32_t>& groupOfPart);

/// True if two convexes (same frame) hang together: facing faces, closer than `slop` [m], share more than (2 slop)^2 of
/// area.
bool areConnected(const geometry::ConvexView& a, const geometry::ConvexView& b, float slop);

}  // namespace brittle::fracture
