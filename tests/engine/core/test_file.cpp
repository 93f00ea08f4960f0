#include "engine/core/file.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace brittle {
namespace {

namespace fs = std::filesystem;

class File : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) / "brittle_file";
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  static Status write(const std::string& path, const std::string& text) {
    return writeFile(path, {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
  }
  std::size_t count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  fs::path folder_;
};

TEST_F(File, ReadsWhatWasWrittenLast) {
  const std::string long_(200'000, 'x');
  ASSERT_TRUE(write(at("a"), "older"));
  ASSERT_TRUE(write(at("a"), long_));
  EXPECT_EQ(*readFile(at("a"), 200'000, "a text"), long_);
  ASSERT_TRUE(write(at("a"), ""));
  EXPECT_EQ(*readFile(at("a"), 0, "a text"), "");
  EXPECT_EQ(count(), 1u);
}

TEST_F(File, SaysWhyItCannotBeRead) {
  ASSERT_TRUE(write(at("a"), "four"));
  EXPECT_EQ(readFile(at("none"), 9, "a text").error().message, at("none") + ": no such file, expected a text");
  EXPECT_EQ(readFile(folder_, 9, "a text").error().message, folder_.string() + ": not a file, expected a text");
  EXPECT_EQ(readFile("/dev/zero", 9, "a text").error().message, "/dev/zero: not a file, expected a text");
  EXPECT_EQ(readFile(at("a"), 3, "a text").error().message, at("a") + ": too long, expected at most 3 bytes");
  EXPECT_TRUE(readFile(at("a"), 4, "a text"));
}

TEST_F(File, KeepsWhatIsThereWhenItCannotBeReplaced) {
  fs::create_directories(at("folder"));
  for (const std::string& path : {at("folder"), std::string("/dev/null"), at("none/b")}) {
    const Status status = write(path, "text");
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().message.find(path + ": cannot be written: "), 0u) << status.error().message;
    EXPECT_EQ(checkWritable(path).error().message, status.error().message) << "the check foretells it";
  }
  EXPECT_TRUE(fs::is_directory(at("folder")));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_EQ(count(), 1u);
}

TEST_F(File, ALongWorkMayAskFirst) {
  EXPECT_TRUE(checkWritable(at("new")));
  EXPECT_EQ(count(), 0u);
  ASSERT_TRUE(write(at("old"), "text"));
  EXPECT_TRUE(checkWritable(at("old")));
  EXPECT_EQ(*readFile(at("old"), 9, "a text"), "text");
}

}  // namespace
}  // namespace brittle
