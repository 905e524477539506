#pragma once
#include "towform/surface_mesh.hpp"
#include <cmath>

namespace towform::test {

/// Two facets for each of n x n squares between points that stand in rows, normals towards +z.
inline void add_squares(SurfaceMesh& mesh, int n)
{
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = c - 1;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
}

/// A closed box, outward normals.
inline SurfaceMesh box(const Vec3& low, const Vec3& high)
{
  SurfaceMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.points.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// A closed sphere about the origin: `n` rings between the poles, 2n meridians.
inline SurfaceMesh sphere(double radius, int n)
{
  SurfaceMesh mesh;
  mesh.points.push_back({0, 0, -radius});
  for (int i = 1; i < n; ++i)
    for (int j = 0; j < 2 * n; ++j) {
      const double polar = M_PI * i / n, turn = M_PI * j / n;
      mesh.points.push_back({radius * std::sin(polar) * std::cos(turn),
                             radius * std::sin(polar) * std::sin(turn), -radius * std::cos(polar)});
    }
  mesh.points.push_back({0, 0, radius});
  const auto at = [n](int i, int j) {
    return i == 0 ? 0 : i == n ? 1 + (n - 1) * 2 * n : 1 + (i - 1) * 2 * n + j % (2 * n);
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < 2 * n; ++j) {
      if (i > 0) mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      if (i + 1 < n) mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
      if (i + 1 == n) mesh.triangles.back() = {at(i, j), at(i, j + 1), at(n, 0)};
    }
  return mesh;
}

} // namespace towform::test
