// fuzz_TARGET FOLDER [RUNS]: tries every file of a corpus folder, then RUNS inputs made from them: bytes changed, put
// in, taken out, two files joined. The same inputs in every run.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "engine/core/random.h"
#include "tests/fuzz/target.h"

namespace {

using Bytes = std::vector<std::uint8_t>;
constexpr std::size_t kLongest = 1u << 16;

std::vector<Bytes> corpusOf(const std::string& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.is_regular_file()) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<Bytes> corpus;
  for (const std::filesystem::path& path : paths) {
    std::ifstream in(path, std::ios::binary);
    corpus.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return corpus;
}

void change(brittle::Random& random, const std::vector<Bytes>& corpus, Bytes& bytes) {
  const std::uint32_t kind = random.nextBelow(5);
  const std::uint32_t at = random.nextBelow(static_cast<std::uint32_t>(bytes.size()) + 1);
  const auto value = static_cast<std::uint8_t>(random.nextBelow(256));
  const std::uint32_t length = 1 + random.nextBelow(16);
  if (kind == 0 && at < bytes.size()) {
    bytes[at] = value;
  } else if (kind == 1 && at < bytes.size()) {
    bytes[at] ^= static_cast<std::uint8_t>(1u << (value & 7u));
  } else if (kind == 2) {
    bytes.insert(bytes.begin() + at, length, value);
  } else if (kind == 3) {
    bytes.erase(bytes.begin() + at, bytes.begin() + std::min<std::size_t>(at + length, bytes.size()));
  } else if (kind == 4) {
    const Bytes& other = corpus[random.nextBelow(static_cast<std::uint32_t>(corpus.size()))];
    const std::uint32_t from = random.nextBelow(static_cast<std::uint32_t>(other.size()) + 1);
    bytes.resize(at);
    bytes.insert(bytes.end(), other.begin() + from, other.end());
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: %s FOLDER [RUNS]\n", argv[0]);
    return 2;
  }
  const std::vector<Bytes> corpus = corpusOf(argv[1]);
  const int runs = argc > 2 ? std::atoi(argv[2]) : 0;
  if (corpus.empty()) {
    std::fprintf(stderr, "%s: no file in it, expected at least one input to begin with\n", argv[1]);
    return 2;
  }
  for (const Bytes& bytes : corpus) LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  brittle::Random random(1);
  for (int run = 0; run < runs; ++run) {
    Bytes bytes = corpus[random.nextBelow(static_cast<std::uint32_t>(corpus.size()))];
    for (std::uint32_t i = 1 + random.nextBelow(8); i > 0; --i) change(random, corpus, bytes);
    if (bytes.size() > kLongest) bytes.resize(kLongest);
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
  std::printf("%zu files and %d inputs made from them\n", corpus.size(), runs);
  return 0;
}
