#include "game/sim/level.h"

#include "game/content/level.h"
#include "game/sim/unread.h"

namespace brittle::sim {

Result<std::vector<RoomEntry>> loadLevel(Session& session, const std::string& name) {
  const std::string file = "levels/" + name + ".xml";
  const Result<std::string> text = session.files.text(file);
  if (!text) return text.error();
  const content::Level level = content::readLevel(*text, file);
  session.files.addProblems(level.problems);
  session.takeFileProblems();
  std::vector<RoomEntry> entries;
  for (const content::Room& room : level.rooms) {
    RoomEntry entry;
    entry.type = room.type;
    entry.displayLength = room.length;
    entry.endsAtCheckpoint = room.end;
    entry.attributes = room.attributes;
    entry.where = file + ":" + std::to_string(room.line);
    entries.push_back(std::move(entry));
  }
  if (!entries.empty()) entries.back().endsAtCheckpoint = true;
  if (entries.empty()) return Error{level.problems.front().text()};  // readLevel() says why
  return entries;
}

void readAhead(Session& session, const std::vector<RoomEntry>& entries) {
  std::map<std::string, std::string> globals = session.globals;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    reportUnread(session, entries[i]);
    const RoomPlan plan = planRoom(session, entries[i], roomSeed(session, entries[i], i), globals);
    for (const ObstacleDef& obstacle : plan.obstacles) {
      const Result<std::string> script = session.files.text("obstacles/" + obstacle.type + ".lua");
      if (!script) session.reportMissing("obstacle " + obstacle.type, obstacle.where, script.error().message);
      reportUnread(session, obstacle);
    }
  }
  session.omissions = {};  // counted when a room is made
}

std::uint64_t roomSeed(const Session& session, const RoomEntry& entry, std::uint64_t number) {
  const auto said = entry.attributes.find("seed");
  if (said != entry.attributes.end()) return hashBytes(said->second.data(), said->second.size());
  return mixSeed(session.def.mode == Mode::Training ? rules::kTrainingSeed : session.def.seed, number);
}

}  // namespace brittle::sim
