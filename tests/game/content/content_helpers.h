// What the content tests share: the sloppy files under data/, and damage done to a text.
#pragma once

#include <gtest/gtest.h>

#include "game/content/asset_source.h"
#include "game/content/problem.h"

#include <zlib.h>

#include <string>

namespace brittle::content {

inline const std::string kData = std::string(BRITTLE_SOURCE_DIR) + "/tests/game/content/data/assets";

inline std::string dataFile(const std::string& name) {
  const Result<std::string> text = FolderSource({kData}).read(name);
  EXPECT_TRUE(text) << text.error().message;
  return text ? *text : std::string();
}

inline std::string listed(const Problems& problems) {
  std::string text;
  for (const Problem& problem : problems) text += problem.text() + "\n";
  return text;
}

/// `windowBits` as zlib names them: 15 a zlib archive, 15 + 16 a gzip one, 9 a zlib one of another first byte.
inline std::string archived(const std::string& bytes, int windowBits = 15) {
  z_stream stream{};
  EXPECT_EQ(deflateInit2(&stream, 9, Z_DEFLATED, windowBits, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string out(deflateBound(&stream, bytes.size()) + 64, '\0');
  stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

/// Calls visit with `text` cut at every byte, then with every bit of every byte flipped.
template <class Visit>
void forEachDamage(const std::string& text, const Visit& visit) {
  for (std::size_t cut = 0; cut <= text.size(); ++cut) visit(text.substr(0, cut));
  for (std::size_t at = 0; at < text.size(); ++at) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string flipped = text;
      flipped[at] = static_cast<char>(flipped[at] ^ (1 << bit));
      visit(flipped);
    }
  }
}

}  // namespace brittle::content
