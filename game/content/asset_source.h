// content/asset_source.h - where content is read from: names like "segments/a/b.xml" in, bytes out. The community
// stores every file with an extra .mp3, segments also gzipped before that: a name finds NAME, NAME.mp3, NAME.gz and
// NAME.gz.mp3, in this order. No name leads out of the source: names with .., a drive, a scheme (http:, user:) or a
// leading / count as not there.
#pragma once

#include "engine/core/result.h"

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace brittle::content {

/// No file of a level is longer once unpacked [bytes].
inline constexpr std::size_t kLongestFile = 8u << 20;

class AssetSource {
 public:
  virtual ~AssetSource() = default;
  /// The contents of `name`, unpacked. Fails if it is not there, too long, or a damaged archive.
  Result<std::string> read(const std::string& name) const;
  /// The same as it is stored, archive or not: for formats that are archives themselves.
  Result<std::string> readStored(const std::string& name) const;
  bool has(const std::string& name) const;
  /// The name under which `name` is stored, suffixes included; empty if it is not there.
  std::string storedName(const std::string& name) const;

 protected:
  /// The bytes as stored under exactly this name, or nothing.
  virtual std::optional<std::string> bytes(const std::string& stored) const = 0;
  /// Likewise of a name that leads nowhere else.
  virtual std::string find(const std::string& name) const = 0;
};

/// Folders, searched in the order given, under whatever name they store a file: a level pack before the assets it
/// builds on.
class FolderSource : public AssetSource {
 public:
  explicit FolderSource(std::vector<std::string> folders) : folders_(std::move(folders)) {}

 protected:
  std::optional<std::string> bytes(const std::string& stored) const override;
  std::string find(const std::string& name) const override;

 private:
  std::string pathOf(const std::string& stored) const;
  std::vector<std::string> folders_;
};

/// Files held in memory: for tests and built-in scenes.
class MemorySource : public AssetSource {
 public:
  void add(const std::string& name, std::string contents) { files_[name] = std::move(contents); }

 protected:
  std::optional<std::string> bytes(const std::string& stored) const override;
  std::string find(const std::string& name) const override;

 private:
  std::map<std::string, std::string> files_;
};

/// Whether a name may be looked up at all: relative, forward slashes, no `.` or `..` parts, no colon, no control
/// characters.
bool isSafeName(const std::string& name);
/// A name without what the store adds to it: .mp3, .gz.
std::string bareName(std::string stored);
/// Whether bytes begin as a gzip archive does.
bool isGzip(const std::string& bytes);
/// What a gzip or zlib archive (RFC 1952, RFC 1950) holds; fails if it is none, damaged, or longer than kLongestFile.
Result<std::string> inflated(const std::string& archive);
/// The same, and bytes that do not begin like an archive come back as they are.
Result<std::string> unpacked(const std::string& bytes);

}  // namespace brittle::content
