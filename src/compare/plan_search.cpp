#include "compare/plan_search.hpp"
#include <algorithm>
#include <cmath>

namespace towform {

namespace {

struct Box {
  Vec2 low, high;

  explicit Box(const Vec3& p) : low{p.x, p.y}, high{p.x, p.y} {}
  void add(const Vec3& p)
  {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
};

double twice_area(const Vec3& a, const Vec3& b, const Vec3& c)
{
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

} // namespace

PlanSearch::PlanSearch(std::span<const Vec3> places, std::span<const Triangle> triangles)
    : places_(places), triangles_(triangles)
{
  Box all(places.front());
  for (const Vec3& p : places) all.add(p);
  low_ = all.low;
  high_ = all.high;
  const double area = (high_.x - low_.x) * (high_.y - low_.y);
  const double widest = std::max({high_.x - low_.x, high_.y - low_.y, 1e-12});
  // About two triangles a cell, and never more cells along a side than there are triangles.
  const auto count = static_cast<double>(triangles.size());
  width_ = std::max(std::sqrt(2.0 * area / count), widest / count);
  columns_ = 1 + static_cast<std::size_t>((high_.x - low_.x) / width_);
  rows_ = 1 + static_cast<std::size_t>((high_.y - low_.y) / width_);
  elements_.resize(columns_ * rows_);
  for (std::size_t e = 0; e < triangles.size(); ++e) {
    Box box(places[triangles[e][0]]);
    for (const int n : triangles[e]) box.add(places[n]);
    const std::size_t first = cell(box.low.x, box.low.y), last = cell(box.high.x, box.high.y);
    for (std::size_t row = first / columns_; row <= last / columns_; ++row)
      for (std::size_t column = first % columns_; column <= last % columns_; ++column)
        elements_[row * columns_ + column].push_back(static_cast<int>(e));
  }
}

std::size_t PlanSearch::cell(double x, double y) const
{
  const auto along = [&](double d, std::size_t count) {
    return static_cast<std::size_t>(std::clamp(d / width_, 0.0, static_cast<double>(count - 1)));
  };
  return along(y - low_.y, rows_) * columns_ + along(x - low_.x, columns_);
}

std::vector<PlanSearch::Holder> PlanSearch::holders(Vec2 point) const
{
  std::vector<Holder> found;
  const double slack = 1e-9 * width_;
  if (!(point.x >= low_.x - slack && point.x <= high_.x + slack && point.y >= low_.y - slack &&
        point.y <= high_.y + slack))
    return found;
  const Vec3 p{point.x, point.y, 0.0};
  for (const int e : elements_[cell(point.x, point.y)]) {
    const Vec3 &a = places_[triangles_[e][0]], &b = places_[triangles_[e][1]], &c = places_[triangles_[e][2]];
    const double area = twice_area(a, b, c);
    const double longest = std::max({norm_squared(b - a), norm_squared(c - b), norm_squared(a - c)});
    if (std::abs(area) <= 1e-9 * longest) continue; // upright
    const double u = twice_area(p, b, c) / area, v = twice_area(a, p, c) / area, w = 1.0 - u - v;
    constexpr double edge = -1e-9;
    if (u >= edge && v >= edge && w >= edge) found.push_back({e, u * a.z + v * b.z + w * c.z});
  }
  std::stable_sort(found.begin(), found.end(), [](const Holder& a, const Holder& b) { return a.z > b.z; });
  return found;
}

} // namespace towform
