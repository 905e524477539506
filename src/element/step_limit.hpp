#pragma once
#include "element/linear_sheet.hpp"
#include "towform/blank.hpp"

namespace towform {

/// What a tool adds to a sheet that it touches, per area of it.
struct ToolSprings {
  double normal = 0.0, normal_damping = 0.0; ///< square to the sheet [N/m^3, N s/m^3]
  double along = 0.0, along_damping = 0.0;   ///< in it
};

/// The true limit of the time step of central differences on a sheet, measured with the tools that touch its nodes: Lanczos'
/// method finds the largest eigenvalue of M^-1 K from a start of random signs. What may be missing to it when the search ends is
/// added, so that the result is on the safe side of it: the residual (Zhou and Li, Linear Algebra Appl. 435 (2011) 480-493), or what
/// a random start can miss, where that is less. K is LinearSheet's; nodes stay on their mirror planes. The tools' springs stand
/// square to the sheet and along it. Damping in proportion to stiffness, C = tau K, acts in a step dt like a stiffness 2 C / dt, as
/// do the tools' dashpots: the limit is the root of dt^2 omega^2(K + 2 C / dt) = 4.
class StepLimit {
public:
  /// `mass` of each node [kg]; `shear_modulus` bounds dN/dtheta [N/m]. All must outlive this.
  StepLimit(const Blank& blank, const Membrane& membrane, std::span<const double> mass, double shear_modulus,
            std::span<const Bending> bending = {}, const ToolSprings& springs = {});

  /// The limit at a shape [s]. `tools`: how many of them touch each node; one everywhere where it is empty. `near`: a step at
  /// which damping is to be counted, quickest a little below the limit; 0 where none is known.
  [[nodiscard]] double at(std::span<const Vec3> position, std::span<const double> tools = {}, double near = 0.0) const;

private:
  struct Surroundings {
    std::vector<Vec3> normals;     ///< n, of the sheet
    std::span<const double> tools; ///< n or none
  };
  /// Bounds of omega^2 [1/s^2].
  struct Found {
    double least = 0.0, most = 0.0;
  };
  [[nodiscard]] Found largest_frequency_squared(const LinearSheet& sheet, const Surroundings& around, double dt, int vectors) const;
  void hold_on_mirrors(std::span<Vec3> v) const;

  const Blank& blank_;
  const Membrane& membrane_;
  std::span<const double> mass_; // n
  std::span<const Bending> bending_;
  double shear_modulus_;
  ToolSprings springs_;
  double bending_damping_time_ = 0.0;
};

} // namespace towform
