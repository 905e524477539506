#include "material/shear_surface.hpp"
#include "material/rate_line.hpp"
#include "towform/error.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace towform {

std::function<double(double, double)> surface_of(const ShearCurves& curves)
{
  std::vector<double> rates;
  double most = 0.0;
  for (const ShearCurve& curve : curves.curves) {
    rates.push_back(curve.rate());
    for (int i = 0; i <= 100; ++i) most = std::max(most, curve.force(curve.max_angle() * i / 100));
  }
  return [curves, rates, floor = 1e-6 * most](double theta, double rate) {
    std::vector<double> forces;
    for (const ShearCurve& curve : curves.curves) forces.push_back(curve.force(theta));
    return RateLine(rates, forces, floor, RateLine::Below::newtonian).force(rate);
  };
}

ShearCurves curves_of(const MaterialParameters& m, double thickness)
{
  CurveFile file = read_curves(m.curves);
  std::string problem;
  if (file.temperature && std::abs(*file.temperature - m.temperature) > 0.5)
    problem = fmt::format("is for {:.1f} degC, the sheet has {:.1f} degC", *file.temperature - 273.15,
                          m.temperature - 273.15);
  else if (file.thickness && std::abs(*file.thickness / thickness - 1.0) > 0.01)
    problem = fmt::format("is for a sheet of {:.4g} mm, the blank has {:.4g} mm", 1e3 * *file.thickness,
                          1e3 * thickness);
  else if (m.law == LawKind::viscous && file.curves.curves.size() < 2)
    problem = "has one curve; the viscous law needs two rates or more (law = \"elastic\" follows one curve)";
  if (!problem.empty()) {
    std::vector<InputIssue> issues(1);
    issues[0].where.file = m.curves.string();
    issues[0].message = problem;
    throw InputError(std::move(issues));
  }
  return std::move(file.curves);
}

TangentForce::TangentForce(const std::vector<double>& tangent, double thickness, double max_angle)
    : forces_{0.0}, max_angle_(max_angle)
{
  const auto modulus = [&](double gamma) {
    double g = 0.0;
    for (std::size_t k = tangent.size(); k-- > 0;) g = g * gamma + tangent[k];
    return std::max(g, 0.0);
  };
  const double step = max_angle / cells;
  for (int i = 0; i < cells; ++i) { // Simpson: exact for a cubic, and there is a cell for every 0.04 degrees
    const double a = i * step;
    const double mean = (modulus(a) + 4.0 * modulus(a + 0.5 * step) + modulus(a + step)) / 6.0;
    forces_.push_back(forces_.back() + thickness * step * mean);
  }
}

double TangentForce::operator()(double theta) const
{
  const double u = std::clamp(theta / max_angle_, 0.0, 1.0) * cells;
  const int cell = std::min(static_cast<int>(u), cells - 1);
  return forces_[cell] + (u - cell) * (forces_[cell + 1] - forces_[cell]);
}

} // namespace towform
