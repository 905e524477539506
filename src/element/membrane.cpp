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

namespace {
/// Marks nodes of mirror planes across which warp becomes weft (yarns at 45 degrees to the plane).
std::vector<char> nodes_that_exchange_yarns(const Blank& blank)
{
  std::vector<char> marks;
  const auto mark = [&](const Vec3& mirror, const std::vector<int>& nodes) {
    const Vec3 reflected = blank.warp - (2.0 * dot(blank.warp, mirror)) * mirror;
    if (std::abs(dot(reflected, blank.weft)) < 0.5) return;
    marks.resize(blank.mesh.points.size(), 0);
    for (const int n : nodes) marks[n] = 1;
  };
  if (!blank.mirror_x.empty()) mark({1, 0, 0}, blank.mirror_x);
  if (!blank.mirror_y.empty()) mark({0, 1, 0}, blank.mirror_y);
  return marks;
}
} // namespace

Membrane::Membrane(const Blank& blank, const YarnLaw& yarn_law, FabricLaw fabric_law)
    : triangles(blank.mesh.triangles), node_area(blank.mesh.points.size(), 0.0),
      corners(triangles, blank.mesh.points.size()), exchanging(nodes_that_exchange_yarns(blank)),
      reference_sine(dot(blank.warp, blank.weft)), thickness(blank.thickness), yarn(yarn_law),
      law(std::move(fabric_law))
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
}

double Membrane::yarn_energy(const State& s) const
{
  double sum = 0.0;
  for (std::size_t n = 0; n < node_area.size(); ++n)
    sum += (1.0 - own_strain_share) * node_area[n] *
           (yarn.energy(s.node_strain[n].warp) + yarn.energy(s.node_strain[n].weft));
  for (std::size_t e = 0; e < area.size(); ++e)
    sum += own_strain_share * area[e] *
           (yarn.energy(s.yarn_strain[e].warp) + yarn.energy(s.yarn_strain[e].weft));
  return sum;
}

void start(const Membrane& membrane, State& s)
{
  const std::size_t n = s.position.size(), m = membrane.triangles.size();
  s.node_strain.assign(n, {});
  s.node_tension.assign(n, {});
  s.yarn_strain.assign(m, {});
  s.sine.assign(m, membrane.reference_sine);
  s.shear.assign(m, {});
  s.corner_force.assign(3 * m, {});
  s.shear_work.assign(m, 0.0);
  s.shear_dissipated.assign(m, 0.0);
  s.yarn_damping.assign(n, 0.0);
}

namespace {

void element_strains(const Membrane& membrane, State& s, std::ptrdiff_t begin, std::ptrdiff_t end)
{
  for (std::ptrdiff_t e = begin; e < end; ++e) {
    const YarnVectors y(membrane.triangles[e], membrane.gradients[e], s.position);
    s.yarn_strain[e] = {y.lambda1 - 1.0, y.lambda2 - 1.0};
  }
}

void node_tensions(const Membrane& membrane, State& s, double dt, std::ptrdiff_t begin, std::ptrdiff_t end)
{
  const YarnLaw yarn = membrane.yarn;
  const double viscosity = yarn.stiffness * membrane.damping_time;
  for (std::ptrdiff_t n = begin; n < end; ++n) {
    YarnPair mean;
    for (const int e : membrane.corners.elements_of(n)) {
      mean.warp += membrane.area[e] * s.yarn_strain[e].warp;
      mean.weft += membrane.area[e] * s.yarn_strain[e].weft;
    }
    const double scale = 1.0 / (3.0 * membrane.node_area[n]);
    mean = {mean.warp * scale, mean.weft * scale};
    // The elements beyond such a mirror bring the other family.
    if (!membrane.exchanging.empty() && membrane.exchanging[n])
      mean.warp = mean.weft = 0.5 * (mean.warp + mean.weft);
    const YarnPair change = {mean.warp - s.node_strain[n].warp, mean.weft - s.node_strain[n].weft};
    const double rate_factor = viscosity / dt;
    s.node_tension[n] = {yarn.tension(mean.warp) + rate_factor * change.warp,
                         yarn.tension(mean.weft) + rate_factor * change.weft};
    s.yarn_damping[n] += (1.0 - membrane.own_strain_share) * membrane.node_area[n] * rate_factor *
                         (change.warp * change.warp + change.weft * change.weft);
    s.node_strain[n] = mean;
  }
}

template <class Law>
void element_forces(const Membrane& membrane, const Law& law, State& s, double dt, std::ptrdiff_t begin,
                    std::ptrdiff_t end)
{
  const double own = membrane.own_strain_share, shared = (1.0 - own) / 3.0;
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

    const YarnPair &t0 = s.node_tension[t[0]], &t1 = s.node_tension[t[1]], &t2 = s.node_tension[t[2]];
    const double tension_1 =
        shared * (t0.warp + t1.warp + t2.warp) + own * membrane.yarn.tension(s.yarn_strain[e].warp);
    const double tension_2 =
        shared * (t0.weft + t1.weft + t2.weft) + own * membrane.yarn.tension(s.yarn_strain[e].weft);
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
  const auto nodes = static_cast<std::ptrdiff_t>(s.position.size());
  const auto elements = static_cast<std::ptrdiff_t>(membrane.triangles.size());
  parallel_ranges(elements, [&](auto begin, auto end) { element_strains(membrane, s, begin, end); });
  parallel_ranges(nodes, [&](auto begin, auto end) { node_tensions(membrane, s, dt, begin, end); });
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
