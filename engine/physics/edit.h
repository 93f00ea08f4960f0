// physics/edit.h - making, joining and unmaking bodies and shapes: the primitive operations that World's interface and
// breaking are written with. Definitions have been checked by the time they get here.
#pragma once

#include "engine/physics/state.h"

namespace brittle::physics {

/// Half the thinnest extent of a convex, over its faces' directions. [m]
float innerRadiusOf(const geometry::ConvexView& convex);

BodyHandle makeBody(State& state, const Body& body);
/// A shape of `body` with its mesh in the pool; `properties` for unit density in the body's frame. Mass is not updated.
ShapeHandle makeConvex(State& state, BodyHandle body, const Shape& like, const geometry::ConvexView& convex,
                       const geometry::MassProperties& properties);
ShapeHandle makeSphere(State& state, BodyHandle body, const Shape& shape);
/// Gives a shape another convex; contacts are removed, its proxy is renewed.
void replaceConvex(State& state, ShapeHandle shape, const geometry::ConvexView& convex,
                   const geometry::MassProperties& properties);
/// Moves a shape to another body with the same frame. Mass is not updated.
void moveShape(State& state, ShapeHandle shape, BodyHandle body);
void dropShape(State& state, ShapeHandle shape);
void dropBody(State& state, BodyHandle body);
/// Mass, centre, inertia and radii from the shapes; the frame stays, velocities become those at the new centre.
void updateMass(State& state, BodyHandle body);
/// World inertia after the body has turned.
void refreshInertia(Body& body);

}  // namespace brittle::physics
