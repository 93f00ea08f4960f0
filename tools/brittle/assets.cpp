#include <filesystem>
#include <system_error>

#include "tools/brittle/game.h"

namespace brittle::program {
namespace {

/// The program lies in build/ or beside assets/: its own folder and the ones above are searched.
std::string shippedAssets() {
  std::error_code problem;
  std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", problem).parent_path();
  for (int up = 0; up < 3 && !folder.empty(); ++up, folder = folder.parent_path())
    if (std::filesystem::is_directory(folder / "assets" / "levels", problem)) return (folder / "assets").string();
  return "";
}

}  // namespace

Result<std::unique_ptr<content::AssetSource>> openAssets(const std::string& folder) {
  const std::string shipped = shippedAssets();
  std::error_code problem;
  if (!folder.empty() && !std::filesystem::is_directory(folder, problem))
    return Error{"--assets " + folder + ": no such folder, expected one with levels/, rooms/ and segments/"};
  if (folder.empty() && shipped.empty())
    return Error{"no assets found beside the program; name their folder: --assets DIR"};
  // A level pack lies before the shipped assets, whose obstacles it may use.
  std::vector<std::string> folders;
  for (const std::string& path : {folder, shipped})
    if (!path.empty()) folders.push_back(path);
  return std::unique_ptr<content::AssetSource>(std::make_unique<content::FolderSource>(std::move(folders)));
}

}  // namespace brittle::program
