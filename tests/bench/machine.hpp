#pragma once
#include <cstddef>

namespace towform {

/// a[i] = b[i] + factor c[i].
void triad(double* a, const double* b, const double* c, double factor, std::size_t count);

/// Chains of multiplications and additions in registers, `flops_a_round` a round; returns what they come to.
double multiply_and_add(int rounds);
constexpr double flops_a_round = 128.0;

} // namespace towform
