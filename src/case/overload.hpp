#pragma once

namespace towform {

/// One callable of several, for std::visit.
template <class... F>
struct Overload : F... {
  using F::operator()...;
};
template <class... F>
Overload(F...) -> Overload<F...>;

} // namespace towform
