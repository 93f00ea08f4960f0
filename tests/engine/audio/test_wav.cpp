#include "engine/audio/wav.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

namespace brittle::audio {
namespace {

const std::string kFolder = BRITTLE_BINARY_DIR "/test_wav";

std::vector<unsigned char> bytesOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

template <class Number>
Number at(const std::vector<unsigned char>& bytes, std::size_t place) {
  Number number;
  std::memcpy(&number, bytes.data() + place, sizeof number);
  return number;
}

class Wav : public ::testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::remove_all(kFolder);
    std::filesystem::create_directories(kFolder);
  }
};

TEST_F(Wav, HasAHeaderOf44BytesAndRoundedSamples) {
  const std::string path = kFolder + "/a.wav";
  Result<WavWriter> file = WavWriter::open(path);
  ASSERT_TRUE(file);
  const float samples[] = {0.0f, 1.0f, -1.0f, 0.5f, 3.0f, -3.0f};
  file->write(samples);
  EXPECT_FALSE(std::filesystem::exists(path)) << "half-written";
  ASSERT_TRUE(file->close());
  const std::vector<unsigned char> bytes = bytesOf(path);
  ASSERT_EQ(bytes.size(), 44u + 12u);
  EXPECT_EQ(std::memcmp(bytes.data(), "RIFF", 4), 0);
  EXPECT_EQ(std::memcmp(bytes.data() + 8, "WAVEfmt ", 8), 0);
  EXPECT_EQ(at<std::uint32_t>(bytes, 4), 36u + 12u);
  EXPECT_EQ(at<std::uint16_t>(bytes, 22), 2u);
  EXPECT_EQ(at<std::uint32_t>(bytes, 24), 48000u);
  EXPECT_EQ(at<std::uint32_t>(bytes, 28), 192000u);
  EXPECT_EQ(at<std::uint32_t>(bytes, 40), 12u);
  const std::int16_t expected[] = {0, 32767, -32767, 16384, 32767, -32767};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(at<std::int16_t>(bytes, 44 + 2 * i), expected[i]);
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
}

TEST_F(Wav, LeavesNothingWhenItIsNotClosed) {
  { ASSERT_TRUE(WavWriter::open(kFolder + "/b.wav")); }
  EXPECT_TRUE(std::filesystem::is_empty(kFolder));
}

TEST_F(Wav, SaysWhereItCannotWrite) {
  const Result<WavWriter> file = WavWriter::open(kFolder + "/none/c.wav");
  ASSERT_FALSE(file);
  EXPECT_NE(file.error().message.find("none/c.wav: cannot be written: No such file"), std::string::npos)
      << file.error().message;
}

}  // namespace
}  // namespace brittle::audio
