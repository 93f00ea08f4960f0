#include "game/content/script_names.h"

#include <algorithm>
#include <vector>

namespace brittle::content {
namespace {

constexpr std::string_view kCalls[] = {
    // rooms
    "mgSegment", "confSegment", "nextSegment", "mgLength", "mgMusic", "mgFogColor", "mgReverb", "mgEcho", "mgLowPass",
    "mgGravity", "mgSetRotation", "mgRotation", "mgParticles", "mgSetDifficulty", "mgGetBool", "mgGetInt", "mgGetFloat",
    "mgGetString", "mgGet", "mgSet", "mgRndFloat", "mgRndInt", "mgRndBool", "mgRandomize", "mgBox", "mgColor",
    "mgTexture", "mgObstacle", "mgPowerUp", "mgGetSplitExtraRoomLength",
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

constexpr std::size_t kFar = 3;

/// Letters to change, add or leave out between two names. Source: Wagner and Fischer, The String-to-String Correction
/// Problem, 1974.
std::size_t distanceBetween(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

}  // namespace

bool isScriptCall(std::string_view name) {
  return std::find(std::begin(kCalls), std::end(kCalls), name) != std::end(kCalls);
}

std::string nearestScriptCall(std::string_view name) {
  std::string_view nearest;
  std::size_t least = kFar;
  if (name.size() > 100) return {};
  for (const std::string_view call : kCalls) {
    const std::size_t distance = distanceBetween(name, call);
    if (distance >= least) continue;
    least = distance;
    nearest = call;
  }
  return std::string(nearest);
}

}  // namespace brittle::content
