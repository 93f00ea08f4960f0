// Any bytes as a replay, or as the body of one whose header and checksum are right: refused with one line, or read to
// what writes the same bytes again.
#include <cstring>
#include <vector>

#include "engine/core/assert.h"
#include "engine/core/byte_stream.h"
#include "engine/core/hash.h"
#include "engine/replay/replay_file.h"
#include "tests/fuzz/target.h"

namespace {

using namespace brittle;

constexpr unsigned char kMagic[8] = {'B', 'R', 'I', 'T', 'T', 'L', 'E', 0x1a};
constexpr std::uint32_t kSimulationVersion = 1;

std::vector<unsigned char> asBody(const std::uint8_t* data, std::size_t size) {
  ByteWriter out;
  out.writeBytes(kMagic, sizeof kMagic);
  out.write(replay::kFormatVersion);
  out.write(kSimulationVersion);
  out.write(static_cast<std::uint64_t>(size));
  out.writeBytes(data, size);
  out.write(hashBytes(out.bytes().data(), out.bytes().size()));
  return out.bytes();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const bool isFile = size >= sizeof kMagic && std::memcmp(data, kMagic, sizeof kMagic) == 0;
  const std::vector<unsigned char> bytes = isFile ? std::vector<unsigned char>(data, data + size) : asBody(data, size);
  const Result<replay::Replay> read = replay::decode(bytes, "fuzz.brt", kSimulationVersion);
  if (!read) {
    BR_ASSERT(!read.error().message.empty() && read.error().message.find('\n') == std::string::npos);
    return 0;
  }
  for (const replay::Snapshot& snapshot : read->snapshots) (void)snapshot.bytes();
  const Result<replay::Replay> again = replay::decode(replay::encode(*read), "again.brt", kSimulationVersion);
  BR_ASSERT(again && *again == *read);
  return 0;
}
