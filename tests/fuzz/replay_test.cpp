#include "targets.hpp"
#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <random>

namespace towform::fuzz {
namespace {

using Bytes = std::vector<unsigned char>;

Bytes bytes_of(const std::filesystem::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Some words that readers of numbers and tables look twice at.
const std::vector<std::string> words{"nan",  "inf",     "-1", "0",  "1e999",  "99999999999999999999",
                                     "[[",   "]]",      "\"", "\n", "\r",     "#",
                                     ",",    "=",       "{",  "}",  "1e-320", "-0",
                                     "\xff", "\xe2\x82"};

/// A few changes: bytes turned, cut out, doubled, or a word put in.
Bytes changed(Bytes bytes, std::mt19937& random)
{
  const auto below = [&](std::size_t limit) {
    return static_cast<std::ptrdiff_t>(random() % std::max<std::size_t>(limit, 1));
  };
  for (auto changes = 1 + below(4); changes > 0; --changes) {
    const auto at = bytes.begin() + below(bytes.size());
    const auto length = std::min<std::ptrdiff_t>(1 + below(16), bytes.end() - at);
    switch (below(4)) {
    case 0:
      if (at != bytes.end()) *at = static_cast<unsigned char>(*at ^ (1U << below(8)));
      break;
    case 1:
      bytes.erase(at, at + length);
      break;
    case 2: {
      const Bytes part(at, at + length);
      bytes.insert(at, part.begin(), part.end());
      break;
    }
    default: {
      const std::string& word = words[static_cast<std::size_t>(below(words.size()))];
      bytes.insert(at, word.begin(), word.end());
    }
    }
  }
  return bytes;
}

/// What scripts/fuzz does at length, in a moment and with the same bytes every time.
class Fuzz : public ::testing::TestWithParam<Target> {};

TEST_P(Fuzz, ReadsSeedsAndWhatIsLikeThemOrSaysWhyNot)
{
  constexpr int changes_of_each = 2000;
  std::mt19937 random(1); // NOLINT(bugprone-random-generator-seed): the same every time
  int seeds = 0;
  const auto corpus = std::filesystem::path(TOWFORM_SOURCE_DIR) / "tests/fuzz/corpus" / GetParam().name;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(corpus)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    const Bytes seed = bytes_of(file);
    give(GetParam(), seed);
    for (int i = 0; i < changes_of_each; ++i) give(GetParam(), changed(seed, random));
    ++seeds;
  }
  EXPECT_GT(seeds, 0);
}

INSTANTIATE_TEST_SUITE_P(, Fuzz, ::testing::ValuesIn(targets()),
                         [](const auto& target) { return std::string(target.param.name); });

} // namespace
} // namespace towform::fuzz
