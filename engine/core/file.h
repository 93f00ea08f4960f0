// core/file.h - whole files in and out. What is read may be missing, too long or no file at all; what is written is
// there as a whole or not at all.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "engine/core/result.h"

namespace brittle {

/// All bytes of the regular file at `path`, at most `most`. `expected` completes the message: "a replay (.brt)".
Result<std::string> readFile(const std::string& path, std::size_t most, const std::string& expected);

/// Writes to a temporary name beside `path`, then renames: neither a full disk nor a crash leaves half a file under the
/// final name. Refuses to replace what is no regular file (a folder, a device).
Status writeFile(const std::string& path, std::span<const unsigned char> bytes);

/// Whether writeFile would work there now: for long work whose result must not be lost. Leaves nothing behind.
Status checkWritable(const std::string& path);

}  // namespace brittle
