#include "engine/core/byte_stream.h"

#include <gtest/gtest.h>

#include "engine/core/archive.h"
#include "engine/math/types.h"

namespace brittle {
namespace {

enum class Kind : std::uint8_t { None, Ball };

struct Inner {
  float weight = 0.0f;
  Kind kind = Kind::None;
  template <class A>
  void serialize(A& a) {
    a(weight);
    a(kind);
  }
  bool operator==(const Inner&) const = default;
};

struct Outer {
  std::uint64_t seed = 0;
  bool on = false;
  std::int16_t pair[2] = {0, 0};
  std::vector<Inner> inner;
  Vec3 point = Vec3::Zero();
  Quat turn = Quat::Identity();
  double time = 0.0;
  template <class A>
  void serialize(A& a) {
    a(seed);
    a(on);
    a(pair);
    a.vector(inner);
    a(point);
    a(turn);
    a(time);
  }
};

Outer example() {
  Outer outer;
  outer.seed = 0x123456789abcdef0ull;
  outer.on = true;
  outer.pair[0] = -7, outer.pair[1] = 30000;
  outer.inner = {{1.5f, Kind::Ball}, {-2.0f, Kind::None}, {0.0f, Kind::Ball}};
  outer.point = Vec3(1.0f, 2.0f, 3.0f);
  outer.turn = Quat(0.5f, 0.5f, -0.5f, 0.5f);
  outer.time = 12.25;
  return outer;
}

std::vector<unsigned char> saved(Outer outer) {
  ByteWriter out;
  SaveArchive save(out);
  save(outer);
  return out.bytes();
}

std::uint64_t hashed(Outer outer) {
  HashArchive hash;
  hash(outer);
  return hash.value();
}

TEST(Archive, WhatIsRestoredIsWhatWasSaved) {
  const std::vector<unsigned char> bytes = saved(example());
  Outer restored;
  ByteReader in(bytes);
  RestoreArchive restore(in);
  restore(restored);
  EXPECT_TRUE(restore.ok());
  EXPECT_EQ(in.remaining(), 0u);
  EXPECT_EQ(saved(restored), bytes);
  EXPECT_EQ(restored.inner, example().inner);
  EXPECT_EQ(hashed(restored), hashed(example()));
}

TEST(Archive, CutAtAnyByteItGoesBadAndStaysInBounds) {
  const std::vector<unsigned char> bytes = saved(example());
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    const std::vector<unsigned char> cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length));
    Outer restored;
    ByteReader in(cut);
    RestoreArchive restore(in);
    restore(restored);
    EXPECT_FALSE(restore.ok()) << "cut after " << length;
    EXPECT_EQ(in.remaining(), 0u);
    EXPECT_EQ(in.read<std::uint32_t>(), 0u);
  }
}

TEST(Archive, AnAbsurdSizeIsRefusedBeforeMemoryIsTaken) {
  ByteWriter out;
  out.write(std::uint32_t{0xfffffff0});
  ByteReader in(out.bytes());
  RestoreArchive restore(in);
  std::vector<Inner> values(3);
  restore.vector(values);
  EXPECT_FALSE(restore.ok());
  EXPECT_TRUE(values.empty());
}

// Five bytes each: what would be allocated is at most what its bytes could fill.
TEST(Archive, ASizeThatTheRemainingBytesCannotHoldIsRefusedBeforeMemoryIsTaken) {
  for (const std::uint32_t count : {8u, 9u}) {
    ByteWriter out;
    out.write(count);
    for (int i = 0; i < 40; ++i) out.write(std::uint8_t{0});
    ByteReader in(out.bytes());
    RestoreArchive restore(in);
    std::vector<Inner> values;
    restore.vector(values);
    EXPECT_EQ(restore.ok(), count == 8);
    EXPECT_EQ(values.capacity(), count == 8 ? 8u : 0u);
  }
}

TEST(Archive, EveryFieldReachesTheHash) {
  const std::uint64_t base = hashed(example());
  const auto differs = [&](auto change) {
    Outer outer = example();
    change(outer);
    return hashed(outer) != base;
  };
  EXPECT_TRUE(differs([](Outer& o) { o.seed ^= 1ull << 63; }));
  EXPECT_TRUE(differs([](Outer& o) { o.on = false; }));
  EXPECT_TRUE(differs([](Outer& o) { o.pair[1] = 30001; }));
  EXPECT_TRUE(differs([](Outer& o) { o.inner.pop_back(); }));
  EXPECT_TRUE(differs([](Outer& o) { o.inner[1].kind = Kind::Ball; }));
  EXPECT_TRUE(differs([](Outer& o) { o.point.z() = 3.0000002f; }));
  EXPECT_TRUE(differs([](Outer& o) { o.turn.w() = 0.25f; }));
  EXPECT_TRUE(differs([](Outer& o) { o.time = 12.250000000000002; }));
}

TEST(ByteStream, StringsKeepTheirBytesAndRefuseAbsurdLengths) {
  ByteWriter out;
  out.writeString(std::string("a\0b", 3));
  ByteReader in(out.bytes());
  EXPECT_EQ(in.readString(), std::string("a\0b", 3));
  EXPECT_TRUE(in.ok());
  ByteReader limited(out.bytes());
  EXPECT_EQ(limited.readString(2), "");
  EXPECT_FALSE(limited.ok());
}

}  // namespace
}  // namespace brittle
