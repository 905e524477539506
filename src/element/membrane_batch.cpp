#include "element/membrane_batch.hpp"
#include "element/arcsine.hpp"
#include "parallel/vector_clones.hpp"
#include <cmath>

namespace towform {

TOWFORM_VECTOR_CLONES
void yarn_vectors(MembraneBatch& b, int count)
{
  for (int i = 0; i < count; ++i) {
    const double a1x = b.warp_1[i] * b.d1x[i] + b.warp_2[i] * b.d2x[i];
    const double a1y = b.warp_1[i] * b.d1y[i] + b.warp_2[i] * b.d2y[i];
    const double a1z = b.warp_1[i] * b.d1z[i] + b.warp_2[i] * b.d2z[i];
    const double a2x = b.weft_1[i] * b.d1x[i] + b.weft_2[i] * b.d2x[i];
    const double a2y = b.weft_1[i] * b.d1y[i] + b.weft_2[i] * b.d2y[i];
    const double a2z = b.weft_1[i] * b.d1z[i] + b.weft_2[i] * b.d2z[i];
    const double lambda1 = std::sqrt(a1x * a1x + a1y * a1y + a1z * a1z);
    const double lambda2 = std::sqrt(a2x * a2x + a2y * a2y + a2z * a2z);
    const double inverse1 = 1.0 / lambda1, inverse2 = 1.0 / lambda2;
    b.lambda1[i] = lambda1;
    b.lambda2[i] = lambda2;
    b.f1x[i] = inverse1 * a1x;
    b.f1y[i] = inverse1 * a1y;
    b.f1z[i] = inverse1 * a1z;
    b.f2x[i] = inverse2 * a2x;
    b.f2y[i] = inverse2 * a2y;
    b.f2z[i] = inverse2 * a2z;
  }
}

TOWFORM_VECTOR_CLONES
void shear_angles(MembraneBatch& b, int count, double reference_angle)
{
  for (int i = 0; i < count; ++i) {
    const double dot = b.f1x[i] * b.f2x[i] + b.f1y[i] * b.f2y[i] + b.f1z[i] * b.f2z[i];
    const double below = dot > 1.0 ? 1.0 : dot;
    const double sine = below < -1.0 ? -1.0 : below;
    b.sine[i] = sine;
    b.angle[i] = arcsine(sine) - reference_angle;
  }
}

namespace {

TOWFORM_VECTOR_CLONES
int look_for_rates(const double* __restrict forces, double cells_per_radian, double modulus, double spring,
                   MembraneBatch& __restrict b, int count)
{
  int unsettled = 0;
  for (int i = 0; i < count; ++i) {
    const double trial = b.old_force[i] + modulus * (b.angle[i] - b.old_angle[i]);
    const double target = std::abs(trial);
    const auto [rate, open] =
        ShearTable::root(forces, cells_per_radian, b.angle[i], b.rate[i], target, spring);
    const double force = std::copysign(target - spring * rate, trial);
    b.rate[i] = rate;
    b.force[i] = force;
    b.lost[i] = std::abs(force) * rate;
    unsettled += open;
  }
  return unsettled;
}

} // namespace

void update(const ViscousLaw& law, MembraneBatch& b, int count, double dt)
{
  // A settled place stays as it is when it is looked at again.
  for (int round = 0; round < ViscousLaw::most_rounds; ++round)
    if (look_for_rates(law.surface->forces(), law.surface->cells_per_radian(), law.modulus, law.modulus * dt,
                       b, count) == 0)
      return;
}

TOWFORM_VECTOR_CLONES
void corner_forces(MembraneBatch& b, int count, double dt)
{
  for (int i = 0; i < count; ++i) {
    const double area = b.area[i], sine = b.sine[i], force = b.force[i];
    b.work[i] = area * 0.5 * (b.old_force[i] + force) * (sine - b.old_sine[i]);
    b.dissipated[i] = area * b.lost[i] * dt * std::sqrt(1.0 - sine * sine);
    const double n1 = force / b.lambda1[i], n2 = force / b.lambda2[i];
    // P . f01 and P . f02 times the area
    const double along1 = area * (b.tension_1[i] - n1 * sine), across1 = area * n1;
    const double along2 = area * (b.tension_2[i] - n2 * sine), across2 = area * n2;
    const double t1x = along1 * b.f1x[i] + across1 * b.f2x[i], t2x = along2 * b.f2x[i] + across2 * b.f1x[i];
    const double t1y = along1 * b.f1y[i] + across1 * b.f2y[i], t2y = along2 * b.f2y[i] + across2 * b.f1y[i];
    const double t1z = along1 * b.f1z[i] + across1 * b.f2z[i], t2z = along2 * b.f2z[i] + across2 * b.f1z[i];
    b.p1x[i] = -b.warp_1[i] * t1x - b.weft_1[i] * t2x;
    b.p1y[i] = -b.warp_1[i] * t1y - b.weft_1[i] * t2y;
    b.p1z[i] = -b.warp_1[i] * t1z - b.weft_1[i] * t2z;
    b.p2x[i] = -b.warp_2[i] * t1x - b.weft_2[i] * t2x;
    b.p2y[i] = -b.warp_2[i] * t1y - b.weft_2[i] * t2y;
    b.p2z[i] = -b.warp_2[i] * t1z - b.weft_2[i] * t2z;
  }
}

} // namespace towform
