#include "bench/machine.hpp"
#include "parallel/vector_clones.hpp"

namespace towform {

TOWFORM_VECTOR_CLONES
void triad(double* a, const double* b, const double* c, double factor, std::size_t count)
{
#pragma GCC ivdep
  for (std::size_t i = 0; i < count; ++i) a[i] = b[i] + factor * c[i];
}

TOWFORM_VECTOR_CLONES
double multiply_and_add(int rounds)
{
  constexpr int chains = static_cast<int>(flops_a_round) / 2;
  double x[chains]; // NOLINT(modernize-avoid-c-arrays): plain loops over it vectorise
  for (int k = 0; k < chains; ++k) x[k] = 1.0 + 1e-3 * k;
  for (int i = 0; i < rounds; ++i)
    for (int k = 0; k < chains; ++k) x[k] = x[k] * 0.999 + 1e-3;
  double sum = 0.0;
  for (const double v : x) sum += v;
  return sum;
}

} // namespace towform
