#pragma once
#include "towform/blank.hpp"
#include <array>
#include <compare>
#include <map>
#include <span>
#include <vector>

namespace towform {

/// Whether every triangle has an edge along the warp and one along the weft.
bool follows_yarns(const Blank& blank);

/// A strip of yarn before it is numbered: row across the yarns, column along them, level by element size.
struct StripCell {
  int level, family, row, column;
  auto operator<=>(const StripCell&) const = default; // NOLINT(modernize-use-nullptr): none is used
};

/// How strips of yarn (YarnStrips) lie on the flat blank, the whole one where it is a half or a quarter.
class StripLattice {
public:
  /// Of elements with these `edge`s, as long as those of their surroundings [m]. The blank must outlive this.
  StripLattice(const Blank& blank, std::span<const double> edge);

  struct Place {
    StripCell cell;
    int times; ///< how often an entry there counts: its mirror images in the same cell, and itself
  };
  /// The cell of a yarn family of an element, or the one of its mirror images that comes first.
  [[nodiscard]] Place place(std::size_t element, int family) const;

private:
  using Corners = std::array<Vec3, 3>;
  /// A row of triangles on one side of a line of yarn, as one of them sees it.
  struct Row {
    int number;
    double middle; ///< of its edge on the line, along the yarn [m]
    bool shifted;   ///< its strips, by half a length: of both rows on a line the one nearer to the middle of the blank
    bool on_middle; ///< both rows on its line are as far from the middle
  };
  /// Where a row begins and ends along the yarn [m].
  struct Ends {
    double low, high;
  };

  [[nodiscard]] Corners corners(std::size_t element) const;
  [[nodiscard]] int level(double edge) const;
  [[nodiscard]] int exchanged(int family, const Vec3& mirror) const;
  template <class Visit>
  void each_image(const Corners& corners, int family, const Visit& visit) const;
  [[nodiscard]] Row row(const Corners& corners, int family, int level) const;
  void measure_rows();
  [[nodiscard]] StripCell cell(const Corners& corners, int family, int level) const;
  [[nodiscard]] StripCell cell_of_row(const Corners& corners, int family, int level) const;

  const Blank& blank_;
  std::vector<int> level_; // of each element
  double edge_;
  bool aligned_;
  std::array<Vec3, 2> along_, across_;
  std::array<double, 2> line_{};    // from one line of yarn to the next [m], where the mesh follows them
  std::array<double, 2> element_{}; // along it [m]
  std::map<std::array<int, 3>, Ends> ends_; // by level, family and number of the row
  std::vector<Vec3> mirrors_;
};

} // namespace towform
