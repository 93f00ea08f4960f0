// state_hash/sections.h - named hashes over the simulation's layers, lowest first: the first line that differs names
// the layer at fault.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace brittle {

struct Line {
  std::string name;
  std::uint64_t hash = 0;
};

/// Random streams, trigonometry, transforms, SIMD lanes.
void addMath(std::vector<Line>& lines);
/// Cuts, mass properties, hulls, breaking.
void addGeometry(std::vector<Line>& lines);
/// A scene of 600 ticks.
void addPhysics(std::vector<Line>& lines);

}  // namespace brittle
