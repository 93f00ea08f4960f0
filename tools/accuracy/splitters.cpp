#include "tools/accuracy/splitters.h"

#include <cmath>

#include "tests/engine/geometry/cutting.h"
#include "tests/engine/geometry/exact.h"
#include "tools/bench/cpu_time.h"

namespace brittle::accuracy {
namespace {

using namespace geometry;

/// What a splitter without the repair does: takes every sign as it comes, or what is within `epsilon` of the plane as
/// lying on it, cuts edges where the numbers say, and fails where the cut faces are no single ring. Slivers it refuses
/// as ours does.
template <class S>
struct NaiveSplitter {
  S epsilon = S(0);

  SplitOutcome operator()(const ConvexViewT<S>& parent, const PlaneT<S>& plane, CutMark mark, SplitScratchT<S>& scratch,
                          ConvexT<S>& above, ConvexT<S>& below) {
    split_detail::Sides<S> sides(parent, scratch);
    failed = false;
    const SplitOutcome outcome = sides.classify(plane);
    if (outcome != SplitOutcome::Split) return outcome;
    if (!snap(scratch)) return SplitOutcome::AllAbove;
    failed = !sides.walkCut();
    if (failed) return SplitOutcome::TooFarOff;
    scratch.caps.resize(sides.cutCount());
    for (std::uint32_t i = 0; i < sides.cutCount(); ++i) {
      const Edge& up = parent.edges[scratch.cut[i].up];
      scratch.caps[i] = meet(sides, up.vertex, parent.edges[up.opposite].vertex);
    }
    split_detail::Writer<S>(sides).write(plane, mark, above, below);
    return SplitOutcome::Split;
  }
  bool failed = false;

 private:
  /// What is within epsilon below the plane lies on it. False: nothing is left below.
  bool snap(SplitScratchT<S>& scratch) const {
    bool isBelow = false;
    for (std::size_t i = 0; i < scratch.sides.size(); ++i) {
      if (scratch.distances[i] < S(0) && S(-epsilon) < scratch.distances[i]) {
        scratch.sides[i] = split_detail::kAbove;
        scratch.distances[i] = S(0);
      }
      isBelow = isBelow || scratch.sides[i] == split_detail::kBelow;
    }
    return isBelow;
  }
  static VertexT<S> meet(const split_detail::Sides<S>& sides, std::uint32_t low, std::uint32_t high) {
    const S& a = sides.scratch.distances[low];
    const S& b = sides.scratch.distances[high];
    const S fraction = a / (a - b);
    VertexT<S> vertex = sides.parent.vertices[low];
    for (int i = 0; i < 3; ++i) vertex.point[i] += fraction * (sides.parent.vertices[high].point[i] - vertex.point[i]);
    return vertex;
  }
};

template <class S>
struct OurSplitter : EngineSplitter<S> {
  static constexpr bool failed = false;
};

/// Whether two pieces are what is left of a parent: closed, each with a volume, together as large.
template <class S>
bool isSound(const ConvexT<S>& parent, const ConvexT<S>& above, const ConvexT<S>& below, double& volumeError) {
  if (findTopologyError(above.view()) != nullptr || findTopologyError(below.view()) != nullptr) return false;
  const auto volume = [](const ConvexT<S>& convex) {
    if constexpr (std::numeric_limits<S>::is_exact)
      return static_cast<double>(volumeOf<S>(convex));
    else
      return volumeOf<double>(convex);
  };
  const double whole = volume(parent), a = volume(above), b = volume(below);
  if (!(a > 0.0) || !(b > 0.0)) return false;
  const double error = std::abs(a + b - whole);  // of the cube's 1 m3
  if (error > 1e-6) return false;
  volumeError = std::max(volumeError, error);
  return true;
}

/// Counts how a splitter fares, and hands on only what is sound: a piece that was spoilt is not cut again.
template <class S, class Splitter>
struct Watched {
  Splitter splitter;
  SplitterRow row;
  double spent = 0.0;  // [ms]

  SplitOutcome operator()(const ConvexViewT<S>& parent, const PlaneT<S>& plane, CutMark mark, SplitScratchT<S>& scratch,
                          ConvexT<S>& above, ConvexT<S>& below) {
    const double before = cpuMilliseconds();
    const SplitOutcome outcome = splitter(parent, plane, mark, scratch, above, below);
    spent += cpuMilliseconds() - before;
    row.attempts += 1.0;
    if (splitter.failed) row.failures += 1.0;
    if (outcome != SplitOutcome::Split) return outcome;
    row.splits += 1.0;
    whole.assign(parent);
    if (isSound<S>(whole, above, below, row.volumeError)) return outcome;
    row.failures += 1.0;
    return SplitOutcome::TooFarOff;
  }
  ConvexT<S> whole;
};

/// What reading the clock twice takes. [ms]
double clockCost() {
  constexpr int kReadings = 1000;
  const double before = cpuMilliseconds();
  for (int i = 0; i < kReadings; ++i) static_cast<void>(cpuMilliseconds());
  return (cpuMilliseconds() - before) / kReadings;
}

template <class S, class Splitter>
SplitterRow fare(const std::string& name, CutMode mode, int attempts, std::size_t pieces, Splitter splitter = {}) {
  CutCube<S, Watched<S, Splitter>> cube(mode, 42, pieces);
  cube.splitter.splitter = splitter;
  for (int i = 0; i < attempts; ++i) cube.step();
  SplitterRow row = cube.splitter.row;
  row.splitter = name;
  row.cuts = kCutModeNames[static_cast<int>(mode)];
  row.failuresPerMillion = 1e6 * row.failures / row.attempts;
  const double spent = std::max(cube.splitter.spent - row.attempts * clockCost(), 1e-6);
  row.splitsPerSecond = 1000.0 * row.splits / spent;
  return row;
}

}  // namespace

std::vector<SplitterRow> compareSplitters(const Effort& effort, const Advance& advance) {
  const int attempts = effort.quick ? 10'000 : 300'000;
  const int exactAttempts = effort.quick ? 50 : 2'000;
  constexpr std::size_t kPieces = 512, kExactPieces = 64;  // exact numbers grow with every cut of a piece
  std::vector<SplitterRow> rows;
  const auto add = [&](SplitterRow row) {
    rows.push_back(std::move(row));
    advance();
  };
  for (const CutMode mode : kCutModes) {
    add(fare<float, NaiveSplitter<float>>("naive float", mode, attempts, kPieces));
    add(fare<float, NaiveSplitter<float>>("float with epsilon", mode, attempts, kPieces, {.epsilon = 1e-5f}));
    add(fare<double, NaiveSplitter<double>>("naive double", mode, attempts, kPieces));
    add(fare<float, OurSplitter<float>>("ours float", mode, attempts, kPieces));
    add(fare<double, OurSplitter<double>>("ours double", mode, attempts, kPieces));
    add(fare<Exact, OurSplitter<Exact>>("exact rationals", mode, exactAttempts, kExactPieces));
  }
  return rows;
}

}  // namespace brittle::accuracy
