#include "element/stable_step.hpp"
#include <algorithm>
#include <array>
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

double largest(const std::vector<double>& v)
{
  return v.empty() ? 0.0 : *std::max_element(v.begin(), v.end());
}

} // namespace

StepBound::StepBound(const Membrane& membrane, std::span<const double> element_mass, double shear_modulus,
                     std::span<const Bending> bending)
    : membrane_(membrane), element_mass_(element_mass.begin(), element_mass.end()),
      shear_modulus_(shear_modulus)
{
  // First with equal shares of every element's mass for its three patches, then in proportion to their need.
  const std::size_t nodes = membrane.node_area.size();
  std::vector<double> share(3 * element_mass.size(), 1.0 / 3.0), need(nodes);
  patch_.resize(nodes);
  constexpr int rounds = 4;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t n = 0; n < nodes; ++n) {
      patch_[n] = patch_sums(n, share);
      need[n] = patch_frequency(n, membrane.reference_sine);
    }
    if (round == rounds - 1) break;
    for (std::size_t e = 0; e < element_mass.size(); ++e) {
      const Triangle& t = membrane.triangles[e];
      double sum = 0.0;
      for (int c = 0; c < 3; ++c) sum += share[3 * e + c] *= need[t[c]];
      for (int c = 0; c < 3; ++c) share[3 * e + c] /= sum;
    }
  }
  if (bending.empty()) return;
  std::vector<double> mass(nodes, 0.0);
  for (std::size_t e = 0; e < element_mass.size(); ++e)
    for (const int n : membrane.triangles[e]) mass[n] += element_mass[e] / 3.0;
  bending_.assign(nodes, 0.0);
  for (const Bending& b : bending) {
    const std::vector<double> bound = b.frequency_bound(mass);
    for (std::size_t n = 0; n < nodes; ++n) bending_[n] += bound[n];
    bending_damping_time_ = std::max(bending_damping_time_, b.damping_time);
  }
}

double StepBound::step_of(double in_plane, double of_bending) const
{
  const double omega_squared = in_plane + of_bending, omega = std::sqrt(omega_squared);
  double damping_time = membrane_.damping_time;
  if (of_bending > 0.0)
    damping_time = (damping_time * in_plane + bending_damping_time_ * of_bending) / omega_squared;
  const double xi = 0.5 * damping_time * omega;
  return 2.0 / omega * (std::sqrt(1.0 + xi * xi) - xi);
}

StepBound::Sums StepBound::patch_sums(std::size_t n, std::span<const double> share) const
{
  struct Row {
    int node;
    double warp, weft, mass;
  };
  std::vector<Row> rows; // a handful of nodes: linear search
  for (const int slot : membrane_.corners.of(n)) {
    const int e = slot / 3;
    const auto gradients = corner_gradients(membrane_.gradients[e]);
    const double weight = membrane_.area[e] / (3.0 * membrane_.node_area[n]);
    for (int c = 0; c < 3; ++c) {
      const int node = membrane_.triangles[e][c];
      auto row = std::find_if(rows.begin(), rows.end(), [node](const Row& r) { return r.node == node; });
      if (row == rows.end()) row = rows.insert(rows.end(), Row{node, 0.0, 0.0, 0.0});
      row->warp += weight * gradients[c].warp;
      row->weft += weight * gradients[c].weft;
      row->mass += share[slot] * element_mass_[e] / 3.0;
    }
  }
  Sums sums;
  for (const Row& r : rows) {
    sums.warp += r.warp * r.warp / r.mass;
    sums.weft += r.weft * r.weft / r.mass;
    sums.both += r.warp * r.weft / r.mass;
  }
  return sums;
}

/// omega^2 of the averaged yarn strains round a node.
double StepBound::patch_frequency(std::size_t n, double sine) const
{
  const double stiffness =
      membrane_.yarn.stiffness * (1.0 - membrane_.own_strain_share) * membrane_.node_area[n];
  return stiffness * largest(patch_[n].warp, patch_[n].weft, patch_[n].both * sine);
}

/// omega^2 of an element's own yarn strains and shear, bounded by the sum of both.
double StepBound::element_frequency(const State& s, std::size_t e) const
{
  const YarnVectors y(membrane_.triangles[e], membrane_.gradients[e], s.position);
  double warp = 0.0, weft = 0.0, both = 0.0;
  for (const YarnPair& g : corner_gradients(membrane_.gradients[e])) {
    warp += g.warp * g.warp;
    weft += g.weft * g.weft;
    both += g.warp * g.weft;
  }
  const double sine = dot(y.f1, y.f2), cosine = std::sqrt(std::max(0.0, 1.0 - sine * sine));
  const double yarns =
      membrane_.own_strain_share * membrane_.yarn.stiffness * largest(warp, weft, both * sine);
  const double shear = shear_modulus_ * cosine *
                       (warp / (y.lambda1 * y.lambda1) + weft / (y.lambda2 * y.lambda2) -
                        2.0 * sine * both / (y.lambda1 * y.lambda2));
  return 3.0 * membrane_.area[e] / element_mass_[e] * (yarns + shear);
}

StepBound::Frequencies StepBound::frequencies(const State& s) const
{
  Frequencies f{std::vector<double>(patch_.size()), std::vector<double>(element_mass_.size())};
  for (std::size_t n = 0; n < f.patch.size(); ++n) {
    double sine = 0.0; // the largest around the node: the two families add most where they are least square
    for (const int slot : membrane_.corners.of(n)) {
      const double of_element = s.sine.empty() ? membrane_.reference_sine : s.sine[slot / 3];
      if (std::abs(of_element) > std::abs(sine)) sine = of_element;
    }
    f.patch[n] = patch_frequency(n, sine);
  }
  for (std::size_t e = 0; e < f.element.size(); ++e) f.element[e] = element_frequency(s, e);
  return f;
}

StableStep StepBound::at(const State& s) const
{
  const Frequencies f = frequencies(s);
  const double patch = largest(f.patch), element = largest(f.element), bending = largest(bending_);
  const auto place = [](const std::vector<double>& v) {
    return static_cast<std::size_t>(std::max_element(v.begin(), v.end()) - v.begin());
  };
  const auto at_node = [&](std::size_t n) { return membrane_.corners.of(n).front() / 3; };
  int limiting = static_cast<int>(place(f.element));
  if (patch > element) limiting = at_node(place(f.patch));
  if (bending > std::max(patch, element)) limiting = at_node(place(bending_));
  return {step_of(patch + element, bending), limiting};
}

std::vector<double> StepBound::mass_factors(const State& s, double wanted) const
{
  const Frequencies f = frequencies(s);
  const double element = largest(f.element), patch = largest(f.patch), bending = largest(bending_);
  const double sum = patch + element + bending;
  // Share the allowed square between patches, elements and bending as they stand, then raise whoever is above
  // its share.
  double allowed = 4.0 / (wanted * wanted);
  while (step_of(allowed * ((patch + element) / sum), allowed * (bending / sum)) < wanted) allowed *= 0.999;
  const double patch_limit = allowed * patch / sum, element_limit = allowed * element / sum;
  const double bending_limit = allowed * bending / sum;
  std::vector<double> factor(element_mass_.size(), 1.0);
  for (std::size_t e = 0; e < factor.size(); ++e) {
    factor[e] = std::max(1.0, f.element[e] / element_limit);
    for (const int n : membrane_.triangles[e]) {
      factor[e] = std::max(factor[e], f.patch[n] / patch_limit);
      if (bending > 0.0) factor[e] = std::max(factor[e], bending_[n] / bending_limit);
    }
  }
  return factor;
}

} // namespace towform
