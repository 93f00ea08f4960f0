#include "engine/core/file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace brittle {
namespace {

Error cannotWrite(const std::string& path, const std::string& why) {
  return errorAt(path, 0, "cannot be written: " + why);
}

Status mayReplace(const std::string& path) {
  std::error_code problem;
  const std::filesystem::file_status status = std::filesystem::status(path, problem);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) return Done{};
  return cannotWrite(path, "something that is not a file is in its place");
}

/// Writes and closes; the reason if that fails, else empty.
std::string writeTo(const std::string& path, std::span<const unsigned char> bytes) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return std::strerror(errno);
  const bool written = bytes.empty() || std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  const int problem = errno;
  const bool closed = std::fclose(file) == 0;  // a full disk may show only here
  return written && closed ? "" : std::strerror(written ? errno : problem);
}

std::string temporaryOf(const std::string& path) {
  return path + ".part";
}

}  // namespace

Result<std::string> readFile(const std::string& path, std::size_t most, const std::string& expected) {
  std::error_code problem;
  const std::filesystem::file_status status = std::filesystem::status(path, problem);
  if (!std::filesystem::exists(status)) return errorAt(path, 0, "no such file, expected " + expected);
  if (!std::filesystem::is_regular_file(status)) return errorAt(path, 0, "not a file, expected " + expected);
  const std::uintmax_t size = std::filesystem::file_size(path, problem);
  const Error tooLong = errorAt(path, 0, "too long, expected at most " + std::to_string(most) + " bytes");
  if (!problem && size > most) return tooLong;
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) return errorAt(path, 0, std::string("cannot be read: ") + std::strerror(errno));
  std::string bytes;
  if (!problem) bytes.reserve(static_cast<std::size_t>(size));
  char block[65536];
  std::size_t read = 0;
  while (bytes.size() <= most && (read = std::fread(block, 1, sizeof block, file)) > 0) bytes.append(block, read);
  const bool failed = std::ferror(file) != 0;
  std::fclose(file);
  if (failed) return errorAt(path, 0, "cannot be read");
  if (bytes.size() > most) return tooLong;
  return bytes;
}

Status writeFile(const std::string& path, std::span<const unsigned char> bytes) {
  const Status free = mayReplace(path);
  if (!free) return free;
  std::string why = writeTo(temporaryOf(path), bytes);
  std::error_code problem;
  if (why.empty()) std::filesystem::rename(temporaryOf(path), path, problem);
  if (problem) why = problem.message();
  if (why.empty()) return Done{};
  std::filesystem::remove(temporaryOf(path), problem);
  return cannotWrite(path, why);
}

Status checkWritable(const std::string& path) {
  const Status free = mayReplace(path);
  if (!free) return free;
  const std::string why = writeTo(temporaryOf(path), {});
  std::error_code problem;
  std::filesystem::remove(temporaryOf(path), problem);
  return why.empty() ? Status(Done{}) : cannotWrite(path, why);
}

}  // namespace brittle
