// fracture/chunk.h - the convexes of a breaking under way: parts not cut so far, and what was cut from them. Owns the
// free list of result convexes and the one place where a cut is made and refusals are counted. Knows no pattern.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/fracture/fracture.h"
#include "engine/geometry/split.h"

namespace brittle::fracture {

/// Slot of a chunk that is the part itself, uncut.
inline constexpr std::uint32_t kWholePart = 0xffffffff;

struct Chunk {
  std::uint32_t part = 0;           // index into the parts
  std::uint32_t slot = kWholePart;  // index into Fracture::convexes
  bool isFragment = false;          // inside a carved volume
  bool isBonded = false;            // a fragment that laminated glass holds
  bool isRim = false;               // a fragment that stays if it hangs on what remains
};

/// How far a convex reaches to both sides of a plane. [m], >= 0
struct Depths {
  float above = 0.0f, below = 0.0f;
};
Depths depthsOf(const geometry::ConvexView& convex, const Plane& plane);

enum class CutResult { Split, StaysAbove, StaysBelow };

class ChunkStore {
 public:
  /// Starts a breaking of `parts`, whose new convexes go into `made`. Both must outlive it.
  void begin(std::span<const Part> parts, std::vector<geometry::Convex>& made);

  /// Valid until the next cut.
  geometry::ConvexView view(const Chunk& chunk) const;

  /// Cuts `parent` (which stays as it was; release it when done with it). Unless the result is Split, `above` and
  /// `below` are not written and the result says on which side the uncut chunk lies for the most part.
  CutResult cut(const Chunk& parent, const Plane& plane, Chunk& above, Chunk& below);

  /// Gives the chunk's slot back.
  void release(const Chunk& chunk);

  /// Moves the convexes of `chunks` into the first slots and returns how many they are. No further cut after that.
  std::uint32_t compact(std::span<Chunk> chunks);

  std::uint32_t refusedCuts() const { return refusedCuts_; }
  std::span<const Part> parts() const { return parts_; }

 private:
  std::uint32_t acquire();

  std::span<const Part> parts_;
  std::vector<geometry::Convex>* made_ = nullptr;
  std::vector<std::uint32_t> free_;
  std::vector<std::uint8_t> taken_;
  geometry::SplitScratch scratch_;
  std::uint32_t used_ = 0;
  std::uint32_t nextCut_ = 1;
  std::uint32_t refusedCuts_ = 0;
};

}  // namespace brittle::fracture
