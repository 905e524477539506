#pragma once
#include "towform/vec3.hpp"

namespace towform {

/// What one instruction loads, adds and stores.
using Vec4 = double __attribute__((vector_size(32)));

/// A vector in memory, aligned for the widest machine (a Vec4 alone is for the plainest); the last number is padding, 0.
struct alignas(32) Padded {
  Vec4 v{};

  /// Number by number: a vector made first would wait for its parts on the way through memory.
  void set(const Vec3& a)
  {
    v[0] = a.x;
    v[1] = a.y;
    v[2] = a.z;
  }
  [[nodiscard]] Vec3 vec3() const { return {v[0], v[1], v[2]}; }
};

} // namespace towform
