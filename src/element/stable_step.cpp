#include "element/stable_step.hpp"
#include "element/element_frequency.hpp"
#include "element/membrane_work.hpp"
#include "element/strip_parts.hpp"
#include "parallel/parallel.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace towform {

namespace {

double largest(const std::vector<double>& v)
{
  return v.empty() ? 0.0 : *std::max_element(v.begin(), v.end());
}

} // namespace

StepBound::StepBound(const Membrane& membrane, const SheetMass& mass, double shear_modulus, std::span<const Bending> bending)
    : membrane_(membrane), mass_(mass), shear_modulus_(shear_modulus)
{
  std::vector<double> thirds(mass.node.size(), 0.0);
  for (std::size_t e = 0; e < mass.element.size(); ++e)
    for (const int n : membrane.triangles[e]) thirds[n] += mass.element[e] / 3.0;
  for (std::size_t n = 0; n < thirds.size(); ++n) least_share_ = std::min(least_share_, mass.node[n] / thirds[n]);
  share_masses();
  if (bending.empty()) return;
  bending_.assign(mass.node.size(), 0.0);
  for (const Bending& b : bending) {
    const std::vector<double> bound = b.frequency_bound(mass.node);
    for (std::size_t n = 0; n < bound.size(); ++n) bending_[n] += bound[n];
    bending_damping_time_ = std::max(bending_damping_time_, b.damping_time);
  }
}

/// Divides every node's mass in proportion to the strips' need, which follows from the division: a few
/// rounds.
void StepBound::share_masses()
{
  using Part = StripParts::Part;
  const StripParts parts(membrane_);
  const std::size_t strips = membrane_.strips.size();
  std::vector<double> claims(2 * mass_.node.size());
  std::vector<double> weight(strips, 1.0);
  strip_frequency_.resize(strips);
  constexpr int rounds = 6;
  for (int round = 0; round < rounds; ++round) {
    std::fill(claims.begin(), claims.end(), 0.0);
    for (std::size_t i = 0; i < strips; ++i)
      for (const Part& p : parts.of(i)) claims[p.component] += weight[i] * std::abs(p.gradient);
    for (std::size_t i = 0; i < strips; ++i) {
      double sum = 0.0; // of gradient^2 over the share of mass, weight |gradient| / claims of it
      for (const Part& p : parts.of(i))
        sum += std::abs(p.gradient) * claims[p.component] / (weight[i] * mass_.node[p.component / 2]);
      strip_frequency_[i] = membrane_.yarn.stiffness * membrane_.strips.area[i] * sum;
    }
    for (std::size_t i = 0; i < strips; ++i) weight[i] *= std::sqrt(strip_frequency_[i]);
    const double largest_weight = *std::max_element(weight.begin(), weight.end());
    for (double& w : weight) w /= largest_weight;
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

void StepBound::find_element_frequencies(const State& s, std::vector<double>& squared) const
{
  const ElementBlocks& blocks = membrane_.blocks;
  const OwnStiffness stiffness{membrane_.own_stiffness, shear_modulus_};
  squared.resize(mass_.element.size());
  parallel_each(blocks.count(), [&](int number) {
    static thread_local const std::unique_ptr<Workplace> workplace = std::make_unique<Workplace>();
    Workplace& w = *workplace;
    const ElementBlocks::Block& block = blocks.blocks[number];
    w.take(blocks.slots.points(block.nodes), s.position);
    for (const MembraneBatches::Batch& b : membrane_.batches.own(number)) {
      const MembraneCoefficients c = membrane_.batches.coefficients(b);
      const std::ptrdiff_t e = block.first_element + b.first;
      gather_edges(w.position.data(), blocks.corners(block) + 3 * b.first, b.count, w.batch);
      yarn_vectors(c, w.batch, b.first, b.count, w.lanes);
      shear_angles(w.lanes, b.first, b.count, 0.0, w.batch);
      element_frequencies(c, stiffness, w.lanes, b.first, b.count, w.batch, mass_.element.data() + e, squared.data() + e);
    }
  });
  for (double& of_element : squared) of_element /= least_share_;
}

StepBound::Frequencies StepBound::frequencies(const State& s) const
{
  Frequencies f{strip_frequency_, {}};
  std::vector<double> steepest(membrane_.node_area.size(),
                               std::abs(membrane_.reference_sine)); // |sine| round a node
  if (!s.sine.empty()) // else the flat sheet
    for (std::size_t e = 0; e < s.sine.size(); ++e)
      for (const int n : membrane_.triangles[e]) steepest[n] = std::max(steepest[n], std::abs(s.sine[e]));
  std::vector<double> steepest_of_strip(f.strip.size(), 0.0);
  for (std::size_t e = 0; e < membrane_.triangles.size(); ++e) {
    const auto& [a, b, c] = membrane_.triangles[e];
    const double sine = std::max({steepest[a], steepest[b], steepest[c]});
    for (const int strip : {membrane_.strips.of[2 * e], membrane_.strips.of[2 * e + 1]})
      steepest_of_strip[strip] = std::max(steepest_of_strip[strip], sine);
  }
  for (std::size_t i = 0; i < f.strip.size(); ++i) f.strip[i] *= 1.0 + steepest_of_strip[i];
  find_element_frequencies(s, f.element);
  return f;
}

StableStep StepBound::at(const State& s) const
{
  const Frequencies f = frequencies(s);
  const double strip = largest(f.strip), element = largest(f.element), bending = largest(bending_);
  const auto place = [](const std::vector<double>& v) {
    return static_cast<std::size_t>(std::max_element(v.begin(), v.end()) - v.begin());
  };
  int limiting = static_cast<int>(place(f.element));
  if (strip > element) {
    const std::vector<int>& of = membrane_.strips.of;
    limiting = static_cast<int>(std::find(of.begin(), of.end(), static_cast<int>(place(f.strip))) - of.begin()) / 2;
  }
  if (bending > std::max(strip, element)) {
    const std::span<const Triangle> all = membrane_.triangles;
    const auto node = static_cast<int>(place(bending_));
    const auto holds_node = [node](const Triangle& t) { return std::find(t.begin(), t.end(), node) != t.end(); };
    limiting = static_cast<int>(std::find_if(all.begin(), all.end(), holds_node) - all.begin());
  }
  return {step_of(strip + element, bending), limiting};
}

std::vector<double> StepBound::mass_factors(const State& s, double wanted) const
{
  const Frequencies f = frequencies(s);
  const double element = largest(f.element), strip = largest(f.strip), bending = largest(bending_);
  const double sum = strip + element + bending;
  // Share the allowed square between strips, elements and bending as they stand, then raise whoever is above
  // its share.
  double allowed = 4.0 / (wanted * wanted);
  while (step_of(allowed * ((strip + element) / sum), allowed * (bending / sum)) < wanted) allowed *= 0.999;
  const double strip_limit = allowed * strip / sum, element_limit = allowed * element / sum;
  const double bending_limit = allowed * bending / sum;
  std::vector<double> node(membrane_.node_area.size(), 1.0);
  for (std::size_t entry = 0; entry < membrane_.strips.of.size(); ++entry)
    for (const int n : membrane_.triangles[entry / 2])
      node[n] = std::max(node[n], f.strip[membrane_.strips.of[entry]] / strip_limit);
  std::vector<double> factor(mass_.element.size());
  for (std::size_t e = 0; e < factor.size(); ++e) {
    factor[e] = std::max(1.0, f.element[e] / element_limit);
    for (const int n : membrane_.triangles[e]) {
      factor[e] = std::max(factor[e], node[n]);
      if (bending > 0.0) factor[e] = std::max(factor[e], bending_[n] / bending_limit);
    }
  }
  return factor;
}

} // namespace towform
