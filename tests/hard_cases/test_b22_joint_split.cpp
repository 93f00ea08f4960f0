// B22: hinge, ball, weld and slider on a plate that is broken, with the pivot inside one piece, on a cut between two,
// and in the volume that is carved out. The joint moves to the piece that contains its anchor (on a cut: to one of the
// two), or is gone if that was carved out; no jump: the anchor error after the tick is below the slop of 1e-4 m; no
// handle to something that is gone is left.
#include <gtest/gtest.h>

#include "engine/physics/state.h"
#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"

namespace brittle::physics {
namespace {

constexpr float kSlop = 1e-4f;  // [m]
constexpr JointType kTypes[] = {JointType::Hinge, JointType::Ball, JointType::Weld, JointType::Slider};

/// A free plate of glass struck off its middle. The pattern depends on the seed and the blow alone, so a first breaking
/// tells where the cuts of the second one will be.
struct Plate {
  World world;
  BodyHandle body, partner;
  JointHandle joint;

  Plate() {
    BodyDef def = bodyAt(Vec3(0.0f, 2.0f, 0.0f));
    def.breakable.strength = 1.0f;
    def.breakable.material.carveRadius = 0.15f;
    body = addBox(world, def, Vec3(0.5f, 0.5f, 0.02f), shapeDef(2500.0f));
    partner = addBox(world, bodyAt(Vec3(0.0f, 2.0f, -5.0f)), Vec3::Constant(0.2f));
  }
  void hold(JointType type, const Vec3& anchorLocal, bool asB) {
    JointDef def;
    def.type = type;
    def.anchorA = world.body(body).pose.toWorld(anchorLocal);
    def.a = world.body(asB ? partner : body).firstShape;
    if (asB) def.b = world.body(body).firstShape;
    joint = world.createJoint(def);
  }
  void breakIt() {
    world.breakBody(body, Vec3(0.1f, 2.1f, 0.02f), Vec3(0.0f, 0.0f, -1.0f), 10.0f, 0.05f);
    world.step(kTick);
  }
  float distanceToAnchor(const Shape& shape, const Vec3& anchorLocal) const {
    geometry::Proxy point;
    point.center = anchorLocal;
    geometry::SimplexCache cache;
    return geometry::separation(proxyOf(shape, world.meshes()), Transform{}, point, Transform{}, cache).distance;
  }
  float anchorError() const {
    const Joint& j = world.joint(joint);
    const Vec3 a = world.body(world.bodyOf(j.a)).pose.toWorld(j.localAnchorA);
    const Vec3 b = j.b ? world.body(world.bodyOf(j.b)).pose.toWorld(j.localAnchorB) : j.localAnchorB;
    const Vec3 between = a - b;
    if (j.type != JointType::Slider) return between.norm();
    const Vec3 axis = j.b ? world.body(world.bodyOf(j.b)).pose.rotate(j.localAxisB) : j.localAxisB;
    return between.cross(axis).norm();
  }
};

struct Places {
  std::vector<Vec3> inside, onCuts, carved;
};

/// Points of the pieces of a first breaking, in the plate's frame: middles of what remains, of cuts between remains, of
/// fragments.
Places findPlaces() {
  Plate plate;
  const ShapeHandle whole = plate.world.body(plate.body).firstShape;
  const Vec3 hole(0.1f, 0.1f, 0.0f);
  plate.breakIt();
  Places places;
  const State& state = plate.world.state();
  std::vector<Vec3> centers;
  state.shapes.forEach([&](ShapeHandle handle, const Shape& shape) {
    if (!(handle == whole) && !shape.isPiece) return;
    const Vec3 center = shape.massProperties.center;
    const bool isCarved = (center - hole).head<2>().norm() < 0.05f;
    const bool isFar = (center - hole).head<2>().norm() > 0.22f;
    if (isCarved) places.carved.push_back(center);
    if (isFar) places.inside.push_back(center);
    const geometry::ConvexView view = state.meshes.view(shape.mesh);
    for (const geometry::Face& face : view.faces) {
      if (face.kind != geometry::FaceKind::Cut || !isFar) continue;
      Vec3 sum = Vec3::Zero();
      float count = 0.0f;
      std::uint32_t e = face.edge;
      do {
        sum += view.startOf(e);
        count += 1.0f;
        e = view.edges[e].next;
      } while (e != face.edge);
      if ((sum / count - hole).head<2>().norm() > 0.22f) places.onCuts.push_back(sum / count);
    }
  });
  return places;
}

TEST(B22, PivotsInsideAPieceGoWithIt) {
  const Places places = findPlaces();
  ASSERT_GE(places.inside.size(), 2u);
  float worst = 0.0f;
  for (const JointType type : kTypes) {
    for (const Vec3& anchor : places.inside) {
      for (const bool asB : {false, true}) {
        Plate plate;
        plate.hold(type, anchor, asB);
        plate.breakIt();
        ASSERT_TRUE(plate.world.isAlive(plate.joint));
        const Joint& joint = plate.world.joint(plate.joint);
        const ShapeHandle owner = asB ? joint.b : joint.a;
        ASSERT_TRUE(plate.world.isAlive(owner));
        EXPECT_TRUE(
            geometry::containsPoint(proxyOf(plate.world.shape(owner), plate.world.meshes()), Transform{}, anchor));
        worst = maxOf(worst, plate.anchorError());
      }
    }
  }
  EXPECT_LT(worst, kSlop);
  hard::reportWorst("anchor error", 1000.0 * double(worst), "mm");
}

TEST(B22, PivotsOnACutGoWithOneOfItsPieces) {
  const Places places = findPlaces();
  ASSERT_GE(places.onCuts.size(), 2u);
  float worst = 0.0f, farthest = 0.0f;
  for (const JointType type : kTypes) {
    for (const Vec3& anchor : places.onCuts) {
      Plate plate, again;
      for (Plate* p : {&plate, &again}) {
        p->hold(type, anchor, false);
        p->breakIt();
        ASSERT_TRUE(p->world.isAlive(p->joint));
      }
      EXPECT_EQ(plate.world.joint(plate.joint).a, again.world.joint(again.joint).a);
      farthest = maxOf(farthest, plate.distanceToAnchor(plate.world.shape(plate.world.joint(plate.joint).a), anchor));
      worst = maxOf(worst, plate.anchorError());
    }
  }
  EXPECT_LT(farthest, kSlop);
  EXPECT_LT(worst, kSlop);
  hard::reportWorst("anchor error", 1000.0 * double(worst), "mm");
  hard::reportSum("places on cuts", double(places.onCuts.size()));
}

TEST(B22, PivotsThatAreCarvedOutAreGone) {
  const Places places = findPlaces();
  ASSERT_GE(places.carved.size(), 1u);
  for (const JointType type : kTypes) {
    for (const Vec3& anchor : places.carved) {
      Plate plate;
      plate.hold(type, anchor, false);
      plate.breakIt();
      EXPECT_FALSE(plate.world.isAlive(plate.joint));
      for (int i = 0; i < 30; ++i) plate.world.step(kTick);
    }
  }
}

}  // namespace
}  // namespace brittle::physics
