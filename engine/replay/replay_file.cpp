// The file, little-endian:
//   8 bytes  "BRITTLE" 0x1a        not text, so that nobody's editor "repairs" it
//   u32      format version
//   u32      simulation version
//   u64      length of the body
//   body     content hash u64, seed u64, mode u32, level string, settings block, ticks u32,
//            frames (packed: per tick buttons u8, throws u8, throws x i16 y i16), hashes ticks x u64,
//            snapshots u32, each tick u32 and packed bytes
//   u64      XXH64 of everything before
// "packed" is: raw size u32, block size u32, zlib block.
#include "engine/replay/replay_file.h"

#include <cstring>
#include <utility>

#include "engine/core/byte_stream.h"
#include "engine/core/file.h"
#include "engine/core/hash.h"
#include "engine/replay/compress.h"

namespace brittle::replay {
namespace {

constexpr unsigned char kMagic[8] = {'B', 'R', 'I', 'T', 'T', 'L', 'E', 0x1a};
constexpr std::size_t kHeaderSize = 8 + 4 + 4 + 8;
constexpr std::size_t kChecksumSize = 8;
constexpr std::size_t kLongestFile = 512u << 20;  // [bytes]; chosen: four hours in crowded rooms take half of it

struct Packed {
  std::uint32_t size = 0;  // before compression
  std::vector<unsigned char> block;
};

void writePacked(ByteWriter& out, std::uint32_t size, const std::vector<unsigned char>& block) {
  out.write(size);
  out.write(static_cast<std::uint32_t>(block.size()));
  out.writeBytes(block.data(), block.size());
}

Packed readPacked(ByteReader& in) {
  Packed packed;
  packed.size = in.read<std::uint32_t>();
  const auto length = in.read<std::uint32_t>();
  if (length > in.remaining()) {
    in.fail();
    return packed;
  }
  packed.block.resize(length);
  in.readBytes(packed.block.data(), length);
  return packed;
}

void writeFrames(ByteWriter& out, const std::vector<InputFrame>& frames) {
  ByteWriter raw;
  for (const InputFrame& frame : frames) {
    raw.write(frame.buttons);
    raw.write(static_cast<std::uint8_t>(frame.throws.size()));
    for (const Throw& aim : frame.throws) {
      raw.write(aim.x);
      raw.write(aim.y);
    }
  }
  writePacked(out, static_cast<std::uint32_t>(raw.bytes().size()), compress(raw.bytes()));
}

bool readFrames(ByteReader& in, std::uint32_t ticks, std::vector<InputFrame>& frames) {
  const Packed packed = readPacked(in);
  if (!in.ok()) return false;
  const auto bytes = decompress(packed.block, packed.size);
  if (!bytes || bytes->size() < 2 * static_cast<std::size_t>(ticks)) return false;  // two bytes per tick at least
  ByteReader raw(*bytes);
  frames.resize(ticks);
  for (InputFrame& frame : frames) {
    frame.buttons = raw.read<std::uint8_t>();
    const auto throws = raw.read<std::uint8_t>();
    if (throws > kMaxThrows) return false;
    frame.throws.resize(throws);
    for (Throw& aim : frame.throws) {
      aim.x = raw.read<std::int16_t>();
      aim.y = raw.read<std::int16_t>();
    }
  }
  return raw.ok() && raw.remaining() == 0;
}

bool readSnapshots(ByteReader& in, std::uint32_t ticks, std::vector<Snapshot>& snapshots) {
  const auto count = in.read<std::uint32_t>();
  std::uint32_t previous = 0;
  for (std::uint32_t i = 0; i < count && in.ok(); ++i) {
    const auto tick = in.read<std::uint32_t>();
    Packed packed = readPacked(in);
    if (!in.ok() || tick <= previous || tick > ticks || packed.size > kLongestSnapshot) return false;
    snapshots.push_back({tick, packed.size, std::move(packed.block)});
    previous = tick;
  }
  return in.ok();
}

void writeBody(ByteWriter& out, const Replay& replay) {
  out.write(replay.start.contentHash);
  out.write(replay.start.seed);
  out.write(replay.start.mode);
  out.writeString(replay.start.level);
  out.write(static_cast<std::uint32_t>(replay.start.settings.size()));
  out.writeBytes(replay.start.settings.data(), replay.start.settings.size());
  out.write(replay.ticks());
  writeFrames(out, replay.frames);
  for (const std::uint64_t hash : replay.hashes) out.write(hash);
  out.write(static_cast<std::uint32_t>(replay.snapshots.size()));
  for (const Snapshot& snapshot : replay.snapshots) {
    out.write(snapshot.tick);
    writePacked(out, snapshot.size, snapshot.block);
  }
}

bool readStart(ByteReader& in, Start& start) {
  start.contentHash = in.read<std::uint64_t>();
  start.seed = in.read<std::uint64_t>();
  start.mode = in.read<std::uint32_t>();
  start.level = in.readString(4096);
  const auto length = in.read<std::uint32_t>();
  if (length > in.remaining()) return false;
  start.settings.resize(length);
  in.readBytes(start.settings.data(), length);
  return in.ok();
}

/// What is wrong with the body in a few words, or nothing.
const char* readBody(ByteReader& in, Replay& replay) {
  if (!readStart(in, replay.start)) return "the start state";
  const auto ticks = in.read<std::uint32_t>();
  if (!in.ok() || ticks > kMaxTicks) return "the number of ticks";
  if (!readFrames(in, ticks, replay.frames)) return "the input frames";
  if (in.remaining() < 8 * static_cast<std::size_t>(ticks)) return "the state hashes";
  replay.hashes.resize(ticks);
  for (std::uint64_t& hash : replay.hashes) hash = in.read<std::uint64_t>();
  if (!readSnapshots(in, ticks, replay.snapshots)) return "the snapshots";
  return in.remaining() == 0 ? nullptr : "its end: bytes are left over";
}

Error wrongVersion(const std::string& name, const char* what, std::uint32_t found, std::uint32_t ours) {
  return errorAt(name, 0,
                 std::string(what) + " version " + std::to_string(found) + ", this build plays version " +
                     std::to_string(ours) + ": play it with the build that recorded it");
}

}  // namespace

std::vector<unsigned char> encode(const Replay& replay) {
  ByteWriter body;
  writeBody(body, replay);
  ByteWriter out;
  out.writeBytes(kMagic, sizeof kMagic);
  out.write(kFormatVersion);
  out.write(replay.start.simulationVersion);
  out.write(static_cast<std::uint64_t>(body.bytes().size()));
  out.writeBytes(body.bytes().data(), body.bytes().size());
  out.write(hashBytes(out.bytes().data(), out.bytes().size()));
  return out.bytes();
}

Result<Replay> decode(std::span<const unsigned char> bytes, const std::string& name, std::uint32_t simulationVersion) {
  if (bytes.empty()) return errorAt(name, 0, "empty, expected a replay");
  if (bytes.size() < sizeof kMagic || std::memcmp(bytes.data(), kMagic, sizeof kMagic) != 0)
    return errorAt(name, 0, "not a Brittle replay");
  ByteReader header(bytes.subspan(sizeof kMagic));
  const auto format = header.read<std::uint32_t>();
  const auto simulation = header.read<std::uint32_t>();
  const auto length = header.read<std::uint64_t>();
  if (!header.ok())
    return errorAt(name, 0, "cut short: " + std::to_string(bytes.size()) + " bytes do not hold a header");
  if (format != kFormatVersion) return wrongVersion(name, "format", format, kFormatVersion);
  if (simulation != simulationVersion) return wrongVersion(name, "simulation", simulation, simulationVersion);
  const std::uint64_t present = bytes.size() - kHeaderSize;
  if (present < kChecksumSize || length != present - kChecksumSize)
    return errorAt(name, 0,
                   "cut short or damaged: a body of " + std::to_string(length) + " bytes is announced, " +
                       std::to_string(present) + " bytes follow, its checksum of 8 included");
  ByteReader tail(bytes.last(kChecksumSize));
  if (tail.read<std::uint64_t>() != hashBytes(bytes.data(), bytes.size() - kChecksumSize))
    return errorAt(name, 0, "damaged: its checksum does not match its bytes");
  Replay replay;
  replay.start.simulationVersion = simulation;
  ByteReader in(bytes.subspan(kHeaderSize, static_cast<std::size_t>(length)));
  if (const char* wrong = readBody(in, replay)) return errorAt(name, 0, std::string("damaged in ") + wrong);
  return replay;
}

Status save(const Replay& replay, const std::string& path) {
  return writeFile(path, encode(replay));
}

Result<Replay> load(const std::string& path, std::uint32_t simulationVersion) {
  const Result<std::string> bytes = readFile(path, kLongestFile, "a replay (.brt)");
  if (!bytes) return bytes.error();
  return decode({reinterpret_cast<const unsigned char*>(bytes->data()), bytes->size()}, path, simulationVersion);
}

}  // namespace brittle::replay
