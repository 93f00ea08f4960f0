// state_hash: one hash per line of what must be the same on every compiler and processor. tools/cross_hash compares
// builds.
#include <cstdio>
#include <string_view>

#include "tools/state_hash/sections.h"

int main(int argc, char** argv) {
  if (argc > 1) {
    const bool isHelp = std::string_view(argv[1]) == "--help" || std::string_view(argv[1]) == "-h";
    if (!isHelp) std::fprintf(stderr, "state_hash: no argument '%s'\n", argv[1]);
    std::fprintf(
        isHelp ? stdout : stderr,
        "usage: state_hash\nPrints a hash per layer of the simulation and second of a scene: the same lines on "
        "every compiler and processor.\nThe first line that differs names the layer at fault (tools/cross_hash "
        "compares builds).\n");
    return isHelp ? 0 : 2;
  }
  std::vector<brittle::Line> lines;
  brittle::addMath(lines);
  brittle::addGeometry(lines);
  brittle::addPhysics(lines);
  for (const brittle::Line& line : lines)
    std::printf("%-28s %016llx\n", line.name.c_str(), static_cast<unsigned long long>(line.hash));
  return 0;
}
