// fracture/pattern.h - the planes a material breaks along: the walls of the carved volume, and the cracks inside it as
// a tree of planes (each cut only within what the planes above it left). Pure numbers; carve and shatter do the
// cutting.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/random.h"
#include "engine/fracture/strike.h"

namespace brittle::fracture {

inline constexpr std::uint32_t kMinWalls = 8, kMaxWalls = 14;  // a sheet's cell has two more: its ends

/// A convex volume: below all its planes.
struct Cell {
  Plane walls[kMaxWalls + 2];
  std::uint32_t count = 0;
  float minDepth = 0.0f;  // a wall that would leave less than this beyond it [m] is left out: no thin rims
};

/// The hole in a sheet: an irregular polygonal cylinder along the sheet's normal about the strike's centre, with the
/// strike's radius give or take a fifth. Whatever the slant, the striker fits through. walls[0] and walls[1] are its
/// ends, beyond the sheet.
Cell sheetCell(const Strike& strike, Random& random);

/// True if all of the convex is clear of the striker's way through the sheet and far enough from the centre to stay in
/// the rim.
bool isAtRim(const Strike& strike, const geometry::ConvexView& convex, const Vec3& center);

/// The hole in a block: an irregular polyhedron about the strike's centre; a ball of the striker's radius fits in.
Cell blockCell(const Strike& strike, Random& random);

/// How many radial cracks reach the rim: 10 at 10 m/s, growing with the square root of the speed [m/s] between 4
/// and 40. Source of the exponent: Vandenberghe, Vermorel, Villermaux, Star-Shaped Crack Pattern of Broken Windows,
/// 2013.
std::uint32_t radialCount(const FractureMaterial& material, float speed);

/// Ends of the tree: a piece, and a piece of the core, which the striker meets.
inline constexpr std::int32_t kNoCrack = -1, kCore = -2;

struct Crack {
  Plane plane;
  std::int32_t above = kNoCrack, below = kNoCrack;  // the next crack on each side
};

/// cracks[0] comes first; empty: nothing is cut.
struct CrackTree {
  std::vector<Crack> cracks;
  float minDepth = 0.0f;  // a crack that would leave less than this on a side [m] is left out
};

/// Radial cracks that branch outwards, and concentric ones from radial to radial, denser towards the centre. In
/// laminated glass the first ring runs around the striker, so that what it pushes out is the core and nothing else.
void growSheetCracks(const Strike& strike, const FractureMaterial& material, float speed, Random& random,
                     CrackTree& tree);

}  // namespace brittle::fracture
