// replay/compress.h - zlib on blocks of memory. Knows nothing of what the bytes mean.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace brittle::replay {

std::vector<unsigned char> compress(std::span<const unsigned char> bytes);

/// The `size` bytes that were compressed, or nothing if the block is damaged or holds another number of bytes. Takes no
/// more memory than a block of that length can hold, whatever `size` claims.
std::optional<std::vector<unsigned char>> decompress(std::span<const unsigned char> block, std::uint64_t size);

}  // namespace brittle::replay
