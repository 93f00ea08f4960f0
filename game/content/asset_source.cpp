#include "game/content/asset_source.h"

#include "engine/core/file.h"

#include <filesystem>
#include <zlib.h>

namespace brittle::content {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSuffixes[] = {"", ".mp3", ".gz", ".gz.mp3"};

/// Links may lead anywhere: what a name resolves to must lie in the folder itself.
bool liesWithin(const fs::path& path, const fs::path& folder) {
  std::error_code failed;
  const fs::path real = fs::canonical(path, failed);
  if (failed) return false;
  const fs::path root = fs::canonical(folder, failed);
  if (failed) return false;
  const fs::path relative = real.lexically_relative(root);
  return !relative.empty() && *relative.begin() != "..";
}

/// Of a file that lies there; else empty.
std::string pathIn(const std::string& folder, const std::string& stored) {
  std::error_code failed;
  const fs::path path = fs::path(folder) / stored;
  return fs::is_regular_file(path, failed) && liesWithin(path, folder) ? path.string() : std::string();
}

}  // namespace

bool isSafeName(const std::string& name) {
  if (name.empty() || name.size() > 1000 || name.front() == '/') return false;
  for (const char c : name)
    if (c == '\\' || c == ':' || static_cast<unsigned char>(c) < 32) return false;
  std::size_t start = 0;
  while (start <= name.size()) {
    const std::size_t end = name.find('/', start);
    const std::string part = name.substr(start, end == std::string::npos ? end : end - start);
    if (part.empty() || part == "." || part == "..") return false;
    if (end == std::string::npos) break;
    start = end + 1;
  }
  return true;
}

std::string bareName(std::string stored) {
  for (const std::string_view suffix : {".mp3", ".gz"})
    if (stored.ends_with(suffix)) stored.erase(stored.size() - suffix.size());
  return stored;
}

bool isGzip(const std::string& bytes) {
  return bytes.size() > 2 && bytes[0] == '\x1f' && bytes[1] == '\x8b';
}

Result<std::string> inflated(const std::string& archive) {
  z_stream stream{};
  if (inflateInit2(&stream, 15 + 32) != Z_OK) return Error{"cannot start to unpack"};
  stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(archive.data()));
  stream.avail_in = static_cast<uInt>(archive.size());
  std::string out;
  char block[16384];
  int status = Z_OK;
  while (status == Z_OK && out.size() <= kLongestFile) {
    stream.next_out = reinterpret_cast<Bytef*>(block);
    stream.avail_out = sizeof(block);
    status = inflate(&stream, Z_NO_FLUSH);
    out.append(block, sizeof(block) - stream.avail_out);
  }
  inflateEnd(&stream);
  if (out.size() > kLongestFile) return Error{"longer than " + std::to_string(kLongestFile) + " bytes once unpacked"};
  if (status != Z_STREAM_END) return Error{"a damaged or cut archive"};
  return out;
}

Result<std::string> unpacked(const std::string& bytes) {
  constexpr char dictionary = 0x20;  // a flag that no file has, but a text that begins "x "
  const bool isZlib = bytes.size() > 2 && bytes[0] == '\x78' && (bytes[1] & dictionary) == 0 &&
                      (static_cast<unsigned char>(bytes[0]) * 256u + static_cast<unsigned char>(bytes[1])) % 31u == 0;
  if (!isGzip(bytes) && !isZlib) return bytes;
  return inflated(bytes);
}

std::string AssetSource::storedName(const std::string& name) const {
  return isSafeName(name) ? find(name) : std::string();
}

bool AssetSource::has(const std::string& name) const {
  return !storedName(name).empty();
}

Result<std::string> AssetSource::readStored(const std::string& name) const {
  const std::string stored = storedName(name);
  if (stored.empty())
    return errorAt(name, 0, isSafeName(name) ? "there is no such file" : "this name leads out of the assets");
  const std::optional<std::string> raw = bytes(stored);
  if (!raw) return errorAt(stored, 0, "cannot be read, or is longer than " + std::to_string(kLongestFile) + " bytes");
  return *raw;
}

Result<std::string> AssetSource::read(const std::string& name) const {
  const Result<std::string> raw = readStored(name);
  if (!raw) return raw;
  Result<std::string> contents = unpacked(*raw);
  if (!contents) return errorAt(storedName(name), 0, contents.error().message);
  return contents;
}

std::string FolderSource::find(const std::string& name) const {
  for (const std::string& folder : folders_)
    for (const char* suffix : kSuffixes)
      if (!pathIn(folder, name + suffix).empty()) return name + suffix;
  return {};
}

std::string FolderSource::pathOf(const std::string& stored) const {
  for (const std::string& folder : folders_)
    if (const std::string path = pathIn(folder, stored); !path.empty()) return path;
  return {};
}

std::optional<std::string> FolderSource::bytes(const std::string& stored) const {
  const std::string path = pathOf(stored);
  const Result<std::string> read = path.empty() ? Error{} : readFile(path, kLongestFile, "content");
  return read ? std::optional<std::string>(*read) : std::nullopt;
}

std::string MemorySource::find(const std::string& name) const {
  for (const char* suffix : kSuffixes)
    if (files_.contains(name + suffix)) return name + suffix;
  return {};
}

std::optional<std::string> MemorySource::bytes(const std::string& stored) const {
  const auto found = files_.find(stored);
  return found == files_.end() ? std::nullopt : std::optional<std::string>(found->second);
}

}  // namespace brittle::content
