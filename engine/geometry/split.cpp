// Rounding can give a sign pattern that no real plane gives: a face crossed four times. A splitter that trusts the
// signs then builds a broken mesh (measured on a unit cube cut to 512 pieces, float: 0.57 % of the cuts through an
// existing edge). So signs are repaired before anything is built. Keep, of the vertices above, the part connected to
// the farthest one, and move the rest below; then the same for those below (what moves up borders only on vertices
// above, so those stay connected). Now both sides are connected, the cut edges are a bond of a planar graph, and a
// bond's dual is one simple cycle: every face is crossed exactly 0 or 2 times and the cap is exactly one loop, of at
// least 3 edges because no two faces of a 3-connected graph share two. Topology cannot fail, whatever the floats did.
// Both children are 3-connected again: cut vertices have degree 3, others keep theirs, the cap shares one edge with
// each cut face, and two old faces share at most what they shared before.
//
// The repair costs nothing where it is not needed: the walk that finds the cap also finds out whether the cut is one
// simple cycle.
#include "engine/geometry/split.h"

#include "engine/geometry/split_impl.h"

namespace brittle::geometry {

std::uint32_t split_detail::mixColor(std::uint32_t a, std::uint32_t b, std::uint32_t weight) {
  std::uint32_t mixed = 0;
  for (int shift = 0; shift < 32; shift += 8) {
    const std::uint32_t channelA = (a >> shift) & 0xff;
    const std::uint32_t channelB = (b >> shift) & 0xff;
    mixed |= ((channelA * (256 - weight) + channelB * weight + 128) >> 8) << shift;
  }
  return mixed;
}

std::uint32_t split_detail::mixNormal(std::uint32_t a, std::uint32_t b, float weight) {
  if (a == 0 || b == 0) return 0;
  const Vec3 normalA = unpackNormal(a);
  const Vec3 normalB = unpackNormal(b);
  const Vec3 mixed = normalA * (1.0f - weight) + normalB * weight;
  return packNormal(normalizedOr(mixed, normalA));
}

template SplitOutcome split<float>(const ConvexViewT<float>&, const PlaneT<float>&, CutMark, SplitScratchT<float>&,
                                   ConvexT<float>&, ConvexT<float>&);
template SplitOutcome split<double>(const ConvexViewT<double>&, const PlaneT<double>&, CutMark, SplitScratchT<double>&,
                                    ConvexT<double>&, ConvexT<double>&);

}  // namespace brittle::geometry
