#include "solver/statics.hpp"
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

namespace towform {

namespace {

using Eigen::VectorXd;
using Sparse = LinearConstraints::Sparse;

VectorXd held_places(const StaticsModel& model, double time)
{
  VectorXd p = model.constraints.held_part(model.reference);
  const auto& nodes = model.constraints.held_nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const HeldGroup& group = model.groups[nodes[i].group];
    if (!group.motion) continue;
    const double d = group.motion->displacement(time);
    p[2 * i] += d * group.direction.x;
    p[2 * i + 1] += d * group.direction.y;
  }
  return p;
}

/// An increment's trial: unknowns and everything that follows from them.
struct Trial {
  VectorXd q, p;
  std::vector<Vec3> position;
  std::vector<ShearPoint> shear;
  std::vector<double> lost;
  VectorXd force;       ///< 2n, of the sheet's stress at every node [N]
  VectorXd residual;    ///< on the unknowns [N]
  double largest = 0.0; ///< largest force of an element on a node [N]
  bool valid = false;
};

/// Seen from above, as it was in the flat sheet.
bool faces_up(const Quadrilateral& q, std::span<const Vec3> x)
{
  return cross(x[q[2]] - x[q[0]], x[q[3]] - x[q[1]]).z > 0.0;
}

class Increment {
public:
  Increment(const StaticsModel& model, const StaticsState& s, double dt) : model_(model), s_(s), dt_(dt) {}

  /// Forces at the trial's unknowns; the tangent if wanted.
  void evaluate(Trial& t, Sparse* tangent) const
  {
    const std::size_t elements = model_.membrane.elements.size();
    model_.constraints.place(t.q, t.p, t.position);
    t.force.setZero(2 * static_cast<Eigen::Index>(t.position.size()));
    t.largest = 0.0;
    t.valid = false;
    std::vector<Eigen::Triplet<double>> entries;
    if (tangent) entries.reserve(64 * elements);
    QuadrilateralMembrane::Vector f;
    QuadrilateralMembrane::Matrix k;
    for (std::size_t e = 0; e < elements; ++e) {
      if (!faces_up(model_.membrane.elements[e], t.position)) return;
      if (!model_.membrane.response(e, t.position, {dt_, s_.shear, t.shear, t.lost}, f,
                                    tangent ? &k : nullptr))
        return;
      t.largest = std::max(t.largest, f.lpNorm<Eigen::Infinity>());
      const Quadrilateral& nodes = model_.membrane.elements[e];
      for (int a = 0; a < 4; ++a) {
        t.force.segment<2>(2 * nodes[a]) += f.segment<2>(3 * a);
        if (!tangent) continue;
        for (int b = 0; b < 4; ++b)
          for (int i = 0; i < 2; ++i)
            for (int j = 0; j < 2; ++j)
              entries.emplace_back(2 * nodes[a] + i, 2 * nodes[b] + j, k(3 * a + i, 3 * b + j));
      }
    }
    t.residual = model_.constraints.free.transpose() * t.force;
    t.valid = true;
    if (!tangent) return;
    tangent->resize(t.force.size(), t.force.size());
    tangent->setFromTriplets(entries.begin(), entries.end());
  }

private:
  const StaticsModel& model_;
  const StaticsState& s_;
  double dt_;
};

double extent(std::span<const Vec3> points)
{
  double most = 0.0;
  for (const Vec3& x : points) most = std::max({most, std::abs(x.x), std::abs(x.y)});
  return 2.0 * most;
}

/// Moves along the correction until the work of the residual over it is small enough; false when nothing
/// helps.
bool search(const Increment& increment, Trial& t, const VectorXd& correction)
{
  constexpr int trials = 8;
  constexpr double enough = 0.8;
  const VectorXd from = t.q;
  const double work = correction.dot(t.residual), norm = t.residual.norm();
  double part = 1.0;
  for (int i = 0; i < trials; ++i) {
    t.q = from + part * correction;
    increment.evaluate(t, nullptr);
    const double left = t.valid ? correction.dot(t.residual) : 0.0;
    if (t.valid && (std::abs(left) <= enough * std::abs(work) || t.residual.norm() < norm)) return true;
    const double secant = t.valid && left != work ? part * work / (work - left) : 0.0;
    part = std::clamp(secant, 0.1 * part, 0.5 * part);
  }
  return t.valid;
}

void commit(const StaticsModel& model, StaticsState& s, double dt, Trial& t)
{
  const VectorXd moved = t.p - model.constraints.held_part(s.position);
  const VectorXd held_force = model.constraints.held.transpose() * t.force;
  s.external_work += 0.5 * (s.held_force + held_force).dot(moved);
  s.held_force = held_force;
  std::fill(s.group_force.begin(), s.group_force.end(), 0.0);
  for (std::size_t i = 0; i < model.constraints.held_nodes.size(); ++i) {
    const int group = model.constraints.held_nodes[i].group;
    const Vec3& direction = model.groups[group].direction;
    s.group_force[group] += held_force[2 * i] * direction.x + held_force[2 * i + 1] * direction.y;
  }
  s.largest_turn = 0.0;
  const double reference_angle = std::asin(model.membrane.reference_sine);
  for (std::size_t k = 0; k < s.shear.size(); ++k) {
    const ShearPoint &old = s.shear[k], &now = t.shear[k];
    const double from = old.angle + reference_angle, to = now.angle + reference_angle;
    const double mean_force = 0.5 * (old.force + now.force), area = model.membrane.points[k].area;
    s.shear_work += area * mean_force * (std::sin(to) - std::sin(from));
    // The dashpot's mean rate under the mean force: what is left is the spring's energy.
    if (now.force != 0.0)
      s.shear_dissipated += area * t.lost[k] * mean_force / now.force * dt * std::cos(0.5 * (from + to));
    s.largest_turn = std::max(s.largest_turn, std::abs(to - from));
  }
  for (std::size_t n = 0; n < s.position.size(); ++n)
    s.velocity[n] = (1.0 / dt) * (t.position[n] - s.position[n]);
  s.position.swap(t.position);
  s.shear.swap(t.shear);
  s.time += dt;
  s.last_dt = dt;
  ++s.step;
}

int worst_node(const LinearConstraints& constraints, const VectorXd& residual)
{
  Eigen::Index at = 0;
  residual.cwiseAbs().maxCoeff(&at);
  return constraints.free_nodes[static_cast<std::size_t>(at) / 2];
}

} // namespace

StaticsState start(const StaticsModel& model)
{
  StaticsState s;
  s.position = model.reference;
  s.velocity.assign(s.position.size(), {});
  s.shear.assign(model.membrane.points.size(), {});
  s.held_force.setZero(2 * static_cast<Eigen::Index>(model.constraints.held_nodes.size()));
  s.group_force.assign(model.groups.size(), 0.0);
  return s;
}

NewtonReport advance(const StaticsModel& model, StaticsState& s, double dt, const NewtonControls& controls)
{
  const LinearConstraints& c = model.constraints;
  const Increment increment(model, s, dt);
  // The first guess goes on at the last speed; what the held nodes then lack is in the first correction.
  Trial t;
  t.q = c.free_part(s.position) + dt * c.free_part(s.velocity);
  t.p = c.held_part(s.position) + dt * c.held_part(s.velocity);
  VectorXd lacking = held_places(model, s.time + dt) - t.p;
  t.position = s.position;
  t.shear = s.shear;
  t.lost.resize(s.shear.size());
  if (t.q.size() == 0) t.p += lacking; // nothing to solve for

  const double size = extent(model.reference);
  // Below this, forces are rounding errors of stretches.
  const double least_force = 1e-14 * model.membrane.yarn.stiffness * size;
  NewtonReport report;
  double corrected = t.q.size() == 0 ? 0.0 : HUGE_VAL;
  Sparse tangent;
  Eigen::SimplicialLDLT<Sparse> solver;
  while (true) {
    increment.evaluate(t, &tangent);
    if (!t.valid) return report;
    const double largest = t.residual.size() > 0 ? t.residual.lpNorm<Eigen::Infinity>() : 0.0;
    report.residual_force = largest;
    report.residuals.push_back(t.largest > 0.0 ? largest / t.largest : 0.0);
    const bool in_place = lacking.isZero(0.0) || t.q.size() == 0;
    if (t.residual.size() > 0) report.worst_node = worst_node(c, t.residual);
    if (in_place && largest <= std::max(controls.residual * t.largest, least_force) &&
        corrected <= controls.correction * size)
      break;
    if (report.iterations == controls.max_iterations) return report;

    const Sparse reduced = c.free.transpose() * tangent * c.free;
    solver.compute(reduced);
    if (solver.info() != Eigen::Success) return report;
    report.negative_pivots = static_cast<int>((solver.vectorD().array() < 0.0).count());
    VectorXd correction;
    if (in_place) {
      correction = solver.solve(-t.residual);
      if (!correction.allFinite() || !search(increment, t, correction)) return report;
    } else {
      correction = solver.solve(-t.residual - c.free.transpose() * (tangent * (c.held * lacking)));
      t.q += correction;
      t.p += lacking;
      lacking.setZero();
    }
    corrected = correction.lpNorm<Eigen::Infinity>();
    ++report.iterations;
  }
  report.converged = true;
  commit(model, s, dt, t);
  return report;
}

} // namespace towform
