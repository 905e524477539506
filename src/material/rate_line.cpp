#include "material/rate_line.hpp"
#include <algorithm>
#include <cmath>

namespace towform {

namespace {
template <class Point>
double slope(const Point& a, const Point& b)
{
  return (b.force - a.force) / (b.rate - a.rate);
}
} // namespace

RateLine::RateLine(const std::vector<double>& rates, const std::vector<double>& forces, double floor,
                   Below below)
    : below_(below)
{
  std::vector<Point> all;
  for (std::size_t i = 0; i < rates.size(); ++i)
    all.push_back({std::log(rates[i]), std::log(std::max(forces[i], floor))});
  for (std::size_t i = all.size() - 1; i-- > 0;) // no faster than the rate
    all[i].force = std::max(all[i].force, all[i + 1].force - (all[i + 1].rate - all[i].rate));
  for (std::size_t i = 1; i < all.size(); ++i) // no fall
    all[i].force = std::max(all[i].force, all[i - 1].force);
  for (const Point& p : all) { // upper hull
    while (points_.size() >= 2 &&
           slope(points_[points_.size() - 2], points_.back()) <= slope(points_.back(), p))
      points_.pop_back();
    points_.push_back(p);
  }
}

double RateLine::force(double rate) const
{
  const double x = std::log(rate);
  const Point& first = points_.front();
  if (points_.size() == 1 || (below_ == Below::newtonian && x <= first.rate))
    return std::exp(first.force + (x <= first.rate && below_ == Below::newtonian ? x - first.rate : 0.0));
  const auto high =
      std::find_if(points_.begin() + 1, points_.end() - 1, [x](const Point& p) { return p.rate >= x; });
  const Point& low = *(high - 1);
  return std::exp(low.force + slope(low, *high) * (x - low.rate));
}

} // namespace towform
