#include "material/prediction.hpp"
#include "material/degree.hpp"
#include "material/fabric_law.hpp"
#include "material/shear_resistance.hpp"
#include "towform/error.hpp"
#include <cmath>
#include <fmt/format.h>

namespace towform {

namespace {

constexpr double celsius = 273.15;

/// What is out of range becomes an issue of the case.
template <class F>
auto checked(const Case& c, F compute) -> decltype(compute())
{
  std::vector<InputIssue> issues(1);
  issues[0].where = c.where("material");
  if (!c.material.has_model()) {
    issues[0].message = fmt::format("the material has {}: there is nothing to predict from constituents",
                                    c.material.curves.empty() ? "shear_tangent" : "curves");
    throw InputError(std::move(issues));
  }
  try {
    return compute();
  } catch (const std::domain_error& e) {
    issues[0].message = e.what();
  }
  throw InputError(std::move(issues));
}

std::string sheet_name(const Case& c)
{
  const MaterialParameters& m = c.material;
  return fmt::format("{}{}{}", m.card.empty() ? "material of " + c.path.string() : "card " + m.card,
                     m.source.empty() ? "" : ": ", m.source);
}

std::string matrix_name(const MatrixViscosity& m)
{
  const bool wlf = m.shift == TemperatureShift::wlf;
  const std::string shift = wlf ? fmt::format("WLF C1 {:g} C2 {:g} K", m.wlf_c1, m.wlf_c2)
                                : fmt::format("Arrhenius {:g} kJ/mol", 1e-3 * m.activation_energy);
  std::string at = fmt::format("at {:g} degC, {}", m.reference_temperature - celsius, shift);
  const auto formula = [&](const char* name, const std::string& more) {
    return fmt::format("{} eta0 {:g} Pa s, lambda {:g} s, n {:g}{} {}", name, m.zero_shear_viscosity,
                       m.time_constant, m.exponent, more, at);
  };
  switch (m.model) {
  case MatrixModel::cross:
    return formula("Cross", "");
  case MatrixModel::carreau_yasuda:
    return formula("Carreau-Yasuda", fmt::format(", a {:g}", m.transition));
  case MatrixModel::power_law:
    return formula("power law, constant below 1/lambda,", "");
  case MatrixModel::table:
    return fmt::format("table of {} points {}", m.points.size(), at);
  }
  return at;
}

std::vector<std::string> inputs(const Case& c)
{
  const Constituents& k = c.material.constituents;
  const auto name = [](bool first, const char* a, const char* b) { return first ? a : b; };
  return {
      "Energy model, " + sheet_name(c),
      fmt::format(
          "fibre fraction {:g}, tow width {:g} mm, gap {:g} mm, fibre diameter {:g} um, weave factor {:g}",
          k.fibre_volume_fraction, 1e3 * k.tow_width, 1e3 * k.tow_gap, 1e6 * k.fibre_diameter,
          k.weave_factor),
      fmt::format("tow viscosity {}, packing {}, crossover field {}, tow kinematics {}",
                  name(k.tow_viscosity == TowViscosity::coffin, "coffin", "hexagonal_cell"),
                  name(k.fibre_packing == FibrePacking::square, "square", "hexagonal"),
                  name(k.crossover_field == CrossoverField::printed, "printed", "derived"),
                  name(k.tow_kinematics == TowKinematics::measured, "measured", "minimum_power")),
      "matrix " + matrix_name(k.matrix)};
}

ShearResistance model_of(const Case& c, double temperature)
{
  return {c.material.constituents, c.blank.thickness, temperature};
}

} // namespace

CurveFile predicted_curves(const Case& c)
{
  return checked(c, [&] {
    const MaterialParameters& m = c.material;
    const ShearResistance model = model_of(c, m.temperature);
    const auto force = [&](double theta, double rate) { return model.force(theta, rate); };
    return CurveFile{fit_curves(force, m.curve_rate_min, m.curve_rate_max, m.curve_count, curve_max_angle),
                     m.temperature, c.blank.thickness, inputs(c)};
  });
}

std::string prediction_text(const Case& c, const CurveFile& curves, const PredictionPoints& points)
{
  return checked(c, [&] {
    const ShearResistance model = model_of(c, c.material.temperature);
    std::string text;
    for (const std::string& line : inputs(c)) text += line + '\n';
    text += fmt::format(
        "sheet {:g} mm at {:g} degC; fibre fraction in a tow {:.4f}, film at a crossover {:.3f} um\n",
        1e3 * c.blank.thickness, c.material.temperature - celsius, model.tow_fibre_fraction(),
        1e6 * model.film_thickness());
    const double middle = points.rates[points.rates.size() / 2];
    text += "\nshear force [N/m] at a rate [rad/s]" +
            std::string(points.rates.size() * 11 < 27 ? 0 : points.rates.size() * 11 - 27, ' ') +
            fmt::format(" | parts at {:g} rad/s\n angle ", middle);
    for (const double rate : points.rates) text += fmt::format(" {:>10g}", rate);
    text += " |        tow  inter-tow  crossover\n";
    for (const double angle : points.angles) {
      text += fmt::format("{:6.4g}", angle / degree);
      for (const double rate : points.rates) text += fmt::format(" {:10.4g}", model.force(angle, rate));
      const ShearResistance::Parts p = model.parts(angle, middle);
      text += fmt::format(" | {:10.4g} {:10.4g} {:10.4g}\n", p.tow, p.inter_tow, p.crossover);
    }
    text += fmt::format("\n{} curves of order 11 over 0 .. {:g} deg; rate [rad/s]: fit error [%]\n",
                        curves.curves.curves.size(), curve_max_angle / degree);
    int column = 0;
    for (const ShearCurve& curve : curves.curves.curves)
      text += fmt::format("{:>8.4g}: {:<7.2g}{}", curve.rate(), 100.0 * curve.fit_error(),
                          ++column % 5 == 0 ? "\n" : "");
    return text + (column % 5 == 0 ? "" : "\n");
  });
}

std::string prediction_table(const Case& c, const PredictionPoints& points)
{
  return checked(c, [&] {
    std::string text =
        "temperature_degC,rate_rad_per_s,theta_deg,shear_force_N_per_m,tow,inter_tow,crossover\n";
    std::vector<double> temperatures = points.temperatures;
    if (temperatures.empty()) temperatures.push_back(c.material.temperature);
    for (const double temperature : temperatures) {
      const ShearResistance model = model_of(c, temperature);
      for (const double rate : points.rates)
        for (const double angle : points.angles) {
          const ShearResistance::Parts p = model.parts(angle, rate);
          text +=
              fmt::format("{:.10g},{:.10g},{:.10g},{:.10g},{:.10g},{:.10g},{:.10g}\n", temperature - celsius,
                          rate, angle / degree, p.total(), p.tow, p.inter_tow, p.crossover);
        }
    }
    return text;
  });
}

} // namespace towform
