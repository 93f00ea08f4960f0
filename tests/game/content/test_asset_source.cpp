#include "game/content/asset_source.h"

#include "content_helpers.h"

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <unistd.h>

namespace brittle::content {
namespace {

using testing::HasSubstr;

std::string gzipped(const std::string& text) {
  return archived(text, 15 + 16);
}

TEST(AssetSource, FindsNamesWithAndWithoutTheirSuffixes) {
  MemorySource source;
  source.add("a.xml", "plain");
  source.add("b.xml.mp3", "named");
  source.add("c.xml.gz", gzipped("packed"));
  source.add("d.xml.gz.mp3", gzipped("both"));
  source.add("a.xml.mp3", "shadowed");
  EXPECT_EQ(*source.read("a.xml"), "plain");
  EXPECT_EQ(*source.read("b.xml"), "named");
  EXPECT_EQ(*source.read("c.xml"), "packed");
  EXPECT_EQ(*source.read("d.xml"), "both");
  EXPECT_EQ(source.storedName("d.xml"), "d.xml.gz.mp3");
  EXPECT_FALSE(source.has("e.xml"));
  EXPECT_THAT(source.read("e.xml").error().message, HasSubstr("e.xml: there is no such file"));
}

TEST(AssetSource, NamesNeverLeadOut) {
  for (const char* name : {"", "/etc/passwd", "../secret", "a/../../b", "a//b", "./a", "a/.", "http://x/y", "user://a",
                           "c:\\x", "a\\b", "a\nb", "a/"})
    EXPECT_FALSE(isSafeName(name)) << name;
  for (const char* name : {"a", "a/b.c", "..a/b..", "segments/x y.xml"}) EXPECT_TRUE(isSafeName(name)) << name;
  EXPECT_THAT(FolderSource({kData}).read("../assets/game.xml").error().message, HasSubstr("leads out"));
}

TEST(AssetSource, LinksOutOfTheFolderAreNotFollowed) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / ("brittle_assets_" + std::to_string(::getpid()));
  fs::create_directories(folder / "in");
  std::ofstream(folder / "secret.xml") << "secret";
  std::ofstream(folder / "in" / "open.xml") << "open";
  fs::create_symlink(folder / "secret.xml", folder / "in" / "link.xml");
  fs::create_symlink(folder, folder / "in" / "up");
  const FolderSource source({(folder / "in").string()});
  EXPECT_EQ(*source.read("open.xml"), "open");
  EXPECT_FALSE(source.has("link.xml"));
  EXPECT_FALSE(source.has("up/secret.xml"));
  fs::remove_all(folder);
}

TEST(AssetSource, TheFirstFolderThatHasItCounts) {
  const FolderSource source({kData + "/levels", kData});
  EXPECT_TRUE(source.has("yard.xml"));
  EXPECT_TRUE(source.has("levels/yard.xml"));
}

TEST(AssetSource, TheFirstFolderCountsHoweverItStoresAFile) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(testing::TempDir()) / "brittle_layers";
  for (const char* layer : {"pack", "shipped"}) fs::create_directories(folder / layer);
  std::ofstream(folder / "pack/templates.xml.mp3") << "the pack's";
  std::ofstream(folder / "shipped/templates.xml") << "shipped";
  const FolderSource source({(folder / "pack").string(), (folder / "shipped").string()});
  EXPECT_EQ(*source.read("templates.xml"), "the pack's");
  fs::remove_all(folder);
}

TEST(AssetSource, ATextIsNoArchiveHoweverItBegins) {
  for (int second = 9; second < 127; ++second) {
    const std::string text = "x" + std::string(1, static_cast<char>(second)) + "= 1";
    if (second == '^') continue;  // begins like one, and no script, level or template does
    EXPECT_EQ(*unpacked(text), text) << second;
  }
}

TEST(AssetSource, DamagedArchivesAreRefused) {
  const std::string text(5000, 'x');
  const std::string packed = gzipped(text + "end");
  for (std::size_t cut = 3; cut < packed.size(); ++cut) EXPECT_FALSE(unpacked(packed.substr(0, cut))) << cut;
  std::string changed = packed;
  for (std::size_t at = 0; at < packed.size(); ++at) {
    changed[at] = static_cast<char>(changed[at] ^ 0x10);
    (void)unpacked(changed);
    changed[at] = packed[at];
  }
  EXPECT_EQ(*unpacked(packed), text + "end");
  EXPECT_THAT(unpacked(gzipped(std::string(kLongestFile + 1000, '\0'))).error().message, HasSubstr("longer than"));
}

}  // namespace
}  // namespace brittle::content
