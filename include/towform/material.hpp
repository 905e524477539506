#pragma once
#include "towform/energy_model.hpp"
#include "towform/vec3.hpp"
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace towform {

/// How the shear-force surface becomes a stress (physics of the laws: src/material/fabric_law.hpp); `own` is a
/// law that the calling program brings (towform/shear_law.hpp).
enum class LawKind { viscous, incremental, elastic, own };
class ShearLaw;

/// Which curve the incremental law follows.
enum class CurveSelection { next_higher, interpolate };

/// What strain an element's yarns answer to: the mean of the strip of yarn they belong to, or the element's
/// own (the plain constant-strain triangle, exact where the mesh follows the yarns; elsewhere it locks).
/// Automatic: its own where every triangle has an edge along each yarn.
enum class YarnStrain { automatic, strip, triangle };

/// A point of a moment-curvature table.
struct BendingPoint {
  double curvature = 0.0; ///< [1/m], > 0
  double moment = 0.0;    ///< per width of the sheet [N]
};

/// Everything a case says about the sheet's material.
struct MaterialParameters {
  std::string card;                ///< name of a card that towform brings, path of any other; empty without
  std::filesystem::path card_file; ///< where it was found
  std::string source;              ///< where the values come from; shown with every prediction
  std::filesystem::path curves;    ///< shear curves in place of the energy model; empty without
  /// An elastic sheet's own tangent in place of the model: G12 = sum c_k gamma^k [Pa], gamma in rad.
  std::vector<double> shear_tangent;
  Constituents constituents; ///< with curves or shear_tangent only its density is used
  double temperature = 0.0;  ///< of the sheet [K]
  LawKind law = LawKind::viscous;
  std::shared_ptr<const ShearLaw> own_law; ///< of the program, set by use_law; no file can hold it
  std::string own_law_words;               ///< its description
  CurveSelection curve_selection = CurveSelection::next_higher;
  double velocity_scale = 1.0;     ///< multiplies the rate where a curve is chosen, nowhere else
  double curve_rate_min = 0.0;     ///< first curve's angular rate [rad/s]
  double curve_rate_max = 0.0;     ///< last curve's angular rate [rad/s]
  int curve_count = 20;            ///< equal increments from the first to the last
  double elastic_rate = 0.0;       ///< the rate whose curve the elastic law follows [rad/s]
  double fibre_modulus = 0.0;      ///< E of a yarn family over the sheet's whole thickness [Pa]
  double compression_factor = 0.0; ///< yarn stiffness in compression over that in tension
  double yarn_damping = 0.0;       ///< fraction of critical, in the yarn direction
  YarnStrain yarn_strain = YarnStrain::automatic;
  std::optional<double> strip_stiffness; ///< spring between a triangle and its strip over the sheet's shear force
  double relaxation_ratio = 0.0; ///< Maxwell modulus G over yarn stiffness E h (viscous law)
  /// B of warp (x) and weft (y), moment per width over the yarn's curvature [N m]; none: no bending.
  std::optional<Vec2> bending_stiffness;
  std::vector<BendingPoint> bending_table; ///< of both families, in place of the stiffness; or empty
  double bending_damping = 0.0;            ///< fraction of critical, of the sheet's fastest bending

  [[nodiscard]] bool has_bending() const { return bending_stiffness || !bending_table.empty(); }

  /// Whether the shear force is predicted from the constituents.
  [[nodiscard]] bool has_model() const { return curves.empty() && shear_tangent.empty(); }
};

} // namespace towform
