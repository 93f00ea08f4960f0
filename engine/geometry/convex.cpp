#include "engine/geometry/convex.h"

#include <cmath>

#include "engine/geometry/convex_impl.h"

namespace brittle::geometry {
namespace {

using convex_detail::TopologyScratch;
using convex_detail::turned;
using Edges = std::span<const Edge>;

constexpr float kNormalScale = 127.0f;
constexpr std::uint32_t kNormalMarker = 0x7f000000u;  // never 0, so that a packed normal never is

/// Indices in range, and each half-edge and its opposite run between the same two vertices.
const char* findLinkError(Edges edges, std::uint32_t vertexCount, std::uint32_t faceCount) {
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    const Edge& edge = edges[i];
    if (edge.face >= faceCount) return "a half-edge names a face that does not exist";
    if (edge.vertex >= vertexCount) return "a half-edge names a vertex that does not exist";
    if (edge.next >= edges.size() || edge.opposite >= edges.size()) return "a half-edge links out of range";
  }
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    const Edge& opposite = edges[edges[i].opposite];
    if (opposite.opposite != i || edges[i].opposite == i) return "opposite is not symmetric";
    if (opposite.vertex != edges[edges[i].next].vertex) return "a half-edge and its opposite do not share their ends";
  }
  return nullptr;
}

/// Every face is one closed loop of at least 3, and every half-edge is in one.
const char* findLoopError(Edges edges, std::span<const std::uint16_t> firstEdges) {
  std::uint32_t total = 0;
  for (std::uint32_t face = 0; face < firstEdges.size(); ++face) {
    const std::uint32_t first = firstEdges[face];
    if (first >= edges.size()) return "a face names an edge that does not exist";
    std::uint32_t count = 0;
    std::uint32_t edge = first;
    do {
      if (edges[edge].face != face) return "a loop leaves its face";
      if (++count > edges.size()) return "a loop does not close";
      edge = edges[edge].next;
    } while (edge != first);
    if (count < 3) return "a loop has fewer than 3 edges";
    total += count;
  }
  return total == edges.size() ? nullptr : "a half-edge is in no loop";
}

/// The vertex graph is connected, every vertex has one fan and at least 3 edges. Walks the fans of all vertices it can
/// reach.
const char* findFanError(Edges edges, std::uint32_t vertexCount, TopologyScratch& scratch) {
  scratch.stamps.assign(vertexCount, 0);
  scratch.pending.clear();
  scratch.pending.push_back(0);
  scratch.stamps[edges[0].vertex] = 1;
  std::uint32_t reached = 0;
  std::uint32_t total = 0;
  while (!scratch.pending.empty()) {
    const std::uint32_t first = scratch.pending.back();
    scratch.pending.pop_back();
    ++reached;
    std::uint32_t degree = 0;
    std::uint32_t edge = first;
    do {
      if (++degree > edges.size()) return "a fan does not close";
      const std::uint16_t opposite = edges[edge].opposite;
      std::uint16_t& stamp = scratch.stamps[edges[opposite].vertex];
      if (stamp == 0) scratch.pending.push_back(opposite);
      stamp = 1;
      edge = edges[opposite].next;
    } while (edge != first);
    if (degree < 3) return "a vertex has fewer than 3 edges";
    total += degree;
  }
  if (reached != vertexCount) return "the vertices do not hang together";
  return total == edges.size() ? nullptr : "a vertex has more than one fan";
}

/// Two faces meet at most once: in nothing, a vertex or an edge. For a planar graph that is 3-connectivity (and
/// excludes double edges). Source: Ziegler, Lectures on Polytopes, 1995, chapter 4.
const char* findMeetingError(Edges edges, std::span<const std::uint16_t> firstEdges, TopologyScratch& scratch) {
  scratch.stamps.assign(firstEdges.size(), 0);
  for (std::uint32_t face = 0; face < firstEdges.size(); ++face) {
    const auto mark = static_cast<std::uint16_t>(face + 1);  // faces are fewer than half-edges / 3
    scratch.stamps[face] = mark;
    const std::uint32_t first = firstEdges[face];
    std::uint32_t edge = first;
    do {
      std::uint16_t& across = scratch.stamps[edges[edges[edge].opposite].face];
      if (across == mark) return "two faces share more than one edge";
      across = mark;
      // The faces around the start of the edge, without the two that share an edge with this face there.
      std::uint32_t around = turned(edges, turned(edges, edge));
      for (std::uint32_t after = turned(edges, around); after != edge; after = turned(edges, around)) {
        std::uint16_t& touching = scratch.stamps[edges[around].face];
        if (touching == mark) return "two faces meet more than once";
        touching = mark;
        around = after;
      }
      edge = edges[edge].next;
    } while (edge != first);
  }
  return nullptr;
}

}  // namespace

convex_detail::TopologyScratch& convex_detail::topologyScratch() {
  static thread_local TopologyScratch scratch;
  return scratch;
}

const char* convex_detail::findEdgeError(Edges edges, std::uint32_t vertexCount,
                                         std::span<const std::uint16_t> firstEdges) {
  if (edges.size() > kMaxHalfEdges) return "more half-edges than 16 bits count";
  if (vertexCount < 4 || firstEdges.size() < 4) return "fewer than 4 vertices or faces";
  if (vertexCount + firstEdges.size() != edges.size() / 2 + 2 || edges.size() % 2 != 0) return "Euler's identity fails";
  TopologyScratch& scratch = topologyScratch();
  const char* error = findLinkError(edges, vertexCount, static_cast<std::uint32_t>(firstEdges.size()));
  if (!error) error = findLoopError(edges, firstEdges);
  if (!error) error = findFanError(edges, vertexCount, scratch);
  if (!error) error = findMeetingError(edges, firstEdges, scratch);
  return error;
}

std::uint32_t packNormal(const Vec3& normal) {
  std::uint32_t packed = kNormalMarker;
  for (int i = 0; i < 3; ++i) {
    const float scaled = clampTo(normal[i], -1.0f, 1.0f) * kNormalScale;
    const auto rounded = static_cast<std::int32_t>(scaled < 0.0f ? scaled - 0.5f : scaled + 0.5f);
    packed |= static_cast<std::uint32_t>(rounded & 0xff) << (8 * i);
  }
  return packed;
}

Vec3 unpackNormal(std::uint32_t packed) {
  if (packed == 0) return Vec3::Zero();
  Vec3 normal;
  for (int i = 0; i < 3; ++i) normal[i] = static_cast<float>(static_cast<std::int8_t>((packed >> (8 * i)) & 0xff));
  return normalizedOr(normal, Vec3::Zero());
}

float convexityError(const ConvexView& convex) {
  float largest = 0.0f;
  for (const Face& face : convex.faces) {
    for (const Vertex& vertex : convex.vertices) largest = maxOf(largest, face.plane.distance(vertex.point));
  }
  return largest;
}

template const char* findTopologyError<float>(const ConvexViewT<float>&);
template const char* findTopologyError<double>(const ConvexViewT<double>&);
template float extentOf<float>(const ConvexViewT<float>&);
template double extentOf<double>(const ConvexViewT<double>&);

}  // namespace brittle::geometry
