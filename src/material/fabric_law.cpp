#include "material/fabric_law.hpp"
#include "material/shear_resistance.hpp"

namespace towform {

namespace {
// Beyond this the surface rises like 1/cos^3 and a polynomial of order 11 no longer follows it well.
constexpr double curve_max_angle = 75.0 * M_PI / 180.0;
} // namespace

FabricMaterial make_fabric_material(const MaterialParameters& m, double thickness)
{
  const ShearResistance model(m.constituents, thickness, m.temperature);
  const auto force = [&model](double theta, double rate) { return model.force(theta, rate); };
  FabricMaterial result;
  result.surface = std::make_shared<const ShearTable>(force, ShearResistance::max_angle);
  result.curves = std::make_shared<const ShearCurves>(
      fit_curves(force, m.curve_rate_min, m.curve_rate_max, m.curve_count, curve_max_angle));
  switch (m.law) {
  case LawKind::viscous:
    result.law = ViscousLaw{result.surface, m.relaxation_ratio * m.fibre_modulus * thickness};
    break;
  case LawKind::incremental:
    result.law = IncrementalLaw{result.curves, m.curve_selection, m.velocity_scale};
    break;
  case LawKind::elastic:
    result.law = ElasticLaw{std::make_shared<const ShearCurves>(
        fit_curves(force, m.elastic_rate, m.elastic_rate, 1, curve_max_angle))};
    break;
  }
  return result;
}

} // namespace towform
