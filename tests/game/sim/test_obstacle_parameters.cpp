// The shipped obstacles take the parameters that levels of the format give them, with the format's defaults: a level
// that leaves one out must look as its author saw it.
#include <gtest/gtest.h>

#include <regex>

#include "fixture.h"

namespace brittle::sim {
namespace {

struct Asked {
  const char* type;
  const char* parameters;  // "name=default ..."; of a name alone the default is no constant
};

constexpr Asked kFormat[] = {
    {"scoretop", "static=true raycast=false color"},
    {"scorediamond", "raycast=false color"},
    {"scorestar", "raycast=false color"},
    {"bar", "thickness=0.12 height=0.12 blocker=false move=0 offset=0 speed=1 maxwidth=10 color"},
    {"framedwindow", "width=4 height=2 color"},
    {"suspendwindow", "width=2 height=2 thickness=0.02 strength=0.1 plate=false perpendicular=false color"},
    {"box", "sizeX=0.5 sizeY=0.5 sizeZ=0.5 strength=0.1 raycast=false color"},
    {"suspendcube", "width=2 height=1 depth=0.3 vx=0 vz=0 rot=0 color"},
    {"rotor",
     "length=1 arms=2 speed=2 drive=true width=0.1 endplate=false beat=0 radius=0.2 offset thickness=0.1 color"},
    {"sweeper",
     "width=2 height=2 panewidth=0.4 beat=false speed=1 thickness=0.02 strength=0.2 blocker=false offset "
     "color"},
    {"doors/basic", "width=2 height=2 buttons=0 distance=5 color"},
};

/// What the script says after `mgGet...("name", `, up to the end of the argument; empty if it never asks.
std::string askedFor(const std::string& script, const std::string& name) {
  const std::regex call("mgGet(Float|Int|Bool|Color)\\(\"" + name + "\", ([^,)]*)");
  std::smatch found;
  return std::regex_search(script, found, call) ? found[2].str() : "";
}

TEST(ObstacleParameters, AreTheFormatsWithItsDefaults) {
  for (const Asked& asked : kFormat) {
    const Result<std::string> script = shippedAssets().read(std::string("obstacles/") + asked.type + ".lua");
    ASSERT_TRUE(static_cast<bool>(script)) << asked.type;
    std::istringstream words(asked.parameters);
    std::string word;
    while (words >> word) {
      const std::size_t equals = word.find('=');
      const std::string value = askedFor(*script, word.substr(0, equals));
      EXPECT_FALSE(value.empty()) << asked.type << " does not ask for " << word;
      if (equals == std::string::npos) continue;
      EXPECT_EQ(value, word.substr(equals + 1)) << asked.type << " " << word;
    }
  }
}

}  // namespace
}  // namespace brittle::sim
