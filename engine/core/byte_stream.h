// core/byte_stream.h - little-endian bytes in and out, for replays and snapshots. A reader never reads beyond its end:
// it goes bad, returns zeroes from then on, and its user asks `ok()` once.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace brittle {

class ByteWriter {
 public:
  /// Any number, bool or enum; floats by their bits.
  template <class T>
  void write(T value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    unsigned char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    bytes_.insert(bytes_.end(), raw, raw + sizeof(T));
  }
  void writeBytes(const void* data, std::size_t size) {
    const auto* first = static_cast<const unsigned char*>(data);
    bytes_.insert(bytes_.end(), first, first + size);
  }
  void writeString(const std::string& text) {
    write(static_cast<std::uint32_t>(text.size()));
    writeBytes(text.data(), text.size());
  }
  const std::vector<unsigned char>& bytes() const { return bytes_; }
  void clear() { bytes_.clear(); }

 private:
  std::vector<unsigned char> bytes_;
};

class ByteReader {
 public:
  explicit ByteReader(std::span<const unsigned char> bytes) : bytes_(bytes) {}

  template <class T>
  T read() {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    T value{};
    if constexpr (std::is_same_v<T, bool>) {
      return read<unsigned char>() != 0;
    } else {
      readBytes(&value, sizeof(T));
    }
    return value;
  }
  void readBytes(void* data, std::size_t size) {
    if (size > remaining()) {
      ok_ = false;
      std::memset(data, 0, size);
      return;
    }
    if (size == 0) return;
    std::memcpy(data, bytes_.data() + position_, size);
    position_ += size;
  }
  /// Empty, and bad, if the length it starts with is beyond the end or above `longest`.
  std::string readString(std::size_t longest = 1 << 20) {
    const auto size = read<std::uint32_t>();
    if (size > longest || size > remaining()) {
      ok_ = false;
      return {};
    }
    std::string text(size, '\0');
    readBytes(text.data(), size);
    return text;
  }
  bool ok() const { return ok_; }
  void fail() { ok_ = false; }
  std::size_t position() const { return position_; }
  std::size_t remaining() const { return ok_ ? bytes_.size() - position_ : 0; }

 private:
  std::span<const unsigned char> bytes_;
  std::size_t position_ = 0;
  bool ok_ = true;
};

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "replays and snapshots are little-endian");

}  // namespace brittle
