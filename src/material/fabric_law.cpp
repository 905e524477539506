#include "material/fabric_law.hpp"
#include "material/own_law.hpp"
#include "material/shear_resistance.hpp"
#include "material/shear_surface.hpp"
#include <stdexcept>

namespace towform {

namespace {

/// The curve of a rate-independent sheet, whatever the rate.
FabricMaterial tangent_material(const MaterialParameters& m, double thickness)
{
  if (m.law != LawKind::elastic)
    throw std::domain_error("shear_tangent knows no rates: it needs law = \"elastic\"");
  const TangentForce force(m.shear_tangent, thickness, curve_max_angle);
  if (force(curve_max_angle) <= 0.0) throw std::domain_error("shear_tangent is nowhere positive");
  ShearCurves curves{{fit_curve(force, m.elastic_rate, curve_max_angle)}, 0.0};
  curves.fit_error = curves.curves.front().fit_error();
  FabricMaterial result;
  result.curves = std::make_shared<const ShearCurves>(std::move(curves));
  result.law = ElasticLaw{result.curves};
  result.surface = std::make_shared<const ShearTable>([&](double theta, double) { return force(theta); },
                                                      ShearResistance::max_angle);
  return result;
}

} // namespace

FabricMaterial make_fabric_material(const MaterialParameters& m, double thickness)
{
  if (m.law == LawKind::own) return own_material(m);
  if (!m.shear_tangent.empty()) return tangent_material(m, thickness);
  FabricMaterial result;
  std::function<double(double, double)> force;
  double max_angle = curve_max_angle;
  if (m.has_model()) {
    force = [model = ShearResistance(m.constituents, thickness, m.temperature)](double theta, double rate) {
      return model.force(theta, rate);
    };
    result.curves = std::make_shared<const ShearCurves>(
        fit_curves(force, m.curve_rate_min, m.curve_rate_max, m.curve_count, max_angle));
  } else {
    result.curves = std::make_shared<const ShearCurves>(curves_of(m, thickness));
    force = surface_of(*result.curves);
    max_angle = result.curves->curves.front().max_angle();
  }
  result.surface = std::make_shared<const ShearTable>(force, ShearResistance::max_angle);
  switch (m.law) {
  case LawKind::viscous:
    result.law = ViscousLaw{result.surface, m.relaxation_ratio * m.fibre_modulus * thickness};
    break;
  case LawKind::incremental:
    result.law = IncrementalLaw{result.curves, m.curve_selection, m.velocity_scale};
    break;
  case LawKind::elastic: // one curve of a file is followed as it is
    result.law = ElasticLaw{!m.has_model() && result.curves->curves.size() == 1
                                ? result.curves
                                : std::make_shared<const ShearCurves>(
                                      fit_curves(force, m.elastic_rate, m.elastic_rate, 1, max_angle))};
    break;
  case LawKind::own: // above
    break;
  }
  return result;
}

} // namespace towform
