#include "element/membrane.hpp"
#include "element/sheet.hpp"
#include <algorithm>
#include <gtest/gtest.h>

namespace towform {
namespace {

using test::degree;

TEST(MembraneBatches, KnowEveryElementOnce)
{
  for (const Pattern pattern : {Pattern::diagonal, Pattern::cross, Pattern::unstructured}) {
    const Blank blank = test::blank(pattern, 25.0 * degree, pattern == Pattern::unstructured ? 0.0 : 20.0 * degree);
    const Membrane membrane(blank, {1e6, 0.1}, test::law(LawKind::elastic));
    std::vector<int> seen(membrane.triangles.size(), 0);
    for (int block = 0; block < membrane.blocks.count(); ++block)
      membrane.each_own(block, [&](std::size_t e, const FlatTriangle& flat) {
        ++seen[e];
        const FlatTriangle itself = flat_triangle(blank, membrane.triangles[e]);
        EXPECT_NEAR(flat.area, itself.area, 1e-12 * itself.area);
        const YarnGradients& g = flat.gradients;
        const YarnGradients& own = itself.gradients;
        const double size = std::max({std::abs(own.warp_1), std::abs(own.warp_2), std::abs(own.weft_1), std::abs(own.weft_2)});
        for (const double YarnGradients::*part :
             {&YarnGradients::warp_1, &YarnGradients::warp_2, &YarnGradients::weft_1, &YarnGradients::weft_2})
          EXPECT_NEAR(g.*part, own.*part, 1e-12 * size);
      });
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), std::ptrdiff_t(seen.size()));
  }
}

} // namespace
} // namespace towform
