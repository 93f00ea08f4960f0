// fracture/neighbours.h - the faces that pieces share across a cut. The cut knows its neighbours: two pieces of one
// part touch only across the cut that parted them, so candidates are looked for among the caps of one cut and nowhere
// else.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/fracture/connect.h"

namespace brittle::fracture {

/// Two pieces and what they share.
struct SharedFace {
  Neighbours seed;    // pieceA < pieceB
  float area = 0.0f;  // [m2]
};

struct CutFace {
  std::uint32_t cut;
  std::uint32_t piece;
  std::uint32_t face;
};

/// Finds every pair of pieces that share more than `leastArea` [m2] of a cut. `pieces` are in one frame; those with
/// isUsed false are left out. In ascending order of (pieceA, pieceB).
class SharedFaceFinder {
 public:
  void find(std::span<const Node> pieces, float leastArea, std::vector<SharedFace>& shared);

 private:
  void collect(std::span<const Node> pieces);
  void pair(std::span<const Node> pieces, const CutFace& a, const CutFace& b, float leastArea,
            std::vector<SharedFace>& shared);

  std::vector<CutFace> caps_;
  std::vector<CutFace> above_, below_;
  std::vector<Vec3> polygon_, clip_;
};

/// Up to four corners of the polygon that span it best, in order around it.
std::uint32_t mainCorners(std::span<const Vec3> polygon, const Vec3& normal, Vec3 (&corners)[4]);

}  // namespace brittle::fracture
