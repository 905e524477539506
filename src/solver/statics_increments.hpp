#pragma once
#include "solver/statics.hpp"
#include <functional>

namespace towform {

/// Chooses the increments of a quasi-static run: cut when Newton's method fails, or when the sheet shears
/// too far for the time integration of its law, longer again when it goes easily.
class Increments {
public:
  struct Controls {
    double turn = 0.1 * 3.14159265358979323846 / 180.0; ///< wanted largest change of a shear angle [rad]
    double first = 1e-3;                                ///< of the run
    double shortest = 1e-8;                             ///< of the run
    int easy = 8;                                       ///< iterations
  };

  explicit Increments(double run_time) : Increments(run_time, Controls()) {}
  Increments(double run_time, const Controls& controls)
      : run_time_(run_time), controls_(controls), next_(controls.first * run_time)
  {
  }

  /// Moves the state to `time`; `watch` sees every equilibrium. Throws RunStopped (stability gate) naming
  /// time, increment and the node that is furthest from equilibrium; the state is then the last equilibrium.
  void advance_to(double time, const StaticsModel& model, StaticsState& s,
                  const std::function<void(const NewtonReport&)>& watch);

  /// Wanted length of the next increment [s].
  [[nodiscard]] double& next() { return next_; }

private:
  double run_time_;
  Controls controls_;
  double next_; ///< wanted length [s]
};

} // namespace towform
