#pragma once
#include <cfenv>

#if !defined(TOWFORM_FLOAT_TRAPS) || !defined(__GLIBC__)
#undef TOWFORM_FLOAT_TRAPS
#define TOWFORM_FLOAT_TRAPS 0
#endif

namespace towform {

/// Where CMake's TOWFORM_FLOAT_TRAPS is on (preset debug), on glibc: from here on an operation that makes a
/// NaN, divides by zero or overflows ends the program with SIGFPE where it happens, on this thread and on
/// those it starts. Nothing otherwise.
inline void trap_floats()
{
#if TOWFORM_FLOAT_TRAPS
  feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
#endif
}

/// No traps while this lives, for code that judges numbers from outside: comparing with a NaN traps as well.
class UntrappedFloats {
public:
#if TOWFORM_FLOAT_TRAPS
  UntrappedFloats() { std::feholdexcept(&before_); }
  ~UntrappedFloats() { std::fesetenv(&before_); }
#else
  UntrappedFloats() {}
  ~UntrappedFloats() {}
#endif
  UntrappedFloats(const UntrappedFloats&) = delete;
  UntrappedFloats& operator=(const UntrappedFloats&) = delete;

private:
#if TOWFORM_FLOAT_TRAPS
  std::fenv_t before_;
#endif
};

} // namespace towform
