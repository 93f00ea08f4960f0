#include "engine/replay/replay_file.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>

#include "engine/core/hash.h"
#include "engine/replay/compress.h"
#include "tests/engine/replay/toy_simulation.h"

namespace brittle::replay {
namespace {

constexpr std::uint32_t kVersion = 5;

std::string errorOf(const std::vector<unsigned char>& bytes, std::uint32_t version = kVersion) {
  const Result<Replay> result = decode(bytes, "a.brt", version);
  return result ? "" : result.error().message;
}

/// A well-formed file around a body changed on purpose: what a checksum alone cannot refuse.
std::vector<unsigned char> sealed(std::vector<unsigned char> bytes) {
  bytes.resize(bytes.size() - 8);
  const std::uint64_t body = bytes.size() - 24;
  std::memcpy(bytes.data() + 16, &body, 8);
  const std::uint64_t checksum = hashBytes(bytes.data(), bytes.size());
  bytes.resize(bytes.size() + 8);
  std::memcpy(bytes.data() + bytes.size() - 8, &checksum, 8);
  return bytes;
}

TEST(ReplayFile, WhatIsReadIsWhatWasWritten) {
  const Replay replay = toyReplay(200);
  const Result<Replay> read = decode(encode(replay), "a.brt", kVersion);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(*read, replay);
}

TEST(ReplayFile, AnEmptyGameIsAFileToo) {
  const Result<Replay> read = decode(encode(toyReplay(0)), "a.brt", kVersion);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->ticks(), 0u);
}

TEST(ReplayFile, AnHourTakesLittleMoreThanItsHashes) {
  const std::uint32_t ticks = 60 * 60 * 60;
  EXPECT_LT(encode(toyReplay(ticks, ticks)).size(), 8u * ticks + 400000u);
}

TEST(ReplayFile, OtherVersionsAreRefusedNamingBoth) {
  std::vector<unsigned char> bytes = encode(toyReplay(3));
  EXPECT_EQ(errorOf(bytes, 6),
            "a.brt: simulation version 5, this build plays version 6: play it with the build that recorded it");
  bytes[8] = 9;
  EXPECT_EQ(errorOf(bytes),
            "a.brt: format version 9, this build plays version 1: play it with the build that recorded it");
}

TEST(ReplayFile, OtherFilesAreRefused) {
  EXPECT_EQ(errorOf({}), "a.brt: empty, expected a replay");
  EXPECT_EQ(errorOf({'<', 'l', 'e', 'v', 'e', 'l', '>', '\n', '\n'}), "a.brt: not a Brittle replay");
}

bool isOneLine(const std::string& text) {
  return text.starts_with("a.brt: ") && text.find('\n') == std::string::npos;
}

TEST(ReplayFile, CutAtEveryByteItGivesOneLine) {
  const std::vector<unsigned char> bytes = encode(toyReplay(90));
  for (std::size_t length = 0; length < bytes.size(); ++length)
    ASSERT_TRUE(isOneLine(errorOf({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length)}))) << length;
}

TEST(ReplayFile, EveryFlippedBitGivesOneLine) {
  std::vector<unsigned char> bytes = encode(toyReplay(90));
  for (std::size_t i = 0; i < bytes.size(); ++i)
    for (int bit = 0; bit < 8; ++bit) {
      bytes[i] ^= static_cast<unsigned char>(1 << bit);
      ASSERT_TRUE(isOneLine(errorOf(bytes))) << i << " bit " << bit;
      bytes[i] ^= static_cast<unsigned char>(1 << bit);
    }
}

// With a matching checksum a changed byte may still be a legal file; what may not happen is a crash, a hang or a huge
// allocation.
TEST(ReplayFile, EveryChangedByteUnderARightChecksumIsReadOrRefused) {
  const std::vector<unsigned char> good = encode(toyReplay(90));
  int refused = 0;
  for (std::size_t i = 24; i + 8 < good.size(); ++i)
    for (const int value : {0x00, 0x01, 0x7f, 0xff}) {
      std::vector<unsigned char> bytes = good;
      bytes[i] = static_cast<unsigned char>(value);
      const std::string error = errorOf(sealed(bytes));
      ASSERT_TRUE(error.empty() || isOneLine(error)) << i;
      refused += error.empty() ? 0 : 1;
    }
  EXPECT_GT(refused, 100);
}

TEST(ReplayFile, CutUnderARightChecksumItIsRefused) {
  const std::vector<unsigned char> good = encode(toyReplay(90));
  for (std::size_t length = 33; length < good.size(); ++length)
    ASSERT_TRUE(isOneLine(errorOf(sealed({good.begin(), good.begin() + static_cast<std::ptrdiff_t>(length)}))))
        << length;
}

class ReplayFolder : public testing::Test {
 protected:
  void SetUp() override {
    folder = std::filesystem::temp_directory_path() / ("brittle_replay_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
  }
  void TearDown() override { std::filesystem::remove_all(folder); }
  std::filesystem::path folder;
};

TEST_F(ReplayFolder, SavesByRenamingAndLoads) {
  const std::string path = folder / "game.brt";
  ASSERT_TRUE(save(toyReplay(100), path));
  ASSERT_TRUE(save(toyReplay(120), path)) << "over an older one";
  const Result<Replay> read = load(path, kVersion);
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, toyReplay(120));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1) << "no temporary file left";
}

TEST_F(ReplayFolder, MissingFilesAndFoldersAreNamed) {
  EXPECT_EQ(load(folder / "none.brt", kVersion).error().message,
            (folder / "none.brt").string() + ": no such file, expected a replay (.brt)");
  EXPECT_FALSE(load(folder, kVersion));
  const Status status = save(toyReplay(1), folder / "none" / "a.brt");
  ASSERT_FALSE(status);
  EXPECT_TRUE(status.error().message.starts_with((folder / "none" / "a.brt").string() + ": cannot be written"));
}

TEST(Compress, RefusesWrongSizes) {
  const std::vector<unsigned char> bytes(1000, 7);
  const std::vector<unsigned char> block = compress(bytes);
  EXPECT_EQ(decompress(block, 1000), bytes);
  EXPECT_FALSE(decompress(block, 999).has_value());
  EXPECT_FALSE(decompress(block, 1001).has_value());
  EXPECT_FALSE(decompress(block, std::uint64_t{1} << 40).has_value());
  EXPECT_FALSE(decompress({}, 0).has_value());
}

}  // namespace
}  // namespace brittle::replay
