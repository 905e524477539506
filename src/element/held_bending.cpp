#include "element/held_bending.hpp"
#include <Eigen/Eigenvalues>

namespace towform {

double hold_growth(double omega_dt, double damping_steps, int interval)
{
  Eigen::Matrix3d hold; // of place, velocity times dt, and the place before
  for (int column = 0; column < 3; ++column) {
    const Eigen::Vector3d start = Eigen::Vector3d::Unit(column);
    double place = start[0], velocity = start[1];
    const double change = start[0] - start[2];
    const double kick = -omega_dt * omega_dt * (place + (held_ahead(interval) + damping_steps / interval) * change);
    for (int step = 0; step < interval; ++step) {
      velocity += kick;
      place += velocity;
    }
    hold.col(column) << place, velocity, start[0];
  }
  return Eigen::EigenSolver<Eigen::Matrix3d>(hold, false).eigenvalues().cwiseAbs().maxCoeff() - 1.0;
}

int longest_hold(double omega_dt, double damping_steps, int most)
{
  constexpr double margin = 1.25;    // of the frequency: a bent sheet's waves are a little faster than a flat one's
  constexpr double harmless = 1e-6;  // a hundredth in 10,000 holds
  constexpr int waves = 16;
  for (int interval = most; interval > 1; --interval) {
    bool grows = false;
    for (int i = 1; i <= waves && !grows; ++i)
      grows = hold_growth(margin * omega_dt * i / waves, damping_steps, interval) > harmless;
    if (!grows) return interval;
  }
  return 1;
}

} // namespace towform
