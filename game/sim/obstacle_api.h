// game/sim/obstacle_api.h - the obstacle scripts' calls, one file per theme; and what their natives share.
#pragma once

#include "engine/script/library.h"
#include "game/sim/obstacle.h"

namespace brittle::sim {

void addShapeCalls(script::Library& library);  // materials, bodies, shapes
void addJointCalls(script::Library& library);
void addMotionCalls(script::Library& library);  // drives, velocities
void addQueryCalls(script::Library& library);   // rays, poses, camera
void addPlayCalls(script::Library& library);    // score, sound, time, parameters

/// mgLaser: a beam that ends at the first thing in its way and hurts when it meets the camera.
void castLaser(script::Call& call, Obstacle& obstacle);

/// Adds a call whose native gets the obstacle; while the obstacle is muted the call does nothing and answers 0.
void addCall(script::Library& library, const char* name, void (*native)(script::Call&, Obstacle&));

/// Three numbers from argument `first` on, none larger than `most`; `otherwise` if the first of them is missing.
Vec3 readVector(script::Call& call, int first, float most);
Vec3 readVector(script::Call& call, int first, float most, const Vec3& otherwise);
void answer(script::Call& call, const Vec3& vector);
/// About X, Y, Z, such that rotationXyz gives the rotation back.
Vec3 anglesOf(const Quat& rotation);

/// The body of argument `index`; a wrong number fails the call. Null also if the body has not been made or is gone.
ScriptBody* readBody(script::Call& call, Obstacle& obstacle, int index);
/// A body that the script's body now is: itself, or the first that its pieces belong to. Null if none is left.
physics::BodyHandle currentBody(const Obstacle& obstacle, const ScriptBody& body);

// What a call takes beside the instructions of the script, in their price: 5 ns each, measured. Calls that take time by
// the number of things there are would let a short script hang the game.

/// `base`, and `each` for every shape of a body.
void chargeForShapes(script::Call& call, const Obstacle& obstacle, const ScriptBody& body, int base, int each);
/// A ray between two places of the room's local frame.
void chargeForRay(script::Call& call, const Obstacle& obstacle, const Vec3& from, const Vec3& to);

/// Fails the call: there is no place for more. Counted.
void refuseMore(script::Call& call, const Obstacle& obstacle, const std::string& why);
/// Fails the call if the obstacle, or its room, has all the bodies it may have.
bool hasPlaceForBody(script::Call& call, const Obstacle& obstacle);

}  // namespace brittle::sim
