#include "game/content/script_names.h"

#include <algorithm>

#include "game/content/nearest.h"

namespace brittle::content {
namespace {

constexpr std::string_view kCalls[] = {
    // rooms
    "mgSegment", "confSegment", "nextSegment", "mgLength", "mgMusic", "mgFogColor", "mgReverb", "mgEcho", "mgLowPass",
    "mgGravity", "mgSetRotation", "mgRotation", "mgParticles", "mgDepthOfField", "mgSetDifficulty", "mgGetBool",
    "mgGetInt", "mgGetFloat", "mgGetString", "mgGet", "mgSet", "mgRndFloat", "mgRndInt", "mgRndBool", "mgRandomize",
    "mgBox", "mgColor", "mgTexture", "mgObstacle", "mgPowerUp", "mgGetSplitExtraRoomLength",
    // obstacles: bodies and shapes
    "mgCreateBody", "mgCreateBox", "mgCreateCylinder", "mgCreateMesh", "mgClearShapes", "mgTranslateShape",
    "mgMaterial", "mgDensity", "mgForceLimit", "mgRoundness", "mgShapeChamfer", "mgShapeScale", "mgHideEdges",
    "mgStatic", "mgCategory", "mgMask", "mgSetShapeColor", "mgSetShapeMask",
    // obstacles: joints and motion
    "mgCreateHingeJoint", "mgCreateBallJoint", "mgCreateSliderJoint", "mgCreateRope", "mgGetJointBodies",
    "mgIsConnected", "mgMove", "mgRotate", "mgReleaseMotion", "mgSetVel", "mgSetAngVel", "mgClonePose",
    // obstacles: questions
    "mgRaycast", "mgGetPos", "mgGetRot", "mgBodyPointToWorld", "mgBodyVecToWorld", "mgBodyContainsPoint",
    "mgGetShapeBody", "mgShapeIsBroken", "mgBodyIsBroken", "mgGetCameraPos", "mgGetCameraSpeed", "mgCameraDistance",
    "mgGetGravity", "mgCanPass", "mgHasBoss", "mgIsClosestBoss", "mgTime", "mgObstacleTime", "mgGetBeat", "mgGetColor",
    // obstacles: play
    "mgScore", "mgGlow", "mgClear", "mgIsCleared", "mgCreateButton", "mgIsButtonDown", "mgSetButtonDown", "mgLaser",
    "mgSmoke", "mgCameraShake", "mgBodyDecal", "mgCreateSound", "mgPlaySound"};

}  // namespace

bool isScriptCall(std::string_view name) {
  return std::find(std::begin(kCalls), std::end(kCalls), name) != std::end(kCalls);
}

std::string nearestScriptCall(std::string_view name) {
  return nearestOf(name, kCalls);
}

}  // namespace brittle::content
