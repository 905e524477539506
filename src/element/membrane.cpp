#include "element/membrane.hpp"
#include "parallel/parallel.hpp"
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace towform {

CornersOfNode::CornersOfNode(std::span<const Triangle> triangles, std::size_t nodes)
    : first(nodes + 1, 0), slot(3 * triangles.size())
{
  for (const Triangle& t : triangles)
    for (const int node : t) ++first[static_cast<std::size_t>(node) + 1];
  for (std::size_t i = 0; i < nodes; ++i) first[i + 1] += first[i];
  std::vector<int> next(first.begin(), first.end() - 1);
  for (std::size_t i = 0; i < slot.size(); ++i) slot[next[triangles[i / 3][i % 3]]++] = static_cast<int>(i);
  for (const int s : slot) element.push_back(s / 3);
}

Membrane::Membrane(const Blank& blank, const YarnLaw& yarn_law, FabricLaw fabric_law, YarnStrain yarn_strain)
    : triangles(blank.mesh.triangles), node_area(blank.mesh.points.size(), 0.0),
      corners(triangles, blank.mesh.points.size()), reference_sine(dot(blank.warp, blank.weft)),
      thickness(blank.thickness), yarn(yarn_law), law(std::move(fabric_law))
{
  gradients.reserve(triangles.size());
  area.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) {
    const Vec3 d1 = blank.mesh.points[b] - blank.mesh.points[a],
               d2 = blank.mesh.points[c] - blank.mesh.points[a];
    const double twice = d1.x * d2.y - d1.y * d2.x;
    if (!(twice > 0.0)) throw std::invalid_argument("a blank element has no area or is turned over");
    const Vec3 grad_1 = {d2.y / twice, -d2.x / twice, 0.0}, grad_2 = {-d1.y / twice, d1.x / twice, 0.0};
    gradients.push_back(
        {dot(grad_1, blank.warp), dot(grad_2, blank.warp), dot(grad_1, blank.weft), dot(grad_2, blank.weft)});
    area.push_back(0.5 * twice);
    for (const int node : {a, b, c}) node_area[node] += twice / 6.0;
  }
  const bool own =
      yarn_strain == YarnStrain::triangle || (yarn_strain == YarnStrain::automatic && follows_yarns(blank));
  strips = own ? strips_of_one(area) : lay_strips(blank, area);
}

double Membrane::yarn_energy(const State& s) const
{
  double sum = 0.0;
  for (std::size_t i = 0; i < strips.size(); ++i) sum += strips.area[i] * yarn.energy(s.strip_strain[i]);
  for (std::size_t i = 0; i < strips.of.size(); ++i) {
    const double apart = s.yarn_strain[i] - s.strip_strain[strips.of[i]];
    sum += 0.5 * own_stiffness * area[i / 2] * apart * apart;
  }
  return sum;
}

void start(const Membrane& membrane, State& s)
{
  const std::size_t m = membrane.triangles.size();
  s.strip_strain.assign(membrane.strips.size(), 0.0);
  s.strip_tension.assign(membrane.strips.size(), 0.0);
  s.yarn_strain.assign(2 * m, 0.0);
  s.sine.assign(m, membrane.reference_sine);
  s.shear.assign(m, {});
  s.corner_force.assign(3 * m, {});
  s.shear_work.assign(m, 0.0);
  s.shear_dissipated.assign(m, 0.0);
  s.yarn_damping.assign(membrane.strips.size(), 0.0);
}

namespace {

void element_strains(const Membrane& membrane, State& s, std::ptrdiff_t begin, std::ptrdiff_t end)
{
  for (std::ptrdiff_t e = begin; e < end; ++e) {
    const YarnVectors y(membrane.triangles[e], membrane.gradients[e], s.position);
    s.yarn_strain[2 * e] = y.lambda1 - 1.0;
    s.yarn_strain[2 * e + 1] = y.lambda2 - 1.0;
  }
}

void strip_tensions(const Membrane& membrane, State& s, double dt, std::ptrdiff_t begin, std::ptrdiff_t end)
{
  const YarnLaw yarn = membrane.yarn;
  const double damping = yarn.stiffness * membrane.damping_time / dt;
  for (std::ptrdiff_t i = begin; i < end; ++i) {
    double sum = 0.0;
    for (const YarnEntry entry : membrane.strips.entries_of(i))
      sum += membrane.area[entry / 2] * s.yarn_strain[entry];
    const double area = membrane.strips.area[i], mean = sum / area, change = mean - s.strip_strain[i];
    s.strip_tension[i] = yarn.tension(mean) + damping * change;
    s.yarn_damping[i] += area * damping * change * change;
    s.strip_strain[i] = mean;
  }
}

template <class Law>
void element_forces(const Membrane& membrane, const Law& law, State& s, double dt, std::ptrdiff_t begin,
                    std::ptrdiff_t end)
{
  const auto tension = [&, spring = membrane.own_stiffness](YarnEntry entry) {
    const int strip = membrane.strips.of[entry];
    return s.strip_tension[strip] + spring * (s.yarn_strain[entry] - s.strip_strain[strip]);
  };
  const double reference_angle = std::asin(membrane.reference_sine);
  for (std::ptrdiff_t e = begin; e < end; ++e) {
    const Triangle& t = membrane.triangles[e];
    const YarnGradients& g = membrane.gradients[e];
    const double area = membrane.area[e];
    const YarnVectors y(t, g, s.position);
    const double sine = std::clamp(dot(y.f1, y.f2), -1.0, 1.0);

    ShearPoint& p = s.shear[e];
    const double old_force = p.force;
    const double lost = law.update(p, std::asin(sine) - reference_angle, dt);
    s.shear_work[e] += area * 0.5 * (old_force + p.force) * (sine - s.sine[e]);
    s.shear_dissipated[e] += area * lost * dt * std::sqrt(1.0 - sine * sine);
    s.sine[e] = sine;

    const auto warp = static_cast<YarnEntry>(2 * e);
    const double tension_1 = tension(warp), tension_2 = tension(warp + 1);
    const double n1 = p.force / y.lambda1, n2 = p.force / y.lambda2;
    const Vec3 p1 = area * ((tension_1 - n1 * sine) * y.f1 + n1 * y.f2); // P . f01 times area
    const Vec3 p2 = area * ((tension_2 - n2 * sine) * y.f2 + n2 * y.f1);
    const Vec3 force_1 = -g.warp_1 * p1 - g.weft_1 * p2, force_2 = -g.warp_2 * p1 - g.weft_2 * p2;
    s.corner_force[3 * e] = -(force_1 + force_2);
    s.corner_force[3 * e + 1] = force_1;
    s.corner_force[3 * e + 2] = force_2;
  }
}

} // namespace

void membrane_forces(const Membrane& membrane, State& s, double dt)
{
  const auto strips = static_cast<std::ptrdiff_t>(membrane.strips.size());
  const auto elements = static_cast<std::ptrdiff_t>(membrane.triangles.size());
  parallel_ranges(elements, [&](auto begin, auto end) { element_strains(membrane, s, begin, end); });
  parallel_ranges(strips, [&](auto begin, auto end) { strip_tensions(membrane, s, dt, begin, end); });
  std::visit(
      [&](const auto& law) {
        parallel_ranges(elements,
                        [&](auto begin, auto end) { element_forces(membrane, law, s, dt, begin, end); });
      },
      membrane.law);
}

void assemble(const CornersOfNode& corners, std::span<const Vec3> corner_force, std::span<Vec3> force)
{
  parallel_ranges(static_cast<std::ptrdiff_t>(force.size()), [&](auto begin, auto end) {
    for (auto n = begin; n < end; ++n) {
      Vec3 sum;
      for (const int slot : corners.of(n)) sum += corner_force[slot];
      force[n] = sum;
    }
  });
}

} // namespace towform
