// A shear law of one's own: the weave's resistance from a table, as a picture frame measures it at a crawl,
// and beside it a Maxwell element for the resin. Forms a case with the case's law and with this one:
//     own_law CASE.toml DIR [key.path=value]...
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <towform/run.hpp>
#include <towform/shear_law.hpp>

class TableAndResin : public towform::ShearLaw {
  static constexpr double cell = 10.0 * 3.14159265358979323846 / 180.0;         // of the table [rad]
  static constexpr std::array<double, 8> table{0, 8, 14, 24, 44, 90, 200, 450}; // N at 0, 10 ... 70 deg [N/m]
  double spring_ = 1e4, relaxation_ = 4e-4;                                     // of the resin [N/m], [s]

  static double weave(double angle) // N(theta), straight between the points of the table and beyond the last
  {
    const double place = std::abs(angle) / cell;
    const auto low = std::min(static_cast<std::size_t>(place), table.size() - 2);
    const double part = place - static_cast<double>(low);
    return std::copysign(table[low] + part * (table[low + 1] - table[low]), angle);
  }

public:
  double update(towform::ShearPoint& p, double angle, double dt) const override
  {
    const double before = p.force - weave(p.angle); // what the resin carried; its element by backward Euler
    const double resin = (before + spring_ * (angle - p.angle)) / (1.0 + dt / relaxation_);
    p = {.angle = angle, .force = weave(angle) + resin, .rate = std::abs(angle - p.angle) / dt};
    return resin * resin / (spring_ * relaxation_);
  }
  double modulus() const override { return spring_ + (table.back() - table[table.size() - 2]) / cell; }
  std::string description() const override { return "table and resin, 10 kN/m relaxing in 0.4 ms"; }
};

int main(int argc, char** argv)
try {
  if (argc < 3) return std::fprintf(stderr, "usage: own_law CASE.toml DIR [key.path=value]...\n"), 2;
  towform::Case c = towform::read_case(argv[1], {argv + 3, argv + argc});
  const auto form = [&](const char* law) {
    const auto outcome =
        towform::run(c, {.directory = std::string(argv[2]) + '/' + law, .quiet = true, .force = true});
    const towform::Summary& s = outcome.summary;
    std::printf("%-8s punch %.1f N, largest shear %.2f deg", law, s.punch_force_max_N, s.shear_angle_max_deg);
    for (const auto& [kind, joules] : s.energies_J)
      if (kind.starts_with("shear")) std::printf(", %s %.4f J", kind.c_str(), joules);
    std::printf(", energy error %.3f %%\n%s", 100.0 * s.energy_error, s.message.c_str());
    return static_cast<int>(outcome.code);
  };
  if (const int code = form("built_in")) return code;
  towform::use_law(c, std::make_shared<TableAndResin>());
  return form("own");
} catch (const std::exception& e) {
  return std::fprintf(stderr, "%s\n", e.what()), 1;
}
