#include "element/curvature_patch.hpp"
#include <algorithm>
#include <cmath>
#include <compare>
#include <cstddef>

namespace towform {

CurvaturePatch::CurvaturePatch(const std::vector<int>& its_points, const std::vector<double>& warp, const std::vector<double>& weft,
                               const std::array<int, 4>& its_ends)
    : ends(its_ends)
{
  double largest = 0.0;
  for (const auto* weights_of_one : {&warp, &weft})
    for (const double w : *weights_of_one) largest = std::max(largest, std::abs(w));
  struct Term {
    std::int64_t warp, weft;
    std::size_t place;
    auto operator<=>(const Term&) const = default;
  };
  const auto whole = [&](double w) { return std::llround(w / (rounding * largest)); };
  std::vector<Term> terms;
  for (std::size_t i = 0; i < its_points.size(); ++i) terms.push_back({whole(warp[i]), whole(weft[i]), i});
  std::sort(terms.begin(), terms.end());
  for (const Term& term : terms) {
    points.push_back(its_points[term.place]);
    weights.push_back({warp[term.place], weft[term.place]});
    key.insert(key.end(), {term.warp, term.weft});
  }
}

} // namespace towform
