// The list of hard cases. Each one's tests stand in a file that begins with its id; a case without tests is an error.
#include "tests/hard_cases/case.h"

namespace brittle::hard {
namespace {

constexpr Case kCases[] = {
    // Splitting.
    {"B1", "random cuts of a cube, 512 pieces a round",
     "no topology failure; a round's volume within 1e-6; pieces convex within the move distance"},
    {"B2", "cuts through an existing vertex",
     "no topology failure; the vertex stands in one child; caps identical, off the ends of edges"},
    {"B3", "cuts through an existing edge, also an ulp beside it", "no topology failure; every child has volume"},
    {"B4", "cuts on the plane of an existing face, either way round", "no topology failure; no empty piece"},
    {"B5", "slivers of 1e-4 and 1e-6, cut in every direction",
     "no topology failure; kept and lost volume add up to 1e-6; "
     "inertia positive definite"},
    {"B6", "vertices of high degree: cones about axes and on a sphere",
     "no topology failure, no cut refused for rounding; the exact cutter's faces where signs agree"},
    {"B7", "mating: both children of a cut", "caps identical bit for bit; the parts add up to the parent"},
    {"B8", "carving: corner, edge, diagonal and seam hits",
     "volume kept to 1e-6; each point of the parent in one piece"},
    {"B9", "micro-shards: 1 mm holes, 500 shards below 1 cm3",
     "finite; none lighter than allowed or faster than the hit; "
     "work per shard below twice that of 50"},
    {"B10", "mass properties against exact integrals", "mass and centre to 1e-6, inertia to 1e-5; children add up"},
    {"B11", "index limits: a cylinder of 8000 sides", "a typed refusal, the parent untouched"},
    {"B12", "fracture at 0 to 1e5 m from the origin", "pieces and velocities the same bits"},
    {"B13", "scales from 1 mm to 100 m", "same topology at powers of two; no topology failure"},
    {"B14", "the same planes in every order", "the same set of cells; volumes to 1e-6"},
    {"B15", "connected or not: face, edge, corner, gap, overlap",
     "one threshold; agrees with the exact test beyond it"},
    {"B16", "arch, ring, comb, chain of 100; any one removed", "islands as counted independently"},
    // Breaking in the step.
    {"B17", "100 m/s through a 2 cm pane, 64 phases", "v0 - J/M; momentum to 1e-5; energy never rises"},
    {"B18", "a block cut to 100 shards at rest", "below 1e-3 m/s after 1 s; nothing moved by the slop"},
    {"B19", "a block cut while it flies and spins", "v + w x r to 1e-5; momenta conserved to 1e-5"},
    {"B20", "made 10 % deep inside glass", "pushing out breaks nothing"},
    {"B21", "1 to 16 panes 5 cm apart at 5 to 200 m/s, 64 phases",
     "exact count; exit speed within 2 % in the worst phase"},
    {"B22", "joints on a shape that is split", "follow their piece or are gone; no jump; nothing dangles"},
    {"B23", "a loaded chain whose middle link breaks", "finite; anchor errors below twice the earlier; energy not up"},
    {"B24", "a ball rests on glass, then the strength drops", "10 s within 1 mm; one break; v = g t within 2 %"},
    {"B25", "2, 8, 64 balls on one pane in one tick", "order does not matter; each pays once; exit within 2 %"},
    {"B26", "a pile of 1000 boxes that all break", "ends in the allowed rounds; nothing dangles; none lost"},
    {"B27", "a cascade A, B, C, D in one tick", "3 rounds: D held, then broken; unbounded: all; same momentum"},
    {"B28", "J (1 - 1e-6) and J (1 + 1e-6)", "rebound and break; one crossing over 1000 speeds"},
    {"B29", "1 kg under 10 t; a stack of ten that alternates", "10 s within 5 %; impulses add up to the weight"},
    {"B30", "glancing and spinning hits", "friction at most mu times the capped impulse; no energy gained"},
    {"B31", "one carve of 30 shards", "work linear in shards; no allocation when warm"},
    {"B32", "10,000 breaks under a cap of 500", "live bodies and memory bounded; the tree stays flat"},
    {"B33", "the same scene twice, and on other builds", "the same hash every tick"},
    {"B34", "sleeping shards hit, undermined, cut off", "what is touched wakes in one step; nothing floats"},
    {"B35", "grazes within the speculative margin", "no break without a touch in 1e4"},
    {"B36", "distance of slivers, neighbours, deep overlaps",
     "within 1e-5 of the exact answer; unit normals; ends in time"},
    {"B37", "what glass looks like", "cracks grow with the square root of speed; tempered: 40 dice per 50 x 50 mm"},
    {"B38", "the origin shifts in the tick of a break", "the same bits relative to it; no contact lost or found"},
    {"B39", "one number of a pile becomes NaN", "caught in the step, named, one body gone, no other touched"},
    {"B40", "400 shards sprayed onto plates", "none through; at most 1.5 times the work of no plate"},
    {"B41", "1,000 to 32,000 bodies made and removed", "work per body flat within 1.5; memory returns"},
    {"B42", "packed shards of 1 mm to 1 m, piled prisms down to 0.1 mm thin",
     "overlap at rest below 2 % of a shard's size, of a prism's thickness; masses exact; no shard changes shape"},
    {"B43", "a wall of 40 x 25 bricks, 60 s awake", "stands: top sinks below 20 mm; energy never rises by 1e-6"},
    {"B44", "resting and hanging loads at 0.1 to 3 times the limit",
     "breaks exactly above it at any dt; joints never break"},
    {"B45", "thirty identical rooms on end, and one far out", "every room the same hashes, tick by tick"},
    {"B46", "snapshots at 100 ticks of each replay", "the rest of the hashes, with memory poisoned"},
    {"B50", "an hour of throwing at everything",
     "finite; nothing floats; memory flat; the same hashes in a second run"},
};

}  // namespace

std::span<const Case> allCases() {
  return kCases;
}

}  // namespace brittle::hard
