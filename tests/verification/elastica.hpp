#pragma once
#include <array>
#include <cmath>
#include <vector>

namespace towform::test {

/// The heavy elastica: an inextensible strip clamped level at s = 0, free at s = L, bent by its own weight,
///   B theta'' = -w (L - s) cos(theta),   theta(0) = 0,   theta'(L) = 0,
/// theta the slope downwards, B the bending stiffness and w the weight, both per width. Solved by shooting on
/// theta'(0) with the classical Runge-Kutta method, `steps` steps.
class HeavyElastica {
public:
  HeavyElastica(double length, double weight_over_stiffness, int steps = 2000)
      : length_(length), load_(weight_over_stiffness)
  {
    // theta'(L) rises with theta'(0); between no curvature and that of the weight all at the tip.
    double low = 0.0, high = load_ * length * length;
    for (int k = 0; k < 100; ++k) {
      const double middle = 0.5 * (low + high);
      (shoot(middle, steps, nullptr) > 0.0 ? high : low) = middle;
    }
    shoot(0.5 * (low + high), steps, &points_);
  }

  /// (x, drop) at arc length s [m].
  [[nodiscard]] std::array<double, 2> at(double s) const
  {
    const double place = s / length_ * static_cast<double>(points_.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(std::max(place, 0.0)), points_.size() - 2);
    const double part = place - static_cast<double>(i);
    return {points_[i][2] + part * (points_[i + 1][2] - points_[i][2]),
            points_[i][3] + part * (points_[i + 1][3] - points_[i][3])};
  }

private:
  using Point = std::array<double, 4>; ///< theta, theta', x, drop

  double shoot(double curvature, int steps, std::vector<Point>* points) const
  {
    const auto rate = [&](double s, const Point& y) {
      return Point{y[1], -load_ * (length_ - s) * std::cos(y[0]), std::cos(y[0]), std::sin(y[0])};
    };
    const auto moved = [](const Point& y, double h, const Point& k) {
      return Point{y[0] + h * k[0], y[1] + h * k[1], y[2] + h * k[2], y[3] + h * k[3]};
    };
    Point y{0.0, curvature, 0.0, 0.0};
    const double h = length_ / steps;
    if (points != nullptr) *points = {y};
    for (int i = 0; i < steps; ++i) {
      const double s = i * h;
      const Point a = rate(s, y), b = rate(s + 0.5 * h, moved(y, 0.5 * h, a)),
                  c = rate(s + 0.5 * h, moved(y, 0.5 * h, b)), d = rate(s + h, moved(y, h, c));
      for (std::size_t k = 0; k < 4; ++k) y[k] += h / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]);
      if (points != nullptr) points->push_back(y);
    }
    return y[1];
  }

  double length_, load_;
  std::vector<Point> points_;
};

} // namespace towform::test
