#include "engine/replay/compress.h"

#include <zlib.h>

#include "engine/core/assert.h"

namespace brittle::replay {

std::vector<unsigned char> compress(std::span<const unsigned char> bytes) {
  uLongf length = compressBound(static_cast<uLong>(bytes.size()));
  std::vector<unsigned char> block(length);
  const int result =
      compress2(block.data(), &length, bytes.data(), static_cast<uLong>(bytes.size()), Z_DEFAULT_COMPRESSION);
  BR_ASSERT(result == Z_OK);
  block.resize(length);
  return block;
}

std::optional<std::vector<unsigned char>> decompress(std::span<const unsigned char> block, std::uint64_t size) {
  // Deflate stores at most 1032 bytes in one. Source: zlib, Technical Details, "Maximum Compression Factor".
  constexpr std::uint64_t largestRatio = 1032;
  if (size > largestRatio * block.size() + 64) return std::nullopt;
  std::vector<unsigned char> bytes(static_cast<std::size_t>(size) +
                                   1);  // one to spare: too long must not look like a fit
  uLongf length = static_cast<uLongf>(bytes.size());
  const int result = uncompress(bytes.data(), &length, block.data(), static_cast<uLong>(block.size()));
  if (result != Z_OK || length != size) return std::nullopt;
  bytes.resize(length);
  return bytes;
}

}  // namespace brittle::replay
