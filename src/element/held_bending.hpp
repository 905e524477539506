#pragma once

namespace towform {

/// How far ahead of the last look at the curvatures, over the time between two, the middle of the time is for which forces are
/// held: those at n kick from n - 1/2 to n + 1/2, held ones up to n + interval - 1/2.
[[nodiscard]] constexpr double held_ahead(int interval) { return 0.5 * (interval - 1) / interval; }

/// By what a wave of frequency omega grows over one hold when its forces are computed every `interval` steps and held between, as
/// bending_forces does: largest eigenvalue, less 1, of what a hold makes of place, velocity and the place at the hold before.
/// `omega_dt` [rad] and `damping_steps` (damping time over dt [-]) of one step. Negative where the wave dies out.
[[nodiscard]] double hold_growth(double omega_dt, double damping_steps, int interval);

/// For how many steps, `most` at most, the forces can be held without any wave up to a frequency growing to speak of. Held forces
/// feed a wave; damping has to take that away again.
[[nodiscard]] int longest_hold(double omega_dt, double damping_steps, int most);

} // namespace towform
