// physics/shape.h - a convex (its mesh lives in the mesh pool) or a sphere, and how its surface behaves. Belongs to one
// body at a time; breaking moves shapes between bodies.
#pragma once

#include <cstdint>

#include "engine/core/archive.h"
#include "engine/fracture/fracture.h"
#include "engine/geometry/gjk.h"
#include "engine/geometry/mass.h"
#include "engine/geometry/mesh_pool.h"
#include "engine/math/aabb.h"
#include "engine/physics/ids.h"

namespace brittle::physics {

struct Surface {
  float density = 1000.0f;     // [kg/m3]
  float friction = 0.5f;       // Coulomb; a pair uses the geometric mean
  float restitution = 0.0f;    // a pair uses the larger
  std::uint32_t category = 1;  // two shapes collide if each one's category is in the other's mask
  std::uint32_t mask = 0xffffffff;
};

struct ShapeDef {
  Surface surface;
  bool anchored = false;           // holds to the static world (breakable static bodies); see World::anchor
  std::uint16_t drawMaterial = 0;  // the renderer's
  std::uint16_t drawFlags = 0;
  std::uint32_t userData = 0;  // the game's; pieces inherit it
};

inline constexpr std::uint32_t kMaxAnchors = 6;

struct Shape {
  BodyHandle body;
  ShapeHandle next;                             // in its body's list
  geometry::MeshSlot mesh = geometry::kNoMesh;  // kNoMesh: a sphere
  Vec3 center = Vec3::Zero();                   // sphere only: local centre [m]
  float radius = 0.0f;                          // sphere only [m]
  float innerRadius = 0.0f;                     // half its thinnest extent [m]
  geometry::MassProperties massProperties;      // unit density, local frame
  Surface surface;
  bool anchored = false;
  bool isPiece = false;  // made by breaking
  std::uint16_t drawMaterial = 0;
  std::uint16_t drawFlags = 0;
  std::uint32_t userData = 0;
  std::uint32_t proxy = kNoProxy;           // in the broad phase
  std::uint32_t firstContact = kNoContact;  // list of its contacts, see contact_graph.h
  std::uint32_t contactCount = 0;
  fracture::Anchor
      anchors[kMaxAnchors];       // where it holds, in the body's frame; a piece that still touches one stays anchored
  std::uint32_t anchorCount = 0;  // 0 and anchored: it holds everywhere
  std::uint64_t meshHash = 0;     // of its vertices and planes: stands for the mesh in the state hash

  bool isSphere() const { return mesh == geometry::kNoMesh; }

  template <class Archive>
  void serialize(Archive& a) {
    a(body);
    a(next);
    a(mesh);
    a(center);
    a(radius);
    a(innerRadius);
    a(massProperties.volume);
    a(massProperties.center);
    a(massProperties.inertia);
    a(surface.density);
    a(surface.friction);
    a(surface.restitution);
    a(surface.category);
    a(surface.mask);
    a(anchored);
    a(isPiece);
    a(drawMaterial);
    a(drawFlags);
    a(userData);
    a(proxy);
    a(firstContact);
    a(contactCount);
    a(anchorCount);
    for (std::uint32_t i = 0; i < anchorCount && i < kMaxAnchors; ++i) {
      a(anchors[i].pointCount);
      for (std::uint32_t k = 0; k < anchors[i].pointCount && k < 8; ++k)
        a(anchors[i].points[k]);  // the others hold nothing
    }
    a(meshHash);
  }
};

/// The geometry of a shape for GJK and its relatives. Valid until the pool changes.
inline geometry::Proxy proxyOf(const Shape& shape, const geometry::MeshPool& pool) {
  if (shape.isSphere()) return {{}, shape.center, shape.radius};
  return {pool.view(shape.mesh), Vec3::Zero(), 0.0f};
}

inline bool mayCollide(const Surface& a, const Surface& b) {
  return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}

}  // namespace brittle::physics
