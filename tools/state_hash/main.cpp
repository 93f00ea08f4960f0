// state_hash: one hash per line of what must be the same on every compiler and processor. tools/cross_hash compares
// builds.
#include <cstdio>

#include "tools/state_hash/sections.h"

int main() {
  std::vector<brittle::Line> lines;
  brittle::addMath(lines);
  brittle::addGeometry(lines);
  brittle::addPhysics(lines);
  for (const brittle::Line& line : lines)
    std::printf("%-28s %016llx\n", line.name.c_str(), static_cast<unsigned long long>(line.hash));
  return 0;
}
