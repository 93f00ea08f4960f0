#include "engine/audio/wav.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/audio/clip.h"
#include "engine/core/file.h"
#include "engine/math/types.h"

namespace brittle::audio {
namespace {

constexpr std::uint32_t kChannels = 2, kBytesPerSample = 2;
constexpr std::uint64_t kMostBytes = 0xffffff00u;  // sizes in the header have 32 bits

void put(std::vector<std::uint8_t>& out, const char* tag) {
  out.insert(out.end(), tag, tag + 4);
}
void put(std::vector<std::uint8_t>& out, std::uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

}  // namespace

Result<WavWriter> WavWriter::open(const std::string& path) {
  const Status writable = checkWritable(path);
  if (!writable) return writable.error();
  std::FILE* file = std::fopen((path + ".part").c_str(), "wb");
  if (file == nullptr) return Error{path + ": cannot be written: " + std::strerror(errno)};
  WavWriter writer(path, file);
  writer.writeHeader();
  return writer;
}

WavWriter::WavWriter(WavWriter&& other) noexcept
    : path_(std::move(other.path_)),
      file_(std::exchange(other.file_, nullptr)),
      dataBytes_(other.dataBytes_),
      failed_(other.failed_) {}

WavWriter::~WavWriter() {
  if (file_ == nullptr) return;
  std::fclose(file_);
  std::error_code ignored;
  std::filesystem::remove(partPath(), ignored);
}

void WavWriter::writeHeader() {
  std::vector<std::uint8_t> header;
  put(header, "RIFF");
  put(header, static_cast<std::uint32_t>(36 + dataBytes_), 4);
  put(header, "WAVE");
  put(header, "fmt ");
  put(header, 16, 4);
  put(header, 1, 2);  // PCM
  put(header, kChannels, 2);
  put(header, kSampleRate, 4);
  put(header, kSampleRate * kChannels * kBytesPerSample, 4);
  put(header, kChannels * kBytesPerSample, 2);
  put(header, 8 * kBytesPerSample, 2);
  put(header, "data");
  put(header, static_cast<std::uint32_t>(dataBytes_), 4);
  if (std::fwrite(header.data(), 1, header.size(), file_) != header.size()) failed_ = true;
}

void WavWriter::write(std::span<const float> samples) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(samples.size() * kBytesPerSample);
  for (const float sample : samples) {
    const float scaled = clampTo(sample, -1.0f, 1.0f) * 32767.0f;
    const auto rounded = static_cast<std::int32_t>(scaled < 0.0f ? scaled - 0.5f : scaled + 0.5f);
    put(bytes, static_cast<std::uint32_t>(rounded), 2);
  }
  dataBytes_ += bytes.size();
  if (dataBytes_ > kMostBytes || std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) failed_ = true;
}

Status WavWriter::close() {
  if (std::fseek(file_, 0, SEEK_SET) != 0) failed_ = true;
  if (!failed_) writeHeader();
  std::error_code problem;
  if (std::fclose(std::exchange(file_, nullptr)) != 0 || failed_) {
    std::filesystem::remove(partPath(), problem);
    return Error{path_ + ": writing stopped half-way, is the disk full?"};
  }
  std::filesystem::rename(partPath(), path_, problem);
  if (!problem) return Done{};
  const std::string reason = problem.message();
  std::filesystem::remove(partPath(), problem);
  return Error{path_ + ": cannot be replaced: " + reason};
}

}  // namespace brittle::audio
