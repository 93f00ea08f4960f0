// game/sim/constants.h - every number of the rules, with its unit and what depends on it. Published values of the
// genre's gameplay are marked "format"; the rest is ours, chosen by playing, and says what goes wrong beyond its range.
#pragma once

#include <cstdint>

namespace brittle::sim::rules {

/// Raised by every change that changes results: a replay of another version is refused.
inline constexpr std::uint32_t kSimulationVersion = 8;

// Time.
inline constexpr int kTickRate = 60;                 // [ticks/s], format
inline constexpr float kTickSeconds = 1.0f / 60.0f;  // [s]
inline constexpr int kRoomTicks = 32 * kTickRate;    // a room lasts 32 s whatever its length, format
inline constexpr float kBeatTicks = 30.0f;           // 120 beats a minute, format

// Camera.
inline constexpr float kCameraHeight = 1.0f;  // [m], format
inline constexpr float kHalfWidthTangent =
    0.57735027f;  // 60 degrees from left to right, format; height follows the picture's aspect
/// Width over height: beyond, a phone held upright. What is narrower shows less of the width, not more of the height.
inline constexpr float kNarrowestPicture = 9.0f / 21.0f;
inline constexpr float kNear = 0.2f;      // [m], format
inline constexpr float kFar = 100.0f;     // [m], format
inline constexpr float kFogNear = 5.0f;   // fog begins at this depth [m], format
inline constexpr float kFogFull = 25.0f;  // and is full here [m], format
inline constexpr float kCameraRadius =
    0.25f;                                // what must fit through a hole [m]; above 0.6 no single throw opens a way
inline constexpr int kPaceShift = 200;    // room length glides by 1/200 of the difference per tick, format
inline constexpr int kQuickSaveTick = 3;  // a room counts as reached this many ticks after its door, format

// Track.
inline constexpr float kSpawnAhead = 30.0f;            // obstacles start this far ahead [m], format
inline constexpr float kSpawnAheadElevator = 40.0f;    // those with "elevator" in their name [m], format
inline constexpr float kNextRoomAhead = 30.0f;         // the next room is made this far before the door [m], format
inline constexpr int kNextRoomTicks = 28 * kTickRate;  // or after this time in the room, format
inline constexpr float kShiftEvery = 64.0f;  // the origin moves on at multiples of this in a room [m], multiple of 2^-8
inline constexpr float kBuildAhead = 70.0f;  // segments get their bodies this far ahead [m]; a ball never outflies it
inline constexpr float kSegmentBehind = 2.0f;  // a segment is dropped when its end is this far behind the camera [m]
inline constexpr float kDefaultRoomLength = 160.0f;  // of a room script that declares none [m]
inline constexpr float kLengthStep = 1.0f / 256.0f;  // room lengths and shifts are multiples of this [m]
inline constexpr float kBehindCamera = 0.6f;         // things wholly this far behind are removed [m]
// So are pieces out of sight for so long [ticks]. Measured where somebody throws at everything for five minutes: after
// a quarter of a second 5 of 7342 come back into the picture, after half a second none of 3298.
inline constexpr int kUnseenTicks = kTickRate / 2;
inline constexpr float kFallDepth = -10.0f;  // what falls below is removed [m], format

// Balls.
inline constexpr int kStartBalls = 25;             // format
inline constexpr int kTrainingBallCap = 500;       // format
inline constexpr int kBallCap = 999;               // in every other mode: three digits are all the picture has room for
inline constexpr std::uint64_t kTrainingSeed = 1;  // training is the same every time, format
inline constexpr float kBallRadius = 0.13f;      // [m]; below 0.08 it slips between bars, above 0.2 it hides the target
inline constexpr float kBallDensity = 7800.0f;   // steel [kg/m3]: 72 kg at 0.13 m
inline constexpr float kBallFriction = 0.4f;     // [-]
inline constexpr float kBallRestitution = 0.3f;  // [-]
inline constexpr float kThrowSpeed = 20.0f;      // on top of the camera's own speed [m/s]; below 12 throws fall short
inline constexpr float kThrowAhead = 0.5f;       // a ball starts this far ahead of the camera [m]
inline constexpr float kAimDistance = 10.0f;     // a throw is lobbed so that it crosses the aimed line here [m]
inline constexpr float kVolleySpread = 0.32f;    // between the balls of one throw [m]; above 2 radii, or they collide
inline constexpr int kMaxVolley = 5;             // format
inline constexpr int kStreakPerBall = 10;        // streak for one more ball in a throw, format

// Score.
inline constexpr int kCrashCost = 10;           // balls, format
inline constexpr int kCrashPause = 45;          // ticks without another crash
inline constexpr float kCrashPieceMass = 6.0f;  // loose pieces below this are pushed aside by the camera [kg]
inline constexpr float kCrashRimMass =
    0.5f;  // and so are slivers at the rim of a hole below this [kg]: 11 cm of a pane of 4 cm
inline constexpr float kCrashSpeed = 12.0f;  // breaking by the camera is a hit of this speed [m/s]
inline constexpr int kLastBallTicks = 120;   // grace for the last ball to win others [ticks]
inline constexpr int kClearedNotes = 12;     // sounds of a cleared obstacle, format
inline constexpr int kPainTicks = 40;        // the red border fades over this [ticks]

// Power-ups.
inline constexpr int kFrenzyTicks = 8 * kTickRate;  // throws are free so long [ticks]
inline constexpr int kSprayTicks = 6;               // while they are, a held pointer throws each [ticks]
inline constexpr int kNitroTicks = 10 * kTickRate;  // [ticks]
inline constexpr int kSlowTicks = 8 * kTickRate;    // before time gets faster again [ticks]
inline constexpr int kSlowestShare = 64;            // of 256: time runs at a quarter; below 16 the physics takes no dt
inline constexpr int kSlowStep = 6;  // of 256 a tick: slow within half a second, and down and up are 40 ticks in all
inline constexpr int kMostPowerUps = 9;        // of a kind: one digit
inline constexpr float kPickupRadius = 0.30f;  // a ball whose surface comes nearer collects it [m]
inline constexpr int kMaxPickupsPerRoom = 200;
// Blasts: of a nitro ball, of a barrel. A pane of 4 cm has 10 kg/m2: 60 N s/m2 are 6 m/s.
struct BlastRule {
  float breakReach, pushReach;  // [m]
  float pressure;               // [N s/m2]
  float mostSpeed, breakSpeed;  // [m/s]
  float standOff;               // of the centre before what was touched [m]; at 0 it runs along a pane, not through it
  float shake;                  // of the camera, close by, 0 to 1
};
inline constexpr BlastRule kNitroBlast = {1.5f, 3.2f, 140.0f, 10.0f, 12.0f, 0.3f, 0.45f};
inline constexpr BlastRule kBarrelBlast = {4.5f, 9.0f, 700.0f, 18.0f, 18.0f, 0.8f, 1.0f};
inline constexpr float kShakeReach = 14.0f;  // a blast farther from the camera does not shake it [m]

// Units of the level format. Its materials say density 1 and force limits of 0.01 to 0.5. Shipped panes (4 x 2 x 0.04
// m, limit 0.1) weigh 80 kg and hold 150 N s a tick: ten times their weight is 131 N s; a ball brings 1430 N s at the
// slowest throw.
inline constexpr float kDensityUnit = 250.0f;  // [kg/m3] per 1 of the format
inline constexpr float kForceUnit = 1500.0f;   // [N s] per 1 of the format
inline constexpr float kCarveRadius =
    0.55f;  // hole of a hit at 10 m/s [m]: at the slowest throw the camera fits through
inline constexpr float kBlockCracks = 0.5f;     // cracks in blocks, relative to the material's default [-]
inline constexpr float kSmallestPiece = 1e-4f;  // pieces below become crumbs [m3]; above 1e-3 panes vanish into dust
inline constexpr float kWeightsHeld =
    4.0f;  // a body holds at least so many of its own weight [-]; below 1 it bursts as it stands
inline constexpr float kSmallestShare =
    1.0f / 1000.0f;  // and below this share of the thing [-]; much less, and a big block makes 2,000 bodies
inline constexpr float kGravity = 9.81f;  // [m/s2] at the format's gravity 1

// Water.
inline constexpr float kWaterDensity = 1000.0f;  // beside a ball, which weighs what steel weighs [kg/m3]
inline constexpr float kFormatWaterDensity =
    100.0f;  // beside the format's materials: their density 1 is 250 kg/m3, a tenth of glass; above 250 glass floats
inline constexpr float kBallDrag = 0.47f;          // [-] of a smooth sphere. Source: Hoerner, Fluid-Dynamic Drag, 1965
inline constexpr float kBodyDrag = 1.05f;          // [-] of a cube, as there
inline constexpr float kWaterSpin = 2.0f;          // turning dies down at this rate [1/s]; above 30 things stop at once
inline constexpr float kSplashSpeed = 0.4f;        // what goes in slower makes no splash [m/s]
inline constexpr std::uint32_t kMaxSplashes = 16;  // of a room in a tick: shards that rain in
inline constexpr std::uint32_t kMaxWatersPerRoom = 64;  // each body looks at each of them

// Collision categories (bits), the format's.
inline constexpr std::uint32_t kCategoryDefault = 1;
inline constexpr std::uint32_t kCategoryCrystal = 4;
inline constexpr std::uint32_t kCategoryBall = 8;    // ours: the format leaves it open
inline constexpr std::uint32_t kCategoryRoom = 128;  // what rays with mask 128 ask for

// Scripts. Beyond these bounds of what they ask for single precision is of no use.
inline constexpr float kFarthest = 10'000.0f;  // places and distances [m]
inline constexpr float kMostAngle = 1e6f;      // [rad]
inline constexpr float kMostSpeed = 1000.0f;   // [m/s], [rad/s]
inline constexpr std::uint32_t kMaxBodiesPerObstacle = 256;
inline constexpr std::uint32_t kMaxShapesPerObstacle = 1024;
inline constexpr std::int64_t kScriptInstructions =
    200'000;  // per call of a script; a busy obstacle needs a few thousand
// Of an obstacle's script: its memory, of which an empty one takes 80 kB, and its text; those shipped have up to 3 kB.
inline constexpr std::size_t kScriptMemory = 256u << 10;  // [bytes]
inline constexpr std::size_t kLongestScript = 64u << 10;  // [bytes]
inline constexpr int kCylinderSides = 12;
inline constexpr float kButtonRadius = 0.2f;  // [m]
inline constexpr float kLaserReach = 20.0f;   // [m]

// What a room holds, so that no level can hang the game or exhaust memory; what is beyond is said once and left out. A
// room of the format has up to 12 segments, each with 58 boxes (at most 441) and 2.6 obstacles on average. Shipped
// rooms have at most 62 obstacles, 33 bodies and 48 shapes of theirs at once, 4,034 contacts and 5,020 instructions in
// a tick.
inline constexpr std::uint32_t kMaxSegmentsPerRoom = 1000;  // and single boxes of its script
inline constexpr std::uint32_t kMaxBoxesPerRoom = 10'000;   // and decals, of all segments
inline constexpr float kCrowdCell = 8.0f;                   // [m] of a room's length
inline constexpr std::uint32_t kMaxBoxesPerCell = 1500;     // reach into it: rays and pairs take time by their number
inline constexpr std::uint32_t kMaxObstaclesPerRoom = 500;
inline constexpr std::uint32_t kMaxBodiesPerRoom = 1500;      // of the obstacles that are alive
inline constexpr std::uint32_t kMaxShapesPerRoom = 3000;      // too
inline constexpr std::uint32_t kMaxContactsPerRoom = 16'000;  // 5 microseconds a tick each
inline constexpr std::int64_t kRoomInstructions =
    2'000'000;  // of all its obstacles' scripts, for starting, tick() and draw() each: 10 ms
inline constexpr std::int64_t kStartPrice = 20'000;  // of an obstacle, in instructions: its sandbox is made

inline constexpr std::size_t kMaxContent = 64u << 20;  // of all files a game reads [bytes]; the shipped ones: 140 kB
inline constexpr std::uint32_t kMaxProblems = 256;     // kept; more are not said

}  // namespace brittle::sim::rules
