#include "game/sim/dry_run.h"

#include <map>
#include <set>

#include "game/sim/level.h"
#include "game/sim/pace.h"
#include "game/sim/room.h"

namespace brittle::sim {

namespace {

constexpr float kStride = 10.0f;  // [m] of the camera in a tick: three from where obstacles start to where they are
constexpr float kSpeed = 10.0f;   // that it seems to have [m/s]
constexpr int kMostTries = 3;     // of the same room
constexpr std::int32_t kMostTicks = 4000;  // in all: 200 rooms of 160 m, which take 6 s
constexpr Mode kModes[] = {Mode::Classic, Mode::Training, Mode::Mayhem};

/// Past every obstacle; in how many ticks. Where too many are to start in one the camera waits for them.
std::int32_t passThrough(Session& session, Room& room) {
  const float length = allowedLength(room.settings().length);
  std::int32_t ticks = 0;
  for (float distance = -rules::kSpawnAhead; distance < length; distance += kStride) {
    std::uint64_t before = 0;
    do {
      before = session.omissions[Omission::DeferredObstacle];
      session.events.clear();
      room.tick(distance, kSpeed, ticks++);
    } while (session.omissions[Omission::DeferredObstacle] != before);
  }
  return ticks;
}

class Rooms {
 public:
  Rooms(const content::AssetSource& assets, const std::string& level, const DryRunGoesOn& goesOn)
      : assets_(assets), level_(level), goesOn_(goesOn) {}

  DryRun run() {
    for (const Mode mode : kModes)
      if (!runMode(mode)) break;
    return std::move(found_);
  }

 private:
  bool runMode(Mode mode) {
    GameDef def;
    def.level = level_;
    def.mode = mode;
    Session session(assets_, def);
    const Result<std::vector<RoomEntry>> entries = loadLevel(session, level_);
    if (!entries) session.report(entries.error().message);
    if (entries) readAhead(session, *entries);
    bool isWanted = static_cast<bool>(entries);
    for (std::size_t i = 0; isWanted && i < entries->size(); ++i) {
      tryRoom(session, (*entries)[i], i);
      isWanted = goesOn_(done_++, static_cast<std::uint32_t>(std::size(kModes) * entries->size()));
    }
    take(session);
    return isWanted;
  }

  void tryRoom(Session& session, const RoomEntry& entry, std::size_t number) {
    if (!session.files.text("rooms/" + entry.type + ".lua")) return;
    const bool isClassic = session.def.mode == Mode::Classic;
    const auto same = std::make_pair(entry.type, entry.attributes);
    const bool isNew = isClassic ? tries_[same]++ < kMostTries : others_.contains(number);
    if (!isNew || ticks_ >= kMostTicks) {  // what it sets is there for those behind it
      planRoom(session, entry, roomSeed(session, entry, number), session.globals);
      return;
    }
    Room room(session, entry, number, static_cast<std::uint32_t>(number & 1));
    if (isClassic && room.hasOtherModes()) others_.insert(number);
    if (isClassic) ++found_.rooms;
    ticks_ += passThrough(session, room);
  }

  void take(const Session& session) {
    for (const Problem& problem : session.problems)
      if (said_.insert(problem.text).second) found_.problems.push_back(problem.text);
    if (const std::uint64_t more = session.omissions[Omission::UntoldProblem])
      found_.problems.push_back("levels/" + level_ + ".xml: " + std::to_string(more) + " " +
                                nameOf(Omission::UntoldProblem));
  }

  const content::AssetSource& assets_;
  const std::string& level_;
  const DryRunGoesOn& goesOn_;
  DryRun found_;
  std::uint32_t done_ = 0;
  std::int32_t ticks_ = 0;
  std::map<std::pair<std::string, std::map<std::string, std::string>>, int> tries_;
  std::set<std::size_t> others_;  // rooms with something for other modes
  std::set<std::string> said_;
};

}  // namespace

DryRun dryRun(const content::AssetSource& assets, const std::string& level, const DryRunGoesOn& goesOn) {
  return Rooms(assets, level, goesOn).run();
}

}  // namespace brittle::sim
