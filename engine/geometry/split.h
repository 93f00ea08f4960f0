// geometry/split.h - cut a convex polyhedron by a plane.
// The one operation all breaking is made of. Pure: no world, no randomness. Used by fracture/carve and
// fracture/shatter.
#pragma once

#include "engine/geometry/convex.h"

namespace brittle::geometry {

/// Thinnest piece a split may make, as a fraction of the parent's extent [-]. Below it float mass properties lose their
/// sign.
inline constexpr float kMinThickness = 0x1p-16f;
/// The same as a fraction of the parent's largest coordinate [-]: 32 units in the last place of a float, so that small
/// pieces far out in a large body stay well above the grid of floats.
inline constexpr float kMinThicknessOfReach = 0x1p-18f;

enum class SplitOutcome {
  Split,
  AllAbove,        // no vertex below
  AllBelow,        // no vertex above
  TooThin,         // a side reaches less far from the plane than the minimum, or has no volume
  TooManyIndices,  // a side needs more than kMaxHalfEdges
  TooFarOff,       // rounding left vertices so far on the wrong side that a piece would get a dent
};

/// What both children's caps are marked with.
struct CutMark {
  std::uint32_t cut = 0;
  FaceKind kind = FaceKind::Cut;
};

/// Scratch memory of a split, kept by the caller so that repeated splits allocate nothing.
template <class S>
struct SplitScratchT {
  /// A face crossed by the plane: the half-edge that goes up through it and the one that comes down.
  struct CutFace {
    std::uint32_t up;
    std::uint32_t down;
  };
  std::vector<S> distances;
  std::vector<std::uint8_t> sides;
  std::vector<std::uint32_t> indices;
  std::vector<CutFace> cut;
  std::vector<VertexT<S>> caps;
};
using SplitScratch = SplitScratchT<float>;

/// Cuts `parent` by `plane` (unit normal, except for exact scalars) into `above` (signed distance >= 0) and `below`. If
/// the outcome is not Split, neither is written. If `parent` is valid, so are both pieces: one closed cap each,
/// bit-identical cap vertices, other faces with the parent's planes bit for bit. Cap vertices lie within 2^-20 of the
/// parent's extent and 8 units in the last place of its largest coordinate, together, of the plane. `above` and `below`
/// must not alias `parent`. The order of vertices, faces and edges depends on the arguments only (replays rely on it).
/// Linear in half-edges; allocates only what the pieces and the scratch grow. Source: Gustafsson, Procedural
/// Destruction (talk): classify by sign, keep to the edge, then topology only; the sign repair is ours, see split.cpp.
template <class S>
SplitOutcome split(const ConvexViewT<S>& parent, const PlaneT<S>& plane, CutMark mark, SplitScratchT<S>& scratch,
                   ConvexT<S>& above, ConvexT<S>& below);

}  // namespace brittle::geometry
