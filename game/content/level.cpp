#include "game/content/level.h"

#include "game/content/xml_file.h"

#include <set>

namespace brittle::content {
namespace {

using Found = Attributes::Found;

constexpr std::size_t kMostRooms = 500;  // a game reads the scripts of all before it begins

bool readRoom(const Attributes& attributes, const pugi::xml_node& node, Room& room) {
  room.line = attributes.line();
  for (const pugi::xml_attribute& attribute : node.attributes())
    room.attributes.emplace(attribute.name(), attribute.value());
  if (attributes.text("type", room.type) != Found::Good) {
    attributes.report("type is missing: the room is left out");
    return false;
  }
  Found found = attributes.number("length", 0.001, 1e6, room.length);
  if (found == Found::Absent)
    found = attributes.number("distance", 0.001, 1e6, room.length);  // what test servers call it
  if (found == Found::Absent) attributes.report("length is missing: 100 is used");
  attributes.truth("start", room.start);
  attributes.truth("end", room.end);
  return true;
}

}  // namespace

Level readLevel(const std::string& text, const std::string& file) {
  Level level;
  level.file = file;
  const XmlFile xml(text, file, "level", level.problems);
  std::set<std::string> reported;
  for (const pugi::xml_node& node : xml.elements()) {
    if (std::string_view(node.name()) != "room") continue;
    if (level.rooms.size() == kMostRooms) {
      xml.report({file,
                  xml.lineOf(node),
                  "too many rooms: the rest is left out",
                  {},
                  "at most " + std::to_string(kMostRooms)});
      break;
    }
    Room room;
    if (readRoom(Attributes(xml, node, nullptr, reported), node, room)) level.rooms.push_back(std::move(room));
  }
  if (level.rooms.empty() && xml.root()) xml.report({file, xml.lineOf(xml.root()), "the level has no rooms", {}, {}});
  return level;
}

GameList readGameList(const std::string& text, const std::string& file) {
  GameList list;
  list.file = file;
  const XmlFile xml(text, file, "game", list.problems);
  std::set<std::string> reported;
  for (const pugi::xml_node& group : xml.elements()) {
    if (std::string_view(group.name()) != "levels") continue;
    for (const pugi::xml_node& node : group.children("level")) {
      const Attributes attributes(xml, node, nullptr, reported);
      LevelEntry entry{{}, attributes.line()};
      const Found found = attributes.text("name", entry.name);
      if (found == Found::Absent) attributes.report("name is missing: the level is left out");
      if (found == Found::Good) list.levels.push_back(std::move(entry));
    }
  }
  if (list.levels.empty() && xml.root()) xml.report({file, xml.lineOf(xml.root()), "the game has no levels", {}, {}});
  return list;
}

}  // namespace brittle::content
