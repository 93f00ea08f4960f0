// core/archive.h - one description of a struct serves saving, restoring and hashing: `template <class A> void
// serialize(A& a) { a(x); a(y); }`. So a snapshot and the state hash can never cover different things.
#pragma once

#include <cstdint>
#include <type_traits>
#include <vector>

#include "engine/core/byte_stream.h"
#include "engine/core/hash.h"

namespace brittle {

namespace archive_detail {
template <class T>
concept Number = std::is_arithmetic_v<T> || std::is_enum_v<T>;
template <class T>
concept FixedMatrix = requires(T& v) {  // Eigen vectors and matrices
  T::SizeAtCompileTime;
  v.data();
};
template <class T>
concept Quaternion = requires(T& v) {
  v.coeffs().data();
};
}  // namespace archive_detail

/// How many bytes a value takes at least when it is saved. [bytes]
template <class T>
std::size_t leastSaved();

/// Walks over structs, vectors, fixed matrices and numbers; Derived handles numbers and vector sizes.
template <class Derived>
class Archive {
 public:
  template <class T>
  void operator()(T& value) {
    if constexpr (archive_detail::Number<T>) {
      self().number(value);
    } else if constexpr (archive_detail::Quaternion<T>) {
      for (int i = 0; i < 4; ++i) self().number(value.coeffs().data()[i]);
    } else if constexpr (archive_detail::FixedMatrix<T>) {
      for (int i = 0; i < static_cast<int>(T::SizeAtCompileTime); ++i) self().number(value.data()[i]);
    } else if constexpr (std::is_array_v<T>) {
      for (auto& element : value) (*this)(element);
    } else {
      value.serialize(self());
    }
  }
  template <class T>
  void vector(std::vector<T>& values) {
    self().resize(values, leastSaved<T>());
    for (T& value : values) (*this)(value);
  }

 private:
  Derived& self() { return static_cast<Derived&>(*this); }
};

class SaveArchive : public Archive<SaveArchive> {
 public:
  explicit SaveArchive(ByteWriter& out) : out_(out) {}
  template <class T>
  void number(T& value) {
    out_.write(value);
  }
  template <class T>
  void resize(std::vector<T>& values, std::size_t, std::size_t = 0) {
    out_.write(static_cast<std::uint32_t>(values.size()));
  }

 private:
  ByteWriter& out_;
};

class RestoreArchive : public Archive<RestoreArchive> {
 public:
  explicit RestoreArchive(ByteReader& in) : in_(in) {}
  template <class T>
  void number(T& value) {
    value = in_.template read<T>();
  }
  /// A size that the remaining bytes cannot hold, at `least` bytes for each, or that is above `most` makes the reader
  /// bad and the vector empty: what is allocated is a small multiple of the bytes there are, or bounded.
  template <class T>
  void resize(std::vector<T>& values, std::size_t least, std::size_t most = ~std::size_t{0}) {
    const auto size = in_.read<std::uint32_t>();
    if (size > in_.remaining() / least || size > most) {
      in_.fail();
      values.clear();
      return;
    }
    values.resize(size);
  }
  bool ok() const { return in_.ok(); }

 private:
  ByteReader& in_;
};

class HashArchive : public Archive<HashArchive> {
 public:
  template <class T>
  void number(T& value) {
    if constexpr (std::is_floating_point_v<T>) {
      hash_.add(value);
    } else if constexpr (sizeof(T) == 8) {
      hash_.add(static_cast<std::uint64_t>(value));
    } else {
      hash_.add(static_cast<std::uint32_t>(value));
    }
  }
  template <class T>
  void resize(std::vector<T>& values, std::size_t, std::size_t = 0) {
    hash_.add(static_cast<std::uint32_t>(values.size()));
  }
  std::uint64_t value() const { return hash_.value(); }

 private:
  StateHash hash_;
};

class SizeArchive : public Archive<SizeArchive> {
 public:
  template <class T>
  void number(T&) {
    size_ += sizeof(T);
  }
  template <class T>
  void resize(std::vector<T>&, std::size_t, std::size_t = 0) {
    size_ += sizeof(std::uint32_t);
  }
  std::size_t size() const { return size_; }

 private:
  std::size_t size_ = 0;
};

/// That of a default one: its lists are empty.
template <class T>
std::size_t leastSaved() {
  static const std::size_t least = [] {
    T value{};
    SizeArchive size;
    size(value);
    return size.size();
  }();
  return least;
}

}  // namespace brittle
