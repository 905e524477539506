#pragma once
#include "material/curve_file.hpp"
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace towform {

/// A test of a sheet's resistance to shear, and how its force becomes N [N/m] (physics: exact and published
/// references).
struct ShearTest {
  enum class Kind {
    picture_frame, ///< F = 2 L N cos(pi/4 - theta/2), L + L frame pulled along its diagonal (Eqs. 13-14)
    bias_extension ///< L x W strip, yarns at +-45 degrees; full shear in the middle, half of it beside
  };
  Kind kind = Kind::picture_frame;
  double side = 0.0;   ///< of the frame [m]
  double length = 0.0; ///< of the strip between the grips [m], at least 2 W
  double width = 0.0;  ///< of the strip [m]

  [[nodiscard]] double angle(double displacement) const; ///< theta [rad], NaN when out of reach
  [[nodiscard]] double displacement(double angle) const; ///< [m]
  [[nodiscard]] double lever(double angle) const;        ///< d(displacement)/d(theta) [m/rad]
  [[nodiscard]] double force(double angle, double full, double half) const; ///< F [N] of N(theta), N(theta/2)
  /// F dd/dtheta = `full` N(theta) + `half` N(theta/2): the power balance over theta_dot [m^2].
  struct Weights {
    double full, half;
  };
  [[nodiscard]] Weights weights(double angle) const;
};

/// One run of a test: force against angle, at a constant speed of the crosshead or a constant shear rate.
struct TestRun {
  std::vector<double> angle;   ///< [rad]
  std::vector<double> force;   ///< [N]
  std::optional<double> speed; ///< of the crosshead [m/s]
  std::optional<double> rate;  ///< shear rate [rad/s]; this or speed
};

/// Reads a CSV file of one or several runs: a line of column names, then numbers; # begins a comment.
/// Columns: displacement_mm or angle_deg; force_N or, for a picture frame, shear_force_N_per_m; and
/// speed_mm_per_s or rate_rad_per_s, which tell runs apart, unless `speed` or `rate` gives one for all.
/// Throws InputError (code `files`) with every issue and its line.
std::vector<TestRun> read_test(const std::filesystem::path& path, const ShearTest& test,
                               std::optional<double> speed, std::optional<double> rate);

/// What was made of the runs.
struct FittedTest {
  ShearCurves curves;              ///< one a run, over the angles that all runs reach
  std::vector<int> orders;         ///< of the polynomial that suits each run (least error on points left out)
  std::vector<double> residuals;   ///< root mean square of (fit - force)/largest force, a run
  double rate_min = 0.0, rate_max = 0.0; ///< least and largest shear rate measured [rad/s]
};

/// Curves N(theta) at one rate each from runs of a test. A run's force is linear in its N(theta) and
/// N(theta/2), so that a polynomial N follows from least squares. Runs at several speeds are brought to a
/// constant rate, each its mean, by the power law between neighbouring runs, at the angle theta/2 of bias
/// extension too; a single run cannot say how N depends on the rate and is taken as it is.
/// Throws std::domain_error when a run's points are too few, all at one angle, or its force nowhere positive.
FittedTest fit_test(const ShearTest& test, const std::vector<TestRun>& runs);

} // namespace towform
