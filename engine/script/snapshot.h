// script/snapshot.h - what a saved script state consists of. What a script can reach is a graph of tables and
// functions. Functions are code: a number stands for one (numbering.h), and what is saved of it are the variables it
// shares with others (its upvalues). Tables are written breadth first, each once, keys in order, so the bytes depend on
// the contents alone and may be hashed. Internal to engine/script: saver.cpp, restorer.cpp.
#pragma once

#include <cstdint>

namespace brittle::script {

inline constexpr std::uint32_t kSnapshotFormat = 0x53524232;  // "BRS2"

/// Before each value: what follows.
enum class Tag : std::uint8_t { Nil, False, True, Number, Text, Table, Numbered };

}  // namespace brittle::script
