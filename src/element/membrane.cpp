#include "element/membrane.hpp"
#include "element/arcsine.hpp"
#include "element/membrane_batch.hpp"
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

/// Fills the first places of a batch with what yarn vectors are made of.
void gather_edges(const Membrane& membrane, std::span<const Vec3> position, std::ptrdiff_t first, int count,
                  MembraneBatch& b)
{
  for (int i = 0; i < count; ++i) {
    const Triangle& t = membrane.triangles[first + i];
    const Vec3 d1 = position[t[1]] - position[t[0]], d2 = position[t[2]] - position[t[0]];
    b.d1x[i] = d1.x;
    b.d1y[i] = d1.y;
    b.d1z[i] = d1.z;
    b.d2x[i] = d2.x;
    b.d2y[i] = d2.y;
    b.d2z[i] = d2.z;
    const YarnGradients& g = membrane.gradients[first + i];
    b.warp_1[i] = g.warp_1;
    b.warp_2[i] = g.warp_2;
    b.weft_1[i] = g.weft_1;
    b.weft_2[i] = g.weft_2;
  }
}

/// work(first, count) on batches of elements.
template <class Work>
void in_batches(std::ptrdiff_t begin, std::ptrdiff_t end, const Work& work)
{
  for (std::ptrdiff_t first = begin; first < end; first += MembraneBatch::size)
    work(first, static_cast<int>(std::min<std::ptrdiff_t>(MembraneBatch::size, end - first)));
}

void element_strains(const Membrane& membrane, State& s, std::ptrdiff_t begin, std::ptrdiff_t end)
{
  MembraneBatch b;
  in_batches(begin, end, [&](std::ptrdiff_t first, int count) {
    gather_edges(membrane, s.position, first, count, b);
    yarn_vectors(b, count);
    double* strain = s.yarn_strain.data() + 2 * first;
    for (int i = 0; i < count; ++i) {
      strain[2 * i] = b.lambda1[i] - 1.0;
      strain[2 * i + 1] = b.lambda2[i] - 1.0;
    }
  });
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

/// Tensions and the law's points of some elements.
void gather_state(const Membrane& membrane, const State& s, std::ptrdiff_t first, int count, MembraneBatch& b)
{
  const auto tension = [&, spring = membrane.own_stiffness](std::ptrdiff_t entry) {
    const int strip = membrane.strips.of[entry];
    return s.strip_tension[strip] + spring * (s.yarn_strain[entry] - s.strip_strain[strip]);
  };
  for (int i = 0; i < count; ++i) {
    const std::ptrdiff_t e = first + i;
    b.area[i] = membrane.area[e];
    b.old_sine[i] = s.sine[e];
    const ShearPoint& p = s.shear[e];
    b.old_angle[i] = p.angle;
    b.old_force[i] = p.force;
    b.rate[i] = p.rate;
    b.tension_1[i] = tension(2 * e);
    b.tension_2[i] = tension(2 * e + 1);
  }
}

void store(const MembraneBatch& b, std::ptrdiff_t first, int count, State& s)
{
  for (int i = 0; i < count; ++i) {
    const std::ptrdiff_t e = first + i;
    s.sine[e] = b.sine[i];
    s.shear[e] = {b.angle[i], b.force[i], b.rate[i]};
    s.shear_work[e] += b.work[i];
    s.shear_dissipated[e] += b.dissipated[i];
    const Vec3 force_1{b.p1x[i], b.p1y[i], b.p1z[i]}, force_2{b.p2x[i], b.p2y[i], b.p2z[i]};
    s.corner_force[3 * e] = -(force_1 + force_2);
    s.corner_force[3 * e + 1] = force_1;
    s.corner_force[3 * e + 2] = force_2;
  }
}

/// Any law, point by point.
template <class Law>
void update(const Law& law, MembraneBatch& b, int count, double dt)
{
  for (int i = 0; i < count; ++i) {
    ShearPoint p{b.old_angle[i], b.old_force[i], b.rate[i]};
    b.lost[i] = law.update(p, b.angle[i], dt);
    b.force[i] = p.force;
    b.rate[i] = p.rate;
  }
}

template <class Law>
void element_forces(const Membrane& membrane, const Law& law, State& s, double dt, std::ptrdiff_t begin,
                    std::ptrdiff_t end)
{
  const double reference_angle = arcsine(membrane.reference_sine);
  MembraneBatch b;
  in_batches(begin, end, [&](std::ptrdiff_t first, int count) {
    gather_edges(membrane, s.position, first, count, b);
    gather_state(membrane, s, first, count, b);
    yarn_vectors(b, count);
    shear_angles(b, count, reference_angle);
    update(law, b, count, dt);
    corner_forces(b, count, dt);
    store(b, first, count, s);
  });
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
