#include "game/sim/unread.h"

#include <algorithm>
#include <iterator>

#include "game/content/level_names.h"
#include "game/content/parameter_names.h"

namespace brittle::sim {

namespace {

constexpr std::string_view kOfEveryRoom[] = {"type", "length", "distance", "start", "end", "seed"};

const content::ParameterNames& namesOfStones() {
  static const content::ParameterNames names = {{"sizeX", "sizeY", "sizeZ", "color", "tile", "nomask"}, false};
  return names;
}

void say(Session& session, const std::string& where, const std::string& what, const std::string& key,
         const std::string& value, const std::string& expected) {
  session.report(content::Problem{where, 0, what, key + "=" + value, expected}.text());
}

}  // namespace

void reportUnread(Session& session, const ObstacleDef& obstacle) {
  const bool isStone = obstacle.type == kStone;
  const std::string file = "obstacles/" + obstacle.type + ".lua";
  const content::ParameterNames& asked = isStone ? namesOfStones() : session.files.parameterNames(file);
  for (const auto& [key, value] : obstacle.parameters) {
    const std::string expected = content::expectedFor(key, asked, isStone || obstacle.shared.contains(key));
    if (expected.empty()) continue;
    const std::string who = isStone ? "a parameter that no stone has" : "a parameter that " + file + " never asks for";
    say(session, obstacle.where, who, key, value, expected);
  }
}

void reportUnread(Session& session, const RoomEntry& room) {
  const std::string file = "rooms/" + room.type + ".lua", include = "rooms/include.lua";
  content::ParameterNames asked = session.files.parameterNames(file);
  if (session.files.text(include)) asked.add(session.files.parameterNames(include));
  for (const auto& [key, value] : room.attributes) {
    const bool isKnown = std::find(std::begin(kOfEveryRoom), std::end(kOfEveryRoom), key) != std::end(kOfEveryRoom);
    const std::string expected = content::expectedFor(key, asked, false);
    if (isKnown || content::isEditorsName(key) || expected.empty()) continue;
    say(session, room.where, "an attribute that " + file + " never asks for", key, value, expected);
  }
}

}  // namespace brittle::sim
