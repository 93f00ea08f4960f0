#include "gallery.h"

#include "engine/core/random.h"
#include "engine/geometry/make.h"
#include "engine/geometry/split.h"

namespace brittle::render {
namespace {

using geometry::Convex;

Vec3 randomUnit(Random& random) {
  const float x = random.nextFloat(-1.0f, 1.0f);
  const float y = random.nextFloat(-1.0f, 1.0f);
  const float z = random.nextFloat(-1.0f, 1.0f);
  return normalizedOr(Vec3(x, y, z), Vec3::UnitX());
}

/// `whole` cut `cuts` times by planes about `about`; `flat` keeps them upright to the pane.
std::vector<Convex> shatter(const Convex& whole, int cuts, bool flat, const Vec3& about, float spread, Random& random) {
  std::vector<Convex> pieces = {whole};
  geometry::SplitScratch scratch;
  for (int i = 0; i < cuts; ++i) {
    Vec3 normal = randomUnit(random);
    if (flat) normal = normalizedOr(Vec3(normal.x(), normal.y(), 0.0f), Vec3::UnitX());
    const Plane plane = planeThrough(about + spread * randomUnit(random), normal);
    std::vector<Convex> next;
    for (const Convex& piece : pieces) {
      Convex above, below;
      if (geometry::split<float>(piece, plane, {}, scratch, above, below) == geometry::SplitOutcome::Split) {
        next.push_back(above);
        next.push_back(below);
      } else {
        next.push_back(piece);
      }
    }
    pieces = std::move(next);
  }
  return pieces;
}

class Filler {
 public:
  explicit Filler(Gallery& gallery) : gallery_(gallery), group_(gallery.frame.groups[0]) {}

  std::uint32_t addBody(const Vec3& position, const Quat& rotation) {
    group_.bodies.push_back({position, rotation});
    return static_cast<std::uint32_t>(group_.bodies.size() - 1);
  }

  void addMesh(const Convex& convex, std::uint32_t body, std::uint16_t material, const Rgb& color) {
    Convex colored = convex;
    for (geometry::Vertex& vertex : colored.vertices) vertex.color = packRgba(color);
    group_.meshes.push_back({gallery_.pool.add(colored, body, material), body, material, kWhite});
  }

  void addThing(const Convex& convex, const Vec3& position, const Quat& rotation, std::uint16_t material,
                const Rgb& color) {
    addMesh(convex, addBody(position, rotation), material, color);
  }

  Gallery& gallery_;
  MeshGroup& group_;
};

/// Pieces near the hit fly; the rest stay in place.
void addBrokenPane(Filler& filler, const Vec3& at, const Vec3& half, int cuts, const Rgb& color, std::uint64_t seed) {
  Random random(seed);
  const Vec3 hit(0.2f, 0.1f, 0.0f);
  const std::uint32_t rest = filler.addBody(at, Quat::Identity());
  for (const Convex& piece : shatter(geometry::makeBox<float>(half), cuts, true, hit, 0.35f, random)) {
    Vec3 center = Vec3::Zero();
    for (const geometry::Vertex& vertex : piece.vertices) center += vertex.point;
    center /= static_cast<float>(piece.vertices.size());
    const Vec3 away = center - hit;
    const float turn = random.nextFloat(0.3f, 1.8f);
    const Vec3 axis = randomUnit(random);
    const Vec3 drift = randomUnit(random);
    if (away.norm() > 0.55f) {
      filler.addMesh(piece, rest, kGlass, color);
      continue;
    }
    const Quat rotation = rotationAbout(axis, turn);
    const Vec3 moved = at + center + 0.6f * away + 0.15f * drift + Vec3(0.0f, -0.25f, -0.5f * turn);
    filler.addThing(piece, moved - rotation * center, rotation, kGlass, color);
    filler.gallery_.frame.shadows.push_back({moved, Vec2(0.14f, 0.06f), turn, 0.22f});
  }
}

void addBlock(Filler& filler, const Vec3& at, const Quat& turned, const Rgb& color, int cuts, float apart,
              std::uint64_t seed) {
  Random random(seed);
  for (const Convex& piece :
       shatter(geometry::makeBox<float>(Vec3(0.35f, 0.35f, 0.35f)), cuts, false, Vec3::Zero(), 0.15f, random)) {
    Vec3 center = Vec3::Zero();
    for (const geometry::Vertex& vertex : piece.vertices) center += vertex.point;
    center /= static_cast<float>(piece.vertices.size());
    const Vec3 axis = randomUnit(random);
    const Quat rotation = rotationAbout(axis, apart * 1.5f) * turned;
    filler.addThing(piece, at + turned * (apart * center) - rotation * center + turned * center, rotation, kCrystal,
                    color);
  }
  filler.gallery_.frame.shadows.push_back({at - Vec3(0.0f, 0.35f, 0.0f), Vec2(0.35f, 0.35f), 0.6f, 0.45f});
}

void addFrame(Filler& filler, const Vec3& at, float width, float height) {
  const Rgb grey(0.9f, 0.9f, 0.95f);
  const std::uint32_t body = filler.addBody(at, Quat::Identity());
  for (const float side : {-1.0f, 1.0f}) {
    filler.addMesh(geometry::makeBox<float>(Vec3(0.06f, height, 0.06f), Vec3(side * width, 0.0f, 0.0f)), body, kMetal,
                   grey);
    filler.addMesh(
        geometry::makeBox<float>(Vec3(width - 0.06f, 0.06f, 0.06f), Vec3(0.0f, side * (height - 0.06f), 0.0f)), body,
        kMetal, grey);
  }
}

std::vector<BakeBox> roomBoxes() {
  const Rgb floor(0.50f, 0.56f, 0.66f), wall(0.42f, 0.50f, 0.62f), beam(0.62f, 0.66f, 0.74f);
  std::vector<BakeBox> boxes;
  const auto add = [&boxes](const Vec3& center, const Vec3& half, const Rgb& color, int tile) {
    BakeBox box;
    box.center = center;
    box.halfExtents = half;
    box.color = {color, color, color};
    box.tile = {tile, tile, tile};
    boxes.push_back(box);
  };
  add(Vec3(0.0f, -1.5f, -16.0f), Vec3(4.0f, 0.5f, 16.0f), floor, 8);
  boxes.back().reflects = true;
  add(Vec3(-4.5f, 1.5f, -16.0f), Vec3(0.5f, 3.5f, 16.0f), wall, 16);
  add(Vec3(4.5f, 1.5f, -16.0f), Vec3(0.5f, 3.5f, 16.0f), wall, 16);
  for (int i = 0; i < 5; ++i) {
    const float z = -3.5f - 4.0f * static_cast<float>(i);
    add(Vec3(-3.7f, 1.0f, z), Vec3(0.3f, 3.0f, 0.3f), beam, 0);
    add(Vec3(3.7f, 1.0f, z), Vec3(0.3f, 3.0f, 0.3f), beam, 0);
    add(Vec3(0.0f, 4.2f, z), Vec3(4.0f, 0.25f, 0.3f), beam, 0);
  }
  add(Vec3(-1.9f, -0.7f, -5.0f), Vec3(0.5f, 0.3f, 0.5f), beam, 9);
  add(Vec3(2.1f, -0.6f, -6.5f), Vec3(0.5f, 0.4f, 0.5f), beam, 9);
  return boxes;
}

void addBalls(Frame& frame) {
  Random random(7);
  const Vec3 places[] = {Vec3(-0.9f, -0.75f, -3.2f), Vec3(0.75f, 0.6f, -3.6f), Vec3(-0.1f, -0.75f, -5.2f),
                         Vec3(1.2f, -0.75f, -4.6f)};
  for (const Vec3& place : places) {
    Sphere ball;
    ball.position = place;
    ball.radius = 0.25f;
    ball.rotation = rotationAbout(randomUnit(random), 1.0f);
    frame.spheres.push_back(ball);
  }
  for (int i = 0; i < 60; ++i) {
    const float x = random.nextFloat(-1.2f, 1.4f);
    const float y = random.nextFloat(-1.0f, 1.2f);
    const float z = random.nextFloat(-7.0f, -3.5f);
    const float r = random.nextFloat(0.008f, 0.03f);
    frame.crumbs.push_back({Vec3(x, y < -0.4f ? -0.985f : y, z), r, packRgba(Rgb(0.8f, 0.95f, 0.97f))});
  }
}

void addLights(Frame& frame) {
  frame.beams.push_back({Vec3(-3.4f, 2.2f, -8.0f), Vec3(3.4f, 2.2f, -8.0f), 0.05f, packRgba(Rgb(1.0f, 0.25f, 0.2f))});
  for (const float side : {-1.0f, 1.0f}) {
    frame.glows.push_back({Vec3(side * 3.35f, 2.2f, -8.0f), 0.5f, packRgba(Rgb(1.0f, 0.35f, 0.25f))});
  }
}

void addHud(Frame& frame) {
  frame.texts.push_back({{Vec2(0.5f, 0.0f), Vec2(0.0f, 0.09f)}, 0.075f, HudAlign::Center, kWhite, "25"});
  frame.texts.push_back({{Vec2(0.5f, 1.0f), Vec2(0.0f, -0.06f)}, 0.035f, HudAlign::Center, kWhite, "1204 m"});
  frame.arcs.push_back(
      {{Vec2(0.5f, 0.0f), Vec2(0.0f, 0.09f)}, 0.105f, 0.118f, 0.0f, 1.0f, packRgba(Rgb::Ones(), 0.25f)});
  frame.arcs.push_back({{Vec2(0.5f, 0.0f), Vec2(0.0f, 0.09f)}, 0.105f, 0.118f, 0.0f, 0.7f, kWhite});
}

}  // namespace

void fillGallery(Gallery& gallery) {
  Frame& frame = gallery.frame;
  frame.clear();
  frame.groups[0].pool = &gallery.pool;
  frame.camera.position = Vec3(0.0f, 1.0f, 0.0f);
  frame.camera.rotation = rotationAbout(Vec3::UnitX(), -0.12f);
  frame.fog.bottom = Rgb(0.16f, 0.27f, 0.46f);
  frame.fog.top = Rgb(0.98f, 0.80f, 0.68f);
  Filler filler(gallery);
  addBrokenPane(filler, Vec3(0.1f, 0.4f, -5.8f), Vec3(1.1f, 1.2f, 0.03f), 13, Rgb(0.75f, 0.95f, 0.98f), 3);
  addFrame(filler, Vec3(0.1f, 0.4f, -5.8f), 1.2f, 1.3f);
  filler.addThing(geometry::makeBox<float>(Vec3(1.3f, 0.9f, 0.03f)), Vec3(-2.0f, 0.9f, -9.0f),
                  rotationAbout(Vec3::UnitY(), 0.5f), kGlass, Rgb(0.95f, 0.75f, 0.85f));
  filler.addThing(geometry::makeBox<float>(Vec3(1.3f, 0.9f, 0.03f)), Vec3(2.0f, 0.9f, -10.5f),
                  rotationAbout(Vec3::UnitY(), -0.5f), kGlass, Rgb(0.75f, 0.95f, 0.80f));
  addBlock(filler, Vec3(-1.9f, -0.02f, -5.0f), rotationAbout(Vec3::UnitY(), 0.6f), Rgb(0.35f, 0.75f, 0.95f), 0, 0.0f,
           5);
  addBlock(filler, Vec3(2.1f, 0.25f, -6.5f), rotationAbout(Vec3::UnitY(), 0.2f), Rgb(0.98f, 0.62f, 0.30f), 5, 0.25f, 6);
  filler.addThing(geometry::makeCylinder(0.3f, 0.5f, 24), Vec3(-2.8f, -0.5f, -7.5f), Quat::Identity(), kMetal,
                  Rgb(1.0f, 0.85f, 0.6f));
  addBalls(frame);
  addLights(frame);
  addHud(frame);
  frame.bloom = 0.5f;
  frame.mirrorHeight = -1.0f;
  gallery.room = bake(roomBoxes(), BakeDef{.light = {.top = 1.1f, .bottom = 0.7f}});
}

}  // namespace brittle::render
