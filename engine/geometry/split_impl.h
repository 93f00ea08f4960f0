// geometry/split_impl.h - the body of split.h's template. Include it only to instantiate it for another scalar (tests
// do, with exact rationals); float and double are instantiated in split.cpp. How it works is told there.
#pragma once

#include "engine/core/assert.h"
#include "engine/geometry/convex_impl.h"
#include "engine/geometry/split.h"
#include "engine/geometry/split_cap.h"
#include "engine/geometry/split_sides.h"

namespace brittle::geometry::split_detail {

/// Builds both children from the sides and the cut vertices. No coordinates are computed here: topology only.
template <class S>
class Writer {
 public:
  explicit Writer(const Sides<S>& sides) : sides_(sides) {}

  void write(const PlaneT<S>& plane, CutMark mark, ConvexT<S>& above, ConvexT<S>& below) {
    writeVertices(above, below);
    writeFaces(above, below);
    writeEdges(above, below);
    writeCap(above, kAbove, plane.flipped(), mark);
    writeCap(below, kBelow, plane, mark);
  }

 private:
  using Index = std::uint32_t;

  void writeVertices(ConvexT<S>& above, ConvexT<S>& below) {
    const Index count = static_cast<Index>(sides_.parent.vertices.size());
    vertexMap_ = sides_.faceCut + 3 * sides_.parent.faces.size();
    Index next[2] = {0, 0};
    for (Index i = 0; i < count; ++i) vertexMap_[i] = next[sides_.scratch.sides[i]]++;
    capStart_[kBelow] = next[kBelow];
    capStart_[kAbove] = next[kAbove];
    above.vertices.resize(next[kAbove] + sides_.cutCount());
    below.vertices.resize(next[kBelow] + sides_.cutCount());
    for (Index i = 0; i < count; ++i) {
      ConvexT<S>& child = sides_.scratch.sides[i] == kAbove ? above : below;
      child.vertices[vertexMap_[i]] = sides_.parent.vertices[i];
    }
    for (Index i = 0; i < sides_.cutCount(); ++i) {
      above.vertices[next[kAbove] + i] = sides_.scratch.caps[i];
      below.vertices[next[kBelow] + i] = sides_.scratch.caps[i];
    }
  }

  /// Faces keep their order, plane and mark; a cut face goes to both, entered by its new edge. The caps come last.
  void writeFaces(ConvexT<S>& above, ConvexT<S>& below) {
    const Index count = static_cast<Index>(sides_.parent.faces.size());
    faceMap_[kBelow] = sides_.faceCut + count;
    faceMap_[kAbove] = faceMap_[kBelow] + count;
    Index next[2] = {0, 0};
    for (Index i = 0; i < count; ++i) {
      const bool isCut = sides_.isCut(i);
      const std::uint8_t side = sides_.sideOf(sides_.parent.faces[i].edge);
      for (const std::uint8_t s : {kBelow, kAbove}) {
        if (isCut || s == side) faceMap_[s][i] = next[s]++;
      }
    }
    above.faces.resize(next[kAbove] + 1);
    below.faces.resize(next[kBelow] + 1);
    for (Index i = 0; i < count; ++i) {
      const bool isCut = sides_.isCut(i);
      const std::uint8_t side = sides_.sideOf(sides_.parent.faces[i].edge);
      for (const std::uint8_t s : {kBelow, kAbove}) {
        if (!isCut && s != side) continue;
        FaceT<S>& face = (s == kAbove ? above : below).faces[faceMap_[s][i]];
        face = sides_.parent.faces[i];
        const Index edge =
            isCut ? sides_.edgeCount[s] + sides_.cutCount() + 2 * sides_.faceCut[i] : sides_.edgeMap[face.edge];
        face.edge = static_cast<std::uint16_t>(edge);
      }
    }
  }

  /// Half-edges keep their order. What this writes into `next` and `opposite` of cut ones is mended by writeCap.
  void writeEdges(ConvexT<S>& above, ConvexT<S>& below) {
    above.edges.resize(sides_.edgeCount[kAbove] + 3 * sides_.cutCount());
    below.edges.resize(sides_.edgeCount[kBelow] + 3 * sides_.cutCount());
    Edge* children[2] = {below.edges.data(), above.edges.data()};
    for (const Edge& edge : sides_.parent.edges) {
      const std::uint8_t side = sides_.scratch.sides[edge.vertex];
      *children[side]++ = {static_cast<std::uint16_t>(faceMap_[side][edge.face]),
                           static_cast<std::uint16_t>(vertexMap_[edge.vertex]),
                           static_cast<std::uint16_t>(sides_.edgeMap[edge.next]),
                           static_cast<std::uint16_t>(sides_.edgeMap[edge.opposite])};
    }
  }

  /// Closes one child. The i-th cut face is entered by its half-edge `up` and left by `down`; cut vertex i lies on
  /// `up`. After the child's `inherited` half-edges come: the far part of each half-edge that reaches in from the other
  /// side; then for each cut face the new edge that closes it, and that edge's opposite, on the cap.
  void writeCap(ConvexT<S>& child, std::uint8_t side, const PlaneT<S>& plane, CutMark mark) {
    const bool isAbove = side == kAbove;
    const Index inherited = sides_.edgeCount[side];
    const Index count = sides_.cutCount();
    const Index capFace = static_cast<Index>(child.faces.size()) - 1;
    Edge* edges = child.edges.data();
    const auto write = [edges](Index at, Index face, Index vertex, Index next, Index opposite) {
      edges[at] = {static_cast<std::uint16_t>(face), static_cast<std::uint16_t>(vertex),
                   static_cast<std::uint16_t>(next), static_cast<std::uint16_t>(opposite)};
    };
    for (Index i = 0; i < count; ++i) {
      const Index after = i + 1 == count ? 0 : i + 1;
      const Index before = i == 0 ? count - 1 : i - 1;
      // In the face, the child's loop enters by `entering` (its far part) and leaves by `leaving` (its near part).
      const Index entering = isAbove ? sides_.scratch.cut[i].up : sides_.scratch.cut[i].down;
      const Index leaving = isAbove ? sides_.scratch.cut[i].down : sides_.scratch.cut[i].up;
      const Index entryVertex = capStart_[side] + (isAbove ? i : after);
      const Index exitVertex = capStart_[side] + (isAbove ? after : i);
      const Index following = isAbove ? after : before;  // the cut face beyond `leaving`
      const Index face = faceMap_[side][sides_.parent.edges[entering].face];
      const Index farPart = inherited + i;
      const Index closing = inherited + count + 2 * i;
      write(farPart, face, entryVertex, sides_.edgeMap[sides_.parent.edges[entering].next],
            sides_.edgeMap[sides_.parent.edges[entering].opposite]);
      write(closing, face, exitVertex, farPart, closing + 1);
      write(closing + 1, capFace, entryVertex, inherited + count + 2 * following + 1, closing);
      Edge& nearPart = edges[sides_.edgeMap[leaving]];
      nearPart.next = static_cast<std::uint16_t>(closing);
      nearPart.opposite = static_cast<std::uint16_t>(inherited + following);
    }
    // Both caps start at cut vertex 0, see haveVolume.
    const Index first = inherited + count + 1 + (isAbove ? 0 : 2 * (count - 1));
    child.faces[capFace] = {plane, static_cast<std::uint16_t>(first), mark.kind, mark.cut};
  }

  const Sides<S>& sides_;
  Index capStart_[2] = {0, 0};  // first cut vertex in each child
  Index* faceMap_[2] = {nullptr, nullptr};
  Index* vertexMap_ = nullptr;
};

}  // namespace brittle::geometry::split_detail

namespace brittle::geometry {

template <class S>
SplitOutcome split(const ConvexViewT<S>& parent, const PlaneT<S>& plane, CutMark mark, SplitScratchT<S>& scratch,
                   ConvexT<S>& above, ConvexT<S>& below) {
  using namespace split_detail;
  Sides<S> sides(parent, scratch);
  const SplitOutcome outcome = sides.classify(plane);
  if (outcome != SplitOutcome::Split) return outcome;
  if (!sides.walkCut()) {
    sides.repair();
    const bool isOneLoop = sides.walkCut();
    BR_ASSERT(isOneLoop && "split needs a 3-connected parent");
    if (sides.isTooFarOff()) return SplitOutcome::TooFarOff;
  }
  const std::uint32_t most = maxOf(sides.edgeCount[kAbove], sides.edgeCount[kBelow]);
  if (most + 3 * sides.cutCount() > kMaxHalfEdges) return SplitOutcome::TooManyIndices;
  makeCutVertices(sides);
  if (!haveVolume(sides)) return SplitOutcome::TooThin;
  Writer<S>(sides).write(plane, mark, above, below);
  BR_VALIDATE(findTopologyError<S>(above.view()) == nullptr);
  BR_VALIDATE(findTopologyError<S>(below.view()) == nullptr);
  return SplitOutcome::Split;
}

}  // namespace brittle::geometry
