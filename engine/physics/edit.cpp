#include "engine/physics/edit.h"

#include "engine/core/hash.h"
#include "engine/physics/collide.h"
#include "engine/physics/contact_graph.h"
#include "engine/physics/deactivation.h"

#include <cmath>

namespace brittle::physics {
namespace {

std::uint64_t hashOf(const geometry::ConvexView& convex) {
  StateHash hash;
  for (const geometry::Vertex& vertex : convex.vertices)
    for (int i = 0; i < 3; ++i) hash.add(vertex.point[i]);
  for (const geometry::Face& face : convex.faces) {
    for (int i = 0; i < 3; ++i) hash.add(face.plane.normal[i]);
    hash.add(face.plane.offset);
  }
  return hash.value();
}

void attach(State& state, ShapeHandle handle, BodyHandle bodyHandle) {
  Shape& shape = state.shapes[handle];
  Body& body = state.bodies[bodyHandle];
  shape.body = bodyHandle;
  shape.next = body.firstShape;
  body.firstShape = handle;
  ++body.shapeCount;
  if (!shape.isSphere()) state.meshes.setBody(shape.mesh, bodyHandle.index);
}

void detach(State& state, ShapeHandle handle) {
  const Shape& shape = state.shapes[handle];
  Body& body = state.bodies[shape.body];
  ShapeHandle* link = &body.firstShape;
  while (!(*link == handle)) link = &state.shapes[*link].next;
  *link = shape.next;
  --body.shapeCount;
}

void setGeometry(Shape& shape, const geometry::ConvexView& convex, const geometry::MassProperties& properties) {
  shape.innerRadius = innerRadiusOf(convex);
  shape.massProperties = properties;
  shape.meshHash = hashOf(convex);
}

/// The determinant is of the third power of what a shard of a millimetre has, 1e-13 kg m2, and would be no number any
/// more: scaled by a power of two first, which changes no bit of any other.
Mat3 inverseOf(const Mat3& inertia) {
  int exponent = 0;
  std::frexp(inertia.trace(), &exponent);
  const float scale = std::ldexp(1.0f, -exponent);
  return Mat3(Mat3(inertia * scale).inverse() * scale);
}

}  // namespace

float innerRadiusOf(const geometry::ConvexView& convex) {
  float thinnest = 3.0e38f;
  for (const geometry::Face& face : convex.faces) {
    float depth = 0.0f;
    for (const geometry::Vertex& vertex : convex.vertices) depth = maxOf(depth, -face.plane.distance(vertex.point));
    thinnest = minOf(thinnest, depth);
  }
  return 0.5f * thinnest;
}

BodyHandle makeBody(State& state, const Body& body) {
  return state.bodies.insert(body);
}

ShapeHandle makeConvex(State& state, BodyHandle body, const Shape& like, const geometry::ConvexView& convex,
                       const geometry::MassProperties& properties) {
  Shape shape = like;
  shape.next = {};
  shape.firstContact = kNoContact;
  shape.contactCount = 0;
  shape.mesh = state.meshes.add(convex, body.index, like.drawMaterial, like.drawFlags);
  setGeometry(shape, convex, properties);
  const ShapeHandle handle = state.shapes.insert(shape);
  attach(state, handle, body);
  insertProxy(state, handle);
  state.newShapes.push_back(handle);
  return handle;
}

ShapeHandle makeSphere(State& state, BodyHandle body, const Shape& sphere) {
  const ShapeHandle handle = state.shapes.insert(sphere);
  attach(state, handle, body);
  insertProxy(state, handle);
  state.newShapes.push_back(handle);
  return handle;
}

void replaceConvex(State& state, ShapeHandle handle, const geometry::ConvexView& convex,
                   const geometry::MassProperties& properties) {
  removeContactsOf(state, handle);
  Shape& shape = state.shapes[handle];
  state.meshes.replace(shape.mesh, convex);
  setGeometry(shape, convex, properties);
  state.tree.remove(shape.proxy);
  insertProxy(state, handle);
  state.newShapes.push_back(handle);
}

void moveShape(State& state, ShapeHandle shape, BodyHandle body) {
  detach(state, shape);
  attach(state, shape, body);
  state.newShapes.push_back(shape);
}

void dropShape(State& state, ShapeHandle handle) {
  removeContactsOf(state, handle);
  detach(state, handle);
  const Shape& shape = state.shapes[handle];
  state.tree.remove(shape.proxy);
  if (!shape.isSphere()) state.meshes.remove(shape.mesh);
  state.shapes.erase(handle);
}

void dropBody(State& state, BodyHandle handle) {
  forEachShape(state, state.bodies[handle], [&](ShapeHandle shape, const Shape&) { dropShape(state, shape); });
  state.bodies.erase(handle);
}

void updateMass(State& state, BodyHandle handle) {
  Body& body = state.bodies[handle];
  geometry::MassProperties total;
  float inner = 3.0e38f;
  forEachShape(state, body, [&](ShapeHandle, const Shape& shape) {
    geometry::MassProperties part = shape.massProperties;
    part.volume *= shape.surface.density;  // from unit density to mass
    part.inertia *= shape.surface.density;
    total = total.volume > 0.0f ? geometry::combined(total, part) : part;
    inner = minOf(inner, shape.innerRadius);
  });
  if (body.shapeCount == 0) return;
  const Vec3 oldCenter = body.center;
  body.mass = total.volume;
  body.localCenter = total.center;
  body.localInertia = total.inertia;
  body.innerRadius = inner;
  body.placeByPose();
  body.velocity += body.angularVelocity.cross(body.center - oldCenter);
  body.radius = 0.0f;
  forEachShape(state, body, [&](ShapeHandle, const Shape& shape) {
    if (shape.isSphere())
      body.radius = maxOf(body.radius, (shape.center - body.localCenter).norm() + shape.radius);
    else
      for (const geometry::Vertex& vertex : state.meshes.view(shape.mesh).vertices)
        body.radius = maxOf(body.radius, (vertex.point - body.localCenter).norm());
  });
  body.invMass = body.isDynamic() ? 1.0f / body.mass : 0.0f;
  body.localInvInertia = body.isDynamic() ? inverseOf(body.localInertia) : Mat3(Mat3::Zero());
  refreshInertia(body);
}

void refreshInertia(Body& body) {
  const Mat3 rotation = body.pose.rotation.toRotationMatrix();
  body.invInertia = rotation * body.localInvInertia * rotation.transpose();
}

}  // namespace brittle::physics
