#include "engine/render/capture.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace brittle::render {
namespace {

Image gradient(int width, int height) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint8_t pixel[4] = {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 77, 255};
      image.pixels.insert(image.pixels.end(), pixel, pixel + 4);
    }
  }
  return image;
}

std::string temporaryFolder(const std::string& name) {
  const std::string path = ::testing::TempDir() + "brittle_capture_" + name;
  std::filesystem::remove_all(path);
  std::filesystem::create_directories(path);
  return path;
}

TEST(Capture, WritesWhatItReads) {
  const std::string folder = temporaryFolder("round");
  const Image image = gradient(61, 33);
  ASSERT_TRUE(writePng(image, folder + "/a.png"));
  const Result<Image> back = readPng(folder + "/a.png");
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->pixels, image.pixels);
}

TEST(Capture, LeavesOnlyTheFinishedFile) {
  const std::string folder = temporaryFolder("alone");
  ASSERT_TRUE(writePng(gradient(8, 8), folder + "/a.png"));
  ASSERT_TRUE(writePng(gradient(9, 9), folder + "/a.png"));  // replaces
  int files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder)) ++files;
  EXPECT_EQ(files, 1);
  EXPECT_EQ(readPng(folder + "/a.png")->width, 9);
}

TEST(Capture, SaysWhichPathCannotBeWrittenAndWhy) {
  const Status status = writePng(gradient(4, 4), "/nowhere/at/all/a.png");
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().message, "/nowhere/at/all/a.png: cannot be written: No such file or directory");
  EXPECT_FALSE(writePng(Image{}, temporaryFolder("empty") + "/a.png"));
}

TEST(Capture, KeepsTheOldFileWhenThePlaceIsAFolder) {
  const std::string folder = temporaryFolder("folder");
  std::filesystem::create_directories(folder + "/a.png/full");
  const Status status = writePng(gradient(4, 4), folder + "/a.png");
  ASSERT_FALSE(status);
  EXPECT_NE(status.error().message.find("cannot be written"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder + "/a.png.part"));
}

TEST(Capture, RefusesWhatIsNoPng) {
  const std::string folder = temporaryFolder("bad");
  std::ofstream(folder + "/a.png") << "not a picture";
  EXPECT_FALSE(readPng(folder + "/a.png"));
  EXPECT_FALSE(readPng(folder + "/missing.png"));
}

TEST(Capture, MeasuresLargestAndMeanDifference) {
  Image a = gradient(10, 10), b = a;
  EXPECT_EQ(compare(a, b).largest, 0);
  b.pixels[4] = static_cast<std::uint8_t>(b.pixels[4] + 30);
  b.pixels[7] = 0;  // alpha does not count
  EXPECT_EQ(compare(a, b).largest, 30);
  EXPECT_NEAR(compare(a, b).mean, 30.0 / 300.0, 1e-12);
  EXPECT_EQ(compare(a, gradient(9, 10)).largest, 255);
}

}  // namespace
}  // namespace brittle::render
