#include "element/membrane.hpp"
#include "element/sheet.hpp"
#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace towform {
namespace {

using test::degree;
using Block = ElementBlocks::Block;

TEST(ElementBlocks, HaveTheStripsOfWhichMostElementsAreTheirs)
{
  for (const Pattern pattern : {Pattern::diagonal, Pattern::unstructured}) {
    const Blank blank = test::blank(pattern, 20.0 * degree, 0.0, 8000);
    const Membrane membrane(blank, {1e6, 0.1}, test::law(LawKind::elastic), YarnStrain::strip);
    const std::vector<Block>& blocks = membrane.blocks.blocks;
    ASSERT_GT(blocks.size(), 4U);
    const auto block_of = [&](std::size_t e) {
      const auto holds = [e](const Block& b) { return static_cast<int>(e) < b.first_element + b.own; };
      return std::find_if(blocks.begin(), blocks.end(), holds) - blocks.begin();
    };
    std::vector<std::vector<int>> elements(membrane.strips.size(), std::vector<int>(blocks.size(), 0));
    for (std::size_t entry = 0; entry < membrane.strips.of.size(); ++entry)
      ++elements[static_cast<std::size_t>(membrane.strips.of[entry])][static_cast<std::size_t>(block_of(entry / 2))];
    for (std::size_t b = 0, strip = 0; b < blocks.size(); ++b) {
      ASSERT_EQ(blocks[b].first_strip, static_cast<int>(strip));
      for (const std::size_t end = strip + static_cast<std::size_t>(blocks[b].strips); strip < end; ++strip)
        EXPECT_EQ(elements[strip][b], *std::max_element(elements[strip].begin(), elements[strip].end()));
    }
  }
}

} // namespace
} // namespace towform
