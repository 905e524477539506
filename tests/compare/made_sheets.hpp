#pragma once
#include "output/results_reader.hpp"
#include <cmath>

namespace towform::test {

/// A flat grid of squares 10 mm wide from (0, 0), each two triangles on its rising diagonal, not formed;
/// shear of both triangles of square (i, j) is i + 10 j degrees.
inline SheetResult board(int columns, int rows, Vec2 corner = {0, 0})
{
  SheetResult sheet;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i)
      sheet.flat.points.push_back({corner.x + 0.01 * i, corner.y + 0.01 * j, 0.0});
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const int a = j * (columns + 1) + i;
      sheet.flat.triangles.push_back({a, a + 1, a + columns + 2});
      sheet.flat.triangles.push_back({a, a + columns + 2, a + columns + 1});
      sheet.shear.insert(sheet.shear.end(), 2, i + 10.0 * j);
    }
  sheet.position = sheet.flat.points;
  sheet.frames = 1;
  return sheet;
}

/// A cap of a sphere of 100 mm radius about (20, 30, 40) mm, hanging down; the triangles between the polar
/// angles 5 k and 5 (k + 1) degrees have a shear of k degrees.
inline SheetResult cap(int rings)
{
  constexpr int around = 24;
  SheetResult sheet;
  const auto place = [](double polar, double azimuth) {
    return Vec3{0.02 + 0.1 * std::sin(polar) * std::cos(azimuth),
                0.03 + 0.1 * std::sin(polar) * std::sin(azimuth), 0.04 - 0.1 * std::cos(polar)};
  };
  sheet.flat.points.push_back(place(0.0, 0.0));
  for (int k = 1; k <= rings; ++k)
    for (int i = 0; i < around; ++i)
      sheet.flat.points.push_back(place(5.0 * k * M_PI / 180.0, 2.0 * M_PI * i / around));
  const auto node = [](int ring, int i) { return ring == 0 ? 0 : 1 + around * (ring - 1) + i % around; };
  for (int k = 0; k < rings; ++k)
    for (int i = 0; i < around; ++i) {
      sheet.flat.triangles.push_back({node(k, i), node(k + 1, i), node(k + 1, i + 1)});
      sheet.shear.push_back(k);
      if (k == 0) continue;
      sheet.flat.triangles.push_back({node(k, i), node(k + 1, i + 1), node(k, i + 1)});
      sheet.shear.push_back(k);
    }
  sheet.position = sheet.flat.points;
  sheet.frames = 1;
  return sheet;
}

} // namespace towform::test
