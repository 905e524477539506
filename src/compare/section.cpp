#include "compare/section.hpp"
#include <algorithm>
#include <array>
#include <cmath>

namespace towform {

namespace {

using Edge = std::array<int, 2>; // lower node first

/// What the plane cuts out of one triangle: between two of its edges.
struct Cut {
  int element;
  std::array<Edge, 2> edges;
  std::array<Vec3, 2> ends;
};

class Cutter {
public:
  Cutter(std::span<const Vec3> places, Vec2 from, Vec2 to) : places_(places), from_(from)
  {
    length_ = std::hypot(to.x - from.x, to.y - from.y);
    way_ = {(to.x - from.x) / length_, (to.y - from.y) / length_};
    double extent = length_;
    for (const Vec3& p : places) extent = std::max({extent, std::abs(p.x - from.x), std::abs(p.y - from.y)});
    on_plane_ = 1e-9 * extent;
  }

  [[nodiscard]] double along(const Vec3& p) const
  {
    return way_.x * (p.x - from_.x) + way_.y * (p.y - from_.y);
  }
  [[nodiscard]] double length() const { return length_; }

  /// Nodes on the plane count as on its left or right: so every triangle that is cut at all is cut across two
  /// edges.
  [[nodiscard]] std::vector<Cut> cuts(std::span<const Triangle> triangles, bool on_is_left) const
  {
    std::vector<Cut> cuts;
    for (std::size_t e = 0; e < triangles.size(); ++e) {
      Cut cut{static_cast<int>(e), {}, {}};
      std::size_t found = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = std::min(triangles[e][k], triangles[e][(k + 1) % 3]);
        const int b = std::max(triangles[e][k], triangles[e][(k + 1) % 3]);
        const double left_a = left(a), left_b = left(b);
        const auto is_left = [&](double d) { return d > 0.0 || (d == 0.0 && on_is_left); };
        if (is_left(left_a) == is_left(left_b) || found == 2) continue;
        const double share = left_a / (left_a - left_b);
        cut.edges[found] = {a, b};
        cut.ends[found++] = (1.0 - share) * places_[a] + share * places_[b];
      }
      if (found == 2) cuts.push_back(cut);
    }
    return cuts;
  }

private:
  /// Distance of a node to the left of the plane.
  [[nodiscard]] double left(int n) const
  {
    const double d = way_.x * (places_[n].y - from_.y) - way_.y * (places_[n].x - from_.x);
    return std::abs(d) <= on_plane_ ? 0.0 : d;
  }

  std::span<const Vec3> places_;
  Vec2 from_, way_;
  double length_ = 0.0, on_plane_ = 0.0;
};

using Chain = std::vector<SectionPiece>;

/// Strings the cuts together across the edges they share, every chain from its lower end in plan.
std::vector<Chain> chains_of(const std::vector<Cut>& cuts, const Cutter& cutter)
{
  struct End {
    Edge edge;
    std::size_t cut, side;
  };
  std::vector<End> ends;
  for (std::size_t c = 0; c < cuts.size(); ++c)
    for (const std::size_t side : {0U, 1U}) ends.push_back({cuts[c].edges[side], c, side});
  std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.edge < b.edge; });
  const auto neighbour = [&](std::size_t cut, std::size_t side) -> const End* {
    const Edge& edge = cuts[cut].edges[side];
    const auto first = std::lower_bound(ends.begin(), ends.end(), edge,
                                        [](const End& end, const Edge& e) { return end.edge < e; });
    for (auto end = first; end != ends.end() && end->edge == edge; ++end)
      if (end->cut != cut) return &*end;
    return nullptr;
  };

  std::vector<Chain> chains;
  std::vector<char> done(cuts.size(), 0);
  const auto follow = [&](std::size_t cut, std::size_t entry) {
    Chain chain;
    while (done[cut] == 0) {
      done[cut] = 1;
      const Vec3 &a = cuts[cut].ends[entry], &b = cuts[cut].ends[1 - entry];
      chain.push_back({cuts[cut].element, a, b, cutter.along(a), cutter.along(b), 0.0, 0.0});
      const End* next = neighbour(cut, 1 - entry);
      if (next == nullptr) break;
      cut = next->cut;
      entry = next->side;
    }
    if (chain.back().along_to < chain.front().along_from) {
      std::reverse(chain.begin(), chain.end());
      for (SectionPiece& piece : chain) {
        std::swap(piece.from, piece.to);
        std::swap(piece.along_from, piece.along_to);
      }
    }
    chains.push_back(std::move(chain));
  };
  for (std::size_t c = 0; c < cuts.size(); ++c)
    for (const std::size_t side : {0U, 1U})
      if (done[c] == 0 && neighbour(c, side) == nullptr) follow(c, side);
  for (std::size_t c = 0; c < cuts.size(); ++c) // rings, where the sheet overhangs
    if (done[c] == 0) follow(c, 0);
  std::stable_sort(chains.begin(), chains.end(), [](const Chain& a, const Chain& b) {
    return a.front().along_from < b.front().along_from;
  });
  return chains;
}

/// Cuts a piece off where it leaves the section; false when nothing is left.
bool clip(SectionPiece& piece, double length)
{
  const double a = piece.along_from, b = piece.along_to, slack = 1e-9 * length;
  if ((a < -slack && b < -slack) || (a > length + slack && b > length + slack)) return false;
  const SectionPiece whole = piece;
  const auto at = [&](double along) {
    return whole.from + ((along - a) / (b - a)) * (whole.to - whole.from);
  };
  const auto end = [&](double along, Vec3& place, double& here) {
    if (along >= -slack && along <= length + slack) return;
    here = along < 0.0 ? 0.0 : length;
    place = at(here);
  };
  end(a, piece.from, piece.along_from);
  end(b, piece.to, piece.along_to);
  return piece.along_from != piece.along_to || piece.from.z != piece.to.z;
}

} // namespace

std::vector<SectionPiece> cut_section(std::span<const Vec3> places, std::span<const Triangle> triangles,
                                      Vec2 from, Vec2 to, bool left)
{
  const Cutter cutter(places, from, to);
  std::vector<SectionPiece> section;
  for (const Chain& chain : chains_of(cutter.cuts(triangles, !left), cutter))
    for (SectionPiece piece : chain) {
      if (!clip(piece, cutter.length())) continue;
      if (!section.empty()) piece.arc_from = section.back().arc_to + norm(piece.from - section.back().to);
      piece.arc_to = piece.arc_from + norm(piece.to - piece.from);
      section.push_back(piece);
    }
  return section;
}

} // namespace towform
