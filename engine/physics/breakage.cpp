#include "engine/physics/breakage.h"

#include <algorithm>
#include <iterator>

#include "engine/core/profile.h"
#include "engine/effects/has/joints.h"
#include "engine/physics/collide.h"
#include "engine/physics/contact_graph.h"
#include "engine/physics/deactivation.h"
#include "engine/physics/debris_step.h"
#include "engine/physics/edit.h"
#include "engine/physics/joint.h"

namespace brittle::physics {
namespace {

constexpr float kCrackSlop = 1e-4f;  // facing faces closer than this hang together [m]
constexpr float kBreakableVolumeRatio =
    30.0f;  // a piece breaks again from this many times the smallest piece's volume [-]

// Glass opens where it was pressed: a strike that paid less than this share of the hardest one merely touches what
// breaks. Shards that a ball drives before it would each open a hole else, and grind to dust what it breaks. [-]
constexpr float kPressed = 0.25f;

using fracture::Fracture;
using fracture::Piece;

/// Scratch of one breaking: which shape each piece became, and which body each group.
struct Swap {
  std::vector<ShapeHandle> shapes;  // of the old body, in the order they were given as parts
  std::vector<fracture::Part> parts;
  std::vector<BodyHandle> bodyOfGroup;
  std::vector<ShapeHandle> shapeOfPiece;
  std::vector<ShapeHandle> piecesOfShape;  // that joints may go with
  std::vector<bool> isCarvedOut;           // per group: fragments only, and not what stays
};

Swap& scratch() {
  thread_local Swap swap;
  return swap;
}

void gatherParts(const State& state, BodyHandle handle, Swap& swap) {
  swap.shapes.clear();
  swap.parts.clear();
  forEachShape(state, state.bodies[handle], [&](ShapeHandle shapeHandle, const Shape& shape) {
    if (shape.isSphere()) return;
    fracture::Part part;
    part.convex = state.meshes.view(shape.mesh);
    part.anchored = shape.anchored;
    part.id = static_cast<std::uint32_t>(swap.shapes.size());
    part.anchors = {shape.anchors, shape.anchorCount};
    swap.shapes.push_back(shapeHandle);
    swap.parts.push_back(part);
  });
}

fracture::FractureMaterial tuned(const State& state, const Body& body) {
  fracture::FractureMaterial material = body.breaking.material;
  material.density *= state.accuracy.patternDensity;
  material.minVolume *= state.accuracy.minVolumeScale;
  return material;
}

/// A group that stays keeps the old body; every other one becomes a dynamic body with the motion it had as part of it.
void makeBodies(State& state, BodyHandle old, BodyHandle striker, const Fracture& result, Swap& swap) {
  swap.bodyOfGroup.clear();
  std::vector<bool>& hasFragments = state.groupFlags;
  hasFragments.assign(result.groups.size(), false);
  for (const Piece& piece : result.pieces) hasFragments[piece.group] = hasFragments[piece.group] || piece.isFragment;
  swap.isCarvedOut.assign(result.groups.size(), true);
  for (const Piece& piece : result.pieces)
    swap.isCarvedOut[piece.group] = swap.isCarvedOut[piece.group] && piece.isFragment;
  for (std::uint32_t g = 0; g < result.groups.size(); ++g) {
    const fracture::Group& group = result.groups[g];
    if (group.keepsBody) {
      swap.isCarvedOut[g] = false;
      swap.bodyOfGroup.push_back(old);
      continue;
    }
    Body body = state.bodies[old];
    body.type = BodyType::Dynamic;
    body.wake();
    body.isPiece = true;
    body.firstShape = {};
    body.shapeCount = 0;
    body.hasTarget = false;
    body.target = {};
    body.breakable = body.breakable && !hasFragments[g] &&
                     group.mass.volume > kBreakableVolumeRatio * body.breaking.material.minVolume;
    body.bornTick = state.tick;
    body.striker = striker;
    body.seed = mixSeed(body.seed, g + 1);
    swap.bodyOfGroup.push_back(makeBody(state, body));
  }
}

/// The piece that goes on as the shape it was cut from: the largest, one that stays before a fragment.
std::size_t heirOf(const Fracture& result, std::size_t first, std::size_t end) {
  std::size_t heir = first;
  for (std::size_t i = first + 1; i < end; ++i) {
    const Piece& a = result.pieces[heir];
    const Piece& b = result.pieces[i];
    if (a.isFragment != b.isFragment ? a.isFragment : a.mass.volume < b.mass.volume) heir = i;
  }
  return heir;
}

void placePieces(State& state, const Fracture& result, std::size_t first, std::size_t end, Swap& swap) {
  const ShapeHandle source = swap.shapes[result.pieces[first].source];
  const std::size_t heir = heirOf(result, first, end);
  swap.piecesOfShape.clear();
  if (!result.pieces[heir].isWhole) {
    const Piece& piece = result.pieces[heir];
    replaceConvex(state, source, result.convexes[piece.convex], piece.mass);
    state.shapes[source].isPiece = true;
  }
  for (std::size_t i = first; i < end; ++i) {
    const Piece& piece = result.pieces[i];
    const BodyHandle body = swap.bodyOfGroup[piece.group];
    ShapeHandle shape = source;
    if (i != heir) {
      shape = makeConvex(state, body, state.shapes[source], result.convexes[piece.convex], piece.mass);
    } else if (!(state.shapes[source].body == body)) {
      moveShape(state, source, body);
    }
    state.shapes[shape].anchored = piece.anchored;
    swap.shapeOfPiece[i] = shape;
    if (!swap.isCarvedOut[piece.group]) swap.piecesOfShape.push_back(shape);
  }
  if constexpr (effects::kHasJoints)
    if (!result.pieces[heir].isWhole)
      moveJoints(state, source, swap.piecesOfShape.data(), static_cast<std::uint32_t>(swap.piecesOfShape.size()),
                 kCrackSlop);
}

void placeAllPieces(State& state, const Fracture& result, Swap& swap) {
  swap.shapeOfPiece.assign(result.pieces.size(), ShapeHandle{});
  for (std::size_t first = 0, end = 0; first < result.pieces.size(); first = end) {
    while (end < result.pieces.size() && result.pieces[end].source == result.pieces[first].source) ++end;
    placePieces(state, result, first, end, swap);
  }
}

/// Parts whose every piece was too small leave no shape.
void dropLostShapes(State& state, const Fracture& result, const Swap& swap) {
  std::vector<bool>& kept = state.groupFlags;
  kept.assign(swap.shapes.size(), false);
  for (const Piece& piece : result.pieces) kept[piece.source] = true;
  for (std::size_t i = 0; i < swap.shapes.size(); ++i) {
    if (kept[i]) continue;
    if constexpr (effects::kHasJoints) moveJoints(state, swap.shapes[i], nullptr, 0, kCrackSlop);
    dropShape(state, swap.shapes[i]);
  }
}

/// Masses of the bodies that came off, which are collided again. Returns how many.
std::uint32_t settleNewBodies(State& state, const Fracture& result, const Swap& swap) {
  std::uint32_t made = 0;
  for (std::size_t g = 0; g < result.groups.size(); ++g) {
    if (result.groups[g].keepsBody) continue;
    updateMass(state, swap.bodyOfGroup[g]);
    state.touchedBodies.push_back(swap.bodyOfGroup[g]);
    ++made;
  }
  return made;
}

/// What is left of the body that was hit: it falls unless something of it is still anchored, and may be nothing.
void settleOldBody(State& state, BodyHandle handle, const Fracture& result) {
  bool isLeft = false;
  bool isAnchored = false;
  for (const fracture::Group& group : result.groups) {
    isLeft = isLeft || group.keepsBody;
    isAnchored = isAnchored || (group.keepsBody && group.anchored);
  }
  Body& body = state.bodies[handle];
  body.brokenTick = state.tick;
  body.seed = mixSeed(body.seed, 0);
  if (!isLeft) {
    dropBody(state, handle);
    return;
  }
  if (body.type == BodyType::Static && !isAnchored) body.type = BodyType::Dynamic;
  body.awake = body.type != BodyType::Static;
  updateMass(state, handle);
  state.touchedBodies.push_back(handle);
}

/// The cut knows its neighbours: their first contact needs no search.
void seedContacts(State& state, const Fracture& result, const Swap& swap) {
  for (const fracture::Neighbours& pair : result.neighbours) {
    const ShapeHandle a = swap.shapeOfPiece[pair.pieceA];
    const ShapeHandle b = swap.shapeOfPiece[pair.pieceB];
    const Shape& shapeA = state.shapes[a];
    const Shape& shapeB = state.shapes[b];
    const Body& bodyA = state.bodyOf(shapeA);
    if (shapeA.body == shapeB.body || !mayCollide(shapeA.surface, shapeB.surface)) continue;
    if (!bodyA.isDynamic() && !state.bodyOf(shapeB).isDynamic()) continue;
    if (findContact(state, a, b)) continue;
    const ContactHandle handle = addContact(state, a, b);
    if (!handle) return;
    Contact& contact = state.contacts[handle];
    contact.fromCut = true;
    Manifold& manifold = contact.manifold;
    manifold.normal = bodyA.pose.rotate(contact.a == a ? pair.normal : Vec3(-pair.normal));
    manifold.count = static_cast<std::int32_t>(pair.pointCount);
    manifold.seeded = true;
    for (std::uint32_t i = 0; i < pair.pointCount; ++i) {
      manifold.points[i] = {};
      manifold.points[i].localA = manifold.points[i].localB = pair.points[i];  // pieces share their parent's frame
    }
  }
}

/// Impacts on one body are taken by place, whoever was made first.
bool isBefore(const fracture::Impact& a, const fracture::Impact& b) {
  const float keyA[] = {a.point.x(),     a.point.y(),     a.point.z(), a.direction.x(),
                        a.direction.y(), a.direction.z(), a.speed};
  const float keyB[] = {b.point.x(),     b.point.y(),     b.point.z(), b.direction.x(),
                        b.direction.y(), b.direction.z(), b.speed};
  return std::lexicographical_compare(std::begin(keyA), std::end(keyA), std::begin(keyB), std::end(keyB));
}

void scatterCrumbs(State& state, const Body& old, std::uint32_t color, const Fracture& result) {
  for (const fracture::Crumb& crumb : result.crumbs) {
    const Vec3 position = old.pose.toWorld(crumb.center);
    shed(state, position, old.velocityAt(position), crumb.volume, color);
  }
}

/// Those from `first` on; equal ones as they stand. (std::stable_sort asks for memory, and there are few.)
void sortByPlace(std::vector<fracture::Impact>& impacts, std::uint32_t first) {
  for (auto next = impacts.begin() + first; next != impacts.end(); ++next)
    std::rotate(std::upper_bound(impacts.begin() + first, next, *next, isBefore), next, next + 1);
}

/// One breaking per body with saturated strikes, in the order of the bodies.
void gatherBreakings(State& state) {
  state.breakings.clear();
  std::vector<fracture::Impact>& impacts = state.impacts;
  impacts.clear();
  const std::vector<Strike>& list = state.strikes.list;
  for (std::size_t first = 0, end = 0; first < list.size(); first = end) {
    const auto firstImpact = static_cast<std::uint32_t>(impacts.size());
    const Strike* hardest = nullptr;
    for (end = first; end < list.size() && list[end].struck == list[first].struck; ++end)
      if (list[end].saturated && list[end].mayBreak && (hardest == nullptr || list[end].impulse > hardest->impulse))
        hardest = &list[end];
    if (hardest == nullptr) continue;
    for (std::size_t i = first; i < end; ++i)
      if (list[i].saturated && list[i].mayBreak && list[i].impulse >= kPressed * hardest->impulse)
        impacts.push_back(impactOf(state, list[i]));
    sortByPlace(impacts, firstImpact);
    const Body& struck = state.bodies[hardest->struck];
    const BreakEvent event{
        hardest->struck,        hardest->striker,  struck.assembly,
        struck.userData,        hardest->point,    normalizedOr(hardest->relativeVelocity, Vec3::UnitY()),
        hardest->approachSpeed, hardest->capacity, 0};
    state.breakings.push_back({event, firstImpact, static_cast<std::uint32_t>(impacts.size()) - firstImpact});
  }
}

void carryOut(State& state, const Breaking& breaking) {
  BreakEvent event = breaking.event;
  event.pieces =
      breakBody(state, event.body, &state.impacts[breaking.firstImpact], breaking.impactCount, event.striker);
  state.events.breaks.push_back(event);
  ++state.counters.breaks;
  ++state.counters.totalBreaks;
}

}  // namespace

std::uint32_t breakBody(State& state, BodyHandle handle, const fracture::Impact* impacts, std::uint32_t count,
                        BodyHandle striker) {
  BR_ZONE("break");
  Swap& swap = scratch();
  gatherParts(state, handle, swap);
  if (swap.parts.empty()) return 0;
  const Body old = state.bodies[handle];
  const std::uint32_t color = swap.parts[0].convex.vertices[0].color;
  if (!state.fracturer) state.fracturer = std::make_shared<fracture::Fracturer>();
  const Fracture& result =
      state.fracturer->fracture(swap.parts, {impacts, count}, tuned(state, old), kCrackSlop, old.seed);
  state.counters.omissions.add(Omission::RefusedCut, result.refusedCuts);
  state.counters.crumbs += static_cast<std::uint32_t>(result.crumbs.size());

  makeBodies(state, handle, striker, result, swap);
  placeAllPieces(state, result, swap);
  dropLostShapes(state, result, swap);
  scatterCrumbs(state, old, color, result);
  const std::uint32_t made = settleNewBodies(state, result, swap);
  settleOldBody(state, handle, result);
  seedContacts(state, result, swap);
  state.counters.pieces += made;
  return made;
}

void fractureSaturated(State& state) {
  BR_ZONE("fracture");
  state.touchedBodies.clear();
  // Charge and read everything first: breaking removes the contacts that carry what was paid, also those of a body that
  // was struck here and strikes there.
  for (const Strike& strike : state.strikes.list)
    if (strike.saturated && strike.mayBreak) charge(state, strike.striker, strike.struck, strike.capacity);
  gatherBreakings(state);
  for (const Breaking& breaking : state.breakings) carryOut(state, breaking);
}

void fractureAfterStep(State& state) {
  if (state.accuracy.fractureMode == FractureMode::InStep) return;
  if (state.accuracy.fractureMode == FractureMode::AfterStepBlended) {
    const float t = state.accuracy.blend;
    for (const Strike& strike : state.strikes.list) {
      Body& body = state.bodies[strike.body];
      if (strike.saturated && body.isDynamic()) body.velocity = strike.velocityBefore * t + body.velocity * (1.0f - t);
    }
  }
  fractureSaturated(state);
}

void breakHeld(State& state) {
  state.touchedBodies.clear();
  std::vector<Held>& held = state.breakingNow;
  held.swap(state.held);
  state.held.clear();
  for (std::size_t i = 0; i < held.size(); ++i) {
    const Held& first = held[i];
    if (!state.bodies.contains(first.struck) || state.bodies[first.struck].brokenTick == state.tick) continue;
    std::vector<fracture::Impact>& impacts = state.impacts;
    impacts.clear();
    float most = 0.0f;
    for (const Held& other : held)
      if (other.struck == first.struck) most = maxOf(most, other.impulse);
    for (const Held& other : held) {
      if (!(other.struck == first.struck)) continue;
      if (other.impulse >= kPressed * most) impacts.push_back(other.impact);
      if (state.bodies.contains(other.striker))
        charge(state, other.striker, other.struck, state.bodies[first.struck].breaking.strength);
    }
    sortByPlace(impacts, 0);
    const Body& struck = state.bodies[first.struck];
    const BreakEvent event{first.struck,
                           first.striker,
                           struck.assembly,
                           struck.userData,
                           struck.pose.toWorld(first.impact.point),
                           struck.pose.rotate(first.impact.direction),
                           first.impact.speed,
                           first.impulse,
                           0};
    carryOut(state, {event, 0, static_cast<std::uint32_t>(impacts.size())});
  }
}

}  // namespace brittle::physics
