#include "element/stable_step.hpp"
#include <algorithm>
#include <cmath>

namespace towform {

namespace {

/// Gradients of an element's corners along warp and weft.
std::array<YarnPair, 3> corner_gradients(const YarnGradients& g)
{
  return {{{-g.warp_1 - g.warp_2, -g.weft_1 - g.weft_2}, {g.warp_1, g.weft_1}, {g.warp_2, g.weft_2}}};
}

/// Larger eigenvalue of [[a, c], [c, b]].
double largest(double a, double b, double c) { return 0.5 * (a + b) + std::hypot(0.5 * (a - b), c); }

/// omega^2 of the averaged yarn strains round node n on the patch's share of the mass.
double patch_frequency_squared(const Membrane& membrane, const State& s, std::span<const double> element_mass,
                               std::size_t n)
{
  struct Row {
    int node;
    Vec3 warp, weft;
    double mass = 0.0;
  };
  std::vector<Row> rows; // a handful of nodes: linear search
  for (const int slot : membrane.corners.of(n)) {
    const int e = slot / 3;
    const YarnVectors y(membrane.triangles[e], membrane.gradients[e], s.position);
    const auto gradients = corner_gradients(membrane.gradients[e]);
    const double weight = membrane.area[e] / (3.0 * membrane.node_area[n]);
    for (int c = 0; c < 3; ++c) {
      const int node = membrane.triangles[e][c];
      auto row = std::find_if(rows.begin(), rows.end(), [node](const Row& r) { return r.node == node; });
      if (row == rows.end()) row = rows.insert(rows.end(), Row{node, {}, {}});
      row->warp += weight * gradients[c].warp * y.f1;
      row->weft += weight * gradients[c].weft * y.f2;
      row->mass += element_mass[e] / 9.0;
    }
  }
  double warp = 0.0, weft = 0.0, both = 0.0;
  for (const Row& r : rows) {
    warp += norm_squared(r.warp) / r.mass;
    weft += norm_squared(r.weft) / r.mass;
    both += dot(r.warp, r.weft) / r.mass;
  }
  const double scale = membrane.yarn.stiffness * (1.0 - membrane.own_strain_share) * membrane.node_area[n];
  return scale * largest(warp, weft, both);
}

/// omega^2 of an element's own yarn strains and shear on its own mass, bounded by the sum of both.
double element_frequency_squared(const Membrane& membrane, const State& s, double mass, double shear_modulus,
                                 int e)
{
  const YarnVectors y(membrane.triangles[e], membrane.gradients[e], s.position);
  double warp = 0.0, weft = 0.0, both = 0.0; // sums over corners of products of gradients
  for (const YarnPair& g : corner_gradients(membrane.gradients[e])) {
    warp += g.warp * g.warp;
    weft += g.weft * g.weft;
    both += g.warp * g.weft;
  }
  const double sine = dot(y.f1, y.f2), cosine = std::sqrt(std::max(0.0, 1.0 - sine * sine));
  const double yarns = membrane.own_strain_share * membrane.yarn.stiffness * largest(warp, weft, both * sine);
  const double shear = shear_modulus * cosine *
                       (warp / (y.lambda1 * y.lambda1) + weft / (y.lambda2 * y.lambda2) -
                        2.0 * sine * both / (y.lambda1 * y.lambda2));
  return 3.0 * membrane.area[e] / mass * (yarns + shear);
}

struct Frequencies {
  std::vector<double> patch, element; // omega^2 [1/s^2]
};

Frequencies frequencies(const Membrane& membrane, const State& s, std::span<const double> element_mass,
                        double shear_modulus)
{
  Frequencies f{std::vector<double>(s.position.size()), std::vector<double>(membrane.triangles.size())};
  const auto nodes = static_cast<std::ptrdiff_t>(f.patch.size());
  const auto elements = static_cast<std::ptrdiff_t>(f.element.size());
#pragma omp parallel
  {
#pragma omp for schedule(static)
    for (std::ptrdiff_t n = 0; n < nodes; ++n)
      f.patch[n] = patch_frequency_squared(membrane, s, element_mass, n);
#pragma omp for schedule(static)
    for (std::ptrdiff_t e = 0; e < elements; ++e)
      f.element[e] =
          element_frequency_squared(membrane, s, element_mass[e], shear_modulus, static_cast<int>(e));
  }
  return f;
}

double step_of(double omega_squared, double damping_time)
{
  const double omega = std::sqrt(omega_squared), xi = 0.5 * damping_time * omega;
  return 2.0 / omega * (std::sqrt(1.0 + xi * xi) - xi);
}

} // namespace

StableStep stable_step(const Membrane& membrane, const State& s, std::span<const double> element_mass,
                       double shear_modulus)
{
  const Frequencies f = frequencies(membrane, s, element_mass, shear_modulus);
  const auto patch = std::max_element(f.patch.begin(), f.patch.end());
  const auto element = std::max_element(f.element.begin(), f.element.end());
  const int of_patch = membrane.corners.of(static_cast<std::size_t>(patch - f.patch.begin())).front() / 3;
  return {step_of(*patch + *element, membrane.damping_time),
          *patch > *element ? of_patch : static_cast<int>(element - f.element.begin())};
}

std::vector<double> selective_mass_factors(const Membrane& membrane, const State& s,
                                           std::span<const double> element_mass, double shear_modulus,
                                           double wanted)
{
  const Frequencies f = frequencies(membrane, s, element_mass, shear_modulus);
  const double worst_element = *std::max_element(f.element.begin(), f.element.end());
  const double worst_patch = *std::max_element(f.patch.begin(), f.patch.end());
  // Share the allowed square between patches and elements as they stand, then raise whoever is above its
  // share.
  double allowed = 4.0 / (wanted * wanted);
  while (step_of(allowed, membrane.damping_time) < wanted) allowed *= 0.999;
  const double patch_limit = allowed * worst_patch / (worst_patch + worst_element);
  const double element_limit = allowed * worst_element / (worst_patch + worst_element);
  std::vector<double> factor(element_mass.size(), 1.0);
  for (std::size_t e = 0; e < factor.size(); ++e) {
    factor[e] = std::max(1.0, f.element[e] / element_limit);
    for (const int n : membrane.triangles[e]) factor[e] = std::max(factor[e], f.patch[n] / patch_limit);
  }
  return factor;
}

} // namespace towform
