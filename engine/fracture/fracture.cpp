#include "engine/fracture/fracture.h"

#include <algorithm>
#include <cmath>

#include "engine/core/assert.h"
#include "engine/core/profile.h"
#include "engine/fracture/carve.h"
#include "engine/fracture/neighbours.h"
#include "engine/fracture/shatter.h"
#include "engine/math/trig.h"

namespace brittle::fracture {

namespace {

// So many of the fragments out of the striker's way stay in the rim: holes in glass are jagged. [-] By eye.
constexpr float kRimStays = 0.35f;
// A block breaks into so many pieces at 10 m/s, growing with the square root of the speed, within limits. [-] By eye.
constexpr float kBlockPieces = 14.0f, kLeastBlockPieces = 4.0f, kMostBlockPieces = 80.0f;
// Tempered glass breaks into no more dice than that; they grow larger instead. [-]
constexpr float kMostDice = 400.0f;
// Pieces are neighbours if they share more than this share of the area that connects them. [-]
constexpr float kContactShare = 1.0f / 400.0f;

/// One random stream per purpose.
enum class Stream : std::uint64_t { Hole, Cracks, Dice, Rim };

Random streamOf(std::uint64_t seed, std::size_t impact, Stream stream) {
  return Random(mixSeed(seed, impact), static_cast<std::uint64_t>(stream));
}

}  // namespace

struct Fracturer::Scratch {
  Fracture result;
  ChunkStore store;
  CarveLists carving;
  std::vector<Chunk> shattered;  // fragments after their last cut
  CrackTree tree;
  ShatterScratch shatter;
  std::vector<Chunk> chunks;  // one per piece
  std::vector<Node> nodes;    // one per piece
  ConnectScratch connecting;
  DisjointSets sets;
  SharedFaceFinder finder;
  std::vector<SharedFace> shared;
  std::vector<std::uint32_t> groupOfSet, placeOfPart;

  void begin(std::span<const Part> parts);
  void breakAt(const Impact& impact, const FractureMaterial& material, std::uint64_t seed, std::size_t index);
  void shatterSheet(const Strike& strike, const Impact& impact, const FractureMaterial& material, Random random);
  void shatterBlock(const Strike& strike, const Impact& impact, const FractureMaterial& material, Random random);
  void leaveSomeInTheRim(const Strike& strike, std::size_t first, Random random);
  void shatterEvenly(const DiceShape& shape, std::uint32_t count, Random& random);
  void diceAll(const Impact& impact, const FractureMaterial& material, std::uint64_t seed);
  void openAWay(const Impact& impact, const FractureMaterial& material, std::uint64_t seed);
  void sortByPart();
  void makePieces(const FractureMaterial& material, float slop);
  bool isAnchored(const Chunk& chunk, float slop);
  void makeGroups(float slop);
  bool hangTogether(std::uint32_t a, std::uint32_t b);
  void numberGroups();
  void chooseKept();
  void makeNeighbours();
};

void Fracturer::Scratch::begin(std::span<const Part> parts) {
  result.pieces.clear();
  result.groups.clear();
  result.neighbours.clear();
  result.crumbs.clear();
  store.begin(parts, result.convexes);
  carving.remains.clear();
  carving.fragments.clear();
  shattered.clear();
  for (std::uint32_t i = 0; i < parts.size(); ++i) carving.remains.push_back({i, kWholePart, false, false});
}

void Fracturer::Scratch::breakAt(const Impact& impact, const FractureMaterial& material, std::uint64_t seed,
                                 std::size_t index) {
  const Strike strike = strikeOf(store.parts(), impact, material);
  Random holeRandom = streamOf(seed, index, Stream::Hole);
  carving.fragments.clear();
  if (material.pattern == Pattern::Block) {
    carve(store, blockCell(strike, holeRandom), false, carving);
    shatterBlock(strike, impact, material, streamOf(seed, index, Stream::Dice));
    return;
  }
  const bool isLaminated = material.pattern == Pattern::Laminated;
  carve(store, sheetCell(strike, holeRandom), isLaminated, carving);
  const std::size_t first = shattered.size();
  shatterSheet(strike, impact, material, streamOf(seed, index, Stream::Cracks));
  if (!isLaminated) leaveSomeInTheRim(strike, first, streamOf(seed, index, Stream::Rim));
}

void Fracturer::Scratch::leaveSomeInTheRim(const Strike& strike, std::size_t first, Random random) {
  for (std::size_t i = first; i < shattered.size(); ++i) {
    const bool isChosen = random.nextFloat() < kRimStays;
    shattered[i].isRim =
        isChosen && isAtRim(strike, store.view(shattered[i]), boxOf(store.view(shattered[i])).center());
  }
}

void Fracturer::Scratch::shatterSheet(const Strike& strike, const Impact& impact, const FractureMaterial& material,
                                      Random random) {
  growSheetCracks(strike, material, impact.speed, random, tree);
  for (const Chunk& chunk : carving.fragments) shatterAlong(store, tree, chunk, shatter, shattered);
}

void Fracturer::Scratch::shatterBlock(const Strike& strike, const Impact& impact, const FractureMaterial& material,
                                      Random random) {
  const float wanted = kBlockPieces * material.density * std::sqrt(maxOf(impact.speed, 0.0f) / 10.0f);
  DiceShape shape;
  shape.axes[0] = strike.right;
  shape.axes[1] = strike.up;
  shape.axes[2] = strike.normal;
  shape.tilt = 0.7f;
  shatterEvenly(shape, static_cast<std::uint32_t>(clampTo(wanted, kLeastBlockPieces, kMostBlockPieces) + 0.5f), random);
}

/// Shares `count` pieces among the fragments by volume.
void Fracturer::Scratch::shatterEvenly(const DiceShape& shape, std::uint32_t count, Random& random) {
  float total = 0.0f;
  for (const Chunk& chunk : carving.fragments) total += geometry::massOf<float>(store.view(chunk)).volume;
  for (const Chunk& chunk : carving.fragments) {
    const float volume = geometry::massOf<float>(store.view(chunk)).volume;
    const float wanted = total > 0.0f ? static_cast<float>(count) * (volume / total) : 1.0f;
    shatterInto(store, shape, chunk, static_cast<std::uint32_t>(maxOf(wanted, 1.0f) + 0.5f), random, shatter,
                shattered);
  }
}

/// Tempered glass: its inner stress runs through the whole body.
void Fracturer::Scratch::diceAll(const Impact& impact, const FractureMaterial& material, std::uint64_t seed) {
  const Strike strike = strikeOf(store.parts(), impact, material);
  Random random = streamOf(seed, 0, Stream::Dice);
  float volume = 0.0f;
  for (Chunk& chunk : carving.remains) {
    volume += geometry::massOf<float>(store.view(chunk)).volume;
    chunk.isFragment = true;
  }
  carving.fragments.swap(carving.remains);
  carving.remains.clear();
  DiceShape shape;
  const float roll = random.nextFloat(0.0f, kPi);
  shape.axes[0] = strike.right * cosine(roll) + strike.up * sine(roll);
  shape.axes[1] = strike.normal.cross(shape.axes[0]);
  shape.axes[2] = strike.normal;
  shape.tilt = 0.3f;
  shape.keepsLastAxis = true;
  const float die = maxOf(material.dieSize, 1e-6f);
  const float layer = strike.thickness < 1.5f * die ? maxOf(strike.thickness, 1e-6f) : die;
  const float wanted = material.density * volume / (die * die * layer);
  shatterEvenly(shape, static_cast<std::uint32_t>(clampTo(wanted, 2.0f, kMostDice) + 0.5f), random);
}

/// The degenerate last resort: nothing could be carved, so what is nearest to the impact breaks as it is.
void Fracturer::Scratch::openAWay(const Impact& impact, const FractureMaterial& material, std::uint64_t seed) {
  const Strike strike = strikeOf(store.parts(), impact, material);
  std::size_t nearest = 0;
  float bestSquared = 3.0e38f;
  for (std::size_t i = 0; i < carving.remains.size(); ++i) {
    const Vec3 point = closestPoint(store.view(carving.remains[i]), strike.center);
    const float squared = (point - strike.center).squaredNorm();
    if (squared < bestSquared) {
      bestSquared = squared;
      nearest = i;
    }
  }
  carving.fragments.clear();
  carving.fragments.push_back(carving.remains[nearest]);
  carving.fragments[0].isFragment = true;
  carving.remains.erase(carving.remains.begin() + static_cast<std::ptrdiff_t>(nearest));
  if (material.pattern == Pattern::Block) {
    shatterBlock(strike, impact, material, streamOf(seed, 0, Stream::Dice));
  } else {
    shatterSheet(strike, impact, material, streamOf(seed, 0, Stream::Cracks));
  }
}

/// Fills `chunks`: by part, what remains first, both in cutting order.
void Fracturer::Scratch::sortByPart() {
  placeOfPart.assign(store.parts().size() + 1, 0);
  for (const Chunk& chunk : carving.remains) ++placeOfPart[chunk.part + 1];
  for (const Chunk& chunk : shattered) ++placeOfPart[chunk.part + 1];
  for (std::size_t i = 1; i < placeOfPart.size(); ++i) placeOfPart[i] += placeOfPart[i - 1];
  chunks.resize(carving.remains.size() + shattered.size());
  for (const Chunk& chunk : carving.remains) chunks[placeOfPart[chunk.part]++] = chunk;
  for (const Chunk& chunk : shattered) chunks[placeOfPart[chunk.part]++] = chunk;
}

/// Chunks become pieces or crumbs.
void Fracturer::Scratch::makePieces(const FractureMaterial& material, float slop) {
  sortByPart();
  std::size_t kept = 0;
  for (const Chunk& chunk : chunks) {
    const geometry::MassProperties mass = geometry::massOf<float>(store.view(chunk));
    const bool isUntouched = chunk.slot == kWholePart && !chunk.isFragment;
    if (mass.volume < material.minVolume && !isUntouched) {
      result.crumbs.push_back({mass.center, mass.volume});
      continue;
    }
    Piece& piece = result.pieces.emplace_back();
    piece.source = store.parts()[chunk.part].id;
    piece.isWhole = chunk.slot == kWholePart;
    piece.isFragment = chunk.isFragment;
    piece.anchored = isAnchored(chunk, slop);
    piece.mass = mass;
    chunks[kept++] = chunk;
  }
  chunks.resize(kept);
  result.convexCount = store.compact(chunks);
  result.refusedCuts = store.refusedCuts();
  nodes.clear();
  for (std::size_t i = 0; i < kept; ++i) {
    result.pieces[i].convex = chunks[i].slot == kWholePart ? 0 : chunks[i].slot;
    const geometry::ConvexView view = store.view(chunks[i]);
    nodes.push_back({view, boxOf(view), chunks[i].part, true});
  }
}

bool Fracturer::Scratch::isAnchored(const Chunk& chunk, float slop) {
  const Part& part = store.parts()[chunk.part];
  if (!part.anchored || (chunk.isFragment && !chunk.isBonded)) return false;
  if (part.anchors.empty()) return true;
  for (const Anchor& anchor : part.anchors) {
    if (touchesAnchor(store.view(chunk), anchor, slop, connecting)) return true;
  }
  return false;
}

void Fracturer::Scratch::makeGroups(float slop) {
  const float connectingArea = 4.0f * slop * slop;
  for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i].isUsed = chunks[i].slot != kWholePart;
  finder.find(nodes, kContactShare * connectingArea, shared);
  sets.reset(nodes.size());
  for (const SharedFace& face : shared) {
    if (face.area > connectingArea && hangTogether(face.seed.pieceA, face.seed.pieceB)) {
      sets.unite(face.seed.pieceA, face.seed.pieceB);
    }
  }
  for (std::uint32_t i = 0; i < nodes.size(); ++i) nodes[i].isUsed = !chunks[i].isFragment || chunks[i].isBonded;
  connectNodes(nodes, slop, connecting, sets);
  numberGroups();
  chooseKept();
}

/// Whether sharing a face joins the two: what remains and what is bonded, and a fragment of the rim with what remains
/// (but not with the next one of the rim: two that hold only each other fall apart). A fragment that stays is none any
/// more.
bool Fracturer::Scratch::hangTogether(std::uint32_t a, std::uint32_t b) {
  const auto stays = [&](std::uint32_t i) { return !chunks[i].isFragment || chunks[i].isBonded; };
  if (stays(a) && stays(b)) return true;
  if (!(stays(a) && chunks[b].isRim) && !(stays(b) && chunks[a].isRim)) return false;
  result.pieces[stays(a) ? b : a].isFragment = false;
  return true;
}

/// All anchored sets are one group, the first: they stay in the body they are in. The others follow in the order of
/// their pieces.
void Fracturer::Scratch::numberGroups() {
  constexpr std::uint32_t kNone = 0xffffffff, kAnchored = 0;
  groupOfSet.assign(nodes.size(), kNone);
  bool anyAnchored = false;
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    if (!result.pieces[i].anchored) continue;
    groupOfSet[sets.find(i)] = kAnchored;
    anyAnchored = true;
  }
  if (anyAnchored) result.groups.emplace_back().anchored = true;
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    std::uint32_t& group = groupOfSet[sets.find(i)];
    if (group == kNone) {
      group = static_cast<std::uint32_t>(result.groups.size());
      result.groups.emplace_back();
    }
    result.pieces[i].group = group;
    geometry::MassProperties& sum = result.groups[group].mass;
    const geometry::MassProperties& mass = result.pieces[i].mass;
    sum = sum.volume > 0.0f ? geometry::combined<float>(sum, mass) : mass;
  }
}

void Fracturer::Scratch::chooseKept() {
  if (!result.groups.empty() && result.groups[0].anchored) {
    result.groups[0].keepsBody = true;
    return;
  }
  Group* largest = nullptr;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes[i].isUsed) continue;
    Group& group = result.groups[result.pieces[i].group];
    if (largest == nullptr || group.mass.volume > largest->mass.volume) largest = &group;
  }
  if (largest != nullptr) largest->keepsBody = true;
}

void Fracturer::Scratch::makeNeighbours() {
  for (const SharedFace& face : shared) {
    if (result.pieces[face.seed.pieceA].group != result.pieces[face.seed.pieceB].group)
      result.neighbours.push_back(face.seed);
  }
}

Fracturer::Fracturer() : scratch_(std::make_unique<Scratch>()) {}
Fracturer::~Fracturer() = default;
Fracturer::Fracturer(Fracturer&& other) noexcept = default;
Fracturer& Fracturer::operator=(Fracturer&& other) noexcept = default;

const Fracture& Fracturer::fracture(std::span<const Part> parts, std::span<const Impact> impacts,
                                    const FractureMaterial& material, float crackSlop, std::uint64_t seed) {
  BR_ZONE("fracture");
  BR_ASSERT(!parts.empty() && !impacts.empty());
  Scratch& scratch = *scratch_;
  scratch.begin(parts);
  if (material.pattern == Pattern::Tempered) {
    scratch.diceAll(impacts[0], material, seed);
  } else {
    for (std::size_t i = 0; i < impacts.size(); ++i) scratch.breakAt(impacts[i], material, seed, i);
  }
  if (scratch.shattered.empty()) scratch.openAWay(impacts[0], material, seed);
  scratch.makePieces(material, crackSlop);
  scratch.makeGroups(crackSlop);
  scratch.makeNeighbours();
  return scratch.result;
}

}  // namespace brittle::fracture
