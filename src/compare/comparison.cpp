#include "compare/comparison.hpp"
#include "case/file_issue.hpp"
#include "compare/plan_search.hpp"
#include "compare/section.hpp"
#include "mesh/outline.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stdexcept>

namespace towform {

namespace {

using Role = PointRole;

[[noreturn]] void refuse(const std::string& message) { throw std::invalid_argument(message); }

[[noreturn]] void refuse_columns(const ReferencePoints& reference, const std::string& message)
{
  refuse_line(reference.file, reference.header_line, message);
}

ComparisonKind kind_of(const ReferencePoints& reference, const ComparisonOptions& o)
{
  const bool plan = reference.of(Role::x) && reference.of(Role::y);
  const bool arc = reference.of(Role::arc), polar = reference.of(Role::polar),
             shear = reference.of(Role::shear);
  if (o.centre && o.from) refuse("--centre and --from: a line starts at one of them");
  if (o.centre && !o.to) refuse("--centre needs --to x,y, a plan point that the line runs towards");
  if (!o.centre && o.from.has_value() != o.to.has_value())
    refuse("a section needs both --from x,y and --to x,y");
  const bool line = o.centre || o.from;
  if (line && o.mirror) refuse("--mirror folds points; draw the section in the part that is modelled");
  if (o.centre && o.reference_coordinates)
    refuse("--reference-coordinates: the flat sheet lies on no sphere");

  if (o.centre && !polar) refuse_columns(reference, "--centre needs a column polar_deg");
  if (o.from && !arc) refuse_columns(reference, "--from needs a column arc_mm");
  if (line && !shear) refuse_columns(reference, "a section needs a column shear_deg");
  if (o.centre) return ComparisonKind::sphere;
  if (o.from) return ComparisonKind::section;
  if (plan) return shear ? ComparisonKind::field : ComparisonKind::outline;
  if (polar) refuse("column polar_deg needs --centre x,y,z of the sphere and --to x,y");
  if (arc) refuse("column arc_mm needs --from x,y and --to x,y");
  refuse_columns(reference,
                 "needs columns x_mm and y_mm (with shear_deg a field, without it an outline), arc_mm and "
                 "shear_deg, or polar_deg and shear_deg; --column ROLE=COLUMN gives others these roles");
}

/// Which of the planes x = 0 and y = 0 the sheet ends at.
struct Mirrors {
  bool x = false, y = false;

  explicit Mirrors(const std::vector<Vec3>& flat)
  {
    Vec2 low{flat[0].x, flat[0].y}, high = low;
    for (const Vec3& p : flat) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    x = std::abs(low.x) <= 1e-6 * (high.x - low.x);
    y = std::abs(low.y) <= 1e-6 * (high.y - low.y);
    tolerance = 1e-6 * std::max(high.x - low.x, high.y - low.y);
  }
  [[nodiscard]] Vec2 folded(Vec2 p) const { return {x ? std::abs(p.x) : p.x, y ? std::abs(p.y) : p.y}; }
  /// Does an edge of the flat sheet lie on a mirror?
  [[nodiscard]] bool hold(const Vec3& a, const Vec3& b) const
  {
    return (x && std::abs(a.x) <= tolerance && std::abs(b.x) <= tolerance) ||
           (y && std::abs(a.y) <= tolerance && std::abs(b.y) <= tolerance);
  }

private:
  double tolerance = 0.0;
};

class Comparer {
public:
  Comparer(const SheetResult& sheet, const ReferencePoints& reference, const ComparisonOptions& options)
      : sheet_(sheet), reference_(reference), options_(options),
        places_(options.reference_coordinates ? sheet.flat.points : sheet.position),
        mirrors_(sheet.flat.points)
  {
    result_.kind = kind_of(reference, options);
    if (options.nodal) nodal_ = nodal_means();
    if (options.mirror && !mirrors_.x && !mirrors_.y)
      refuse("--mirror: the sheet ends neither at x = 0 nor at y = 0, so it is no part to fold points into");
    const auto negative = [](const ReferencePoint& p) { return p[Role::shear] < 0.0; };
    result_.magnitudes =
        result_.kind != ComparisonKind::outline &&
        (options.mirror || std::none_of(reference.points.begin(), reference.points.end(), negative));
    for (const ReferencePoint& point : reference.points) {
      const double wanted = result_.kind == ComparisonKind::outline ? 0.0 : signed_or_not(point[Role::shear]);
      result_.points.push_back({point, std::nullopt, 0.0, wanted});
    }
  }

  Comparison compare()
  {
    switch (result_.kind) {
    case ComparisonKind::field:
      field();
      break;
    case ComparisonKind::outline:
      outline();
      break;
    case ComparisonKind::section:
      section(*options_.from);
      break;
    case ComparisonKind::sphere:
      section({options_.centre->x, options_.centre->y});
      break;
    }
    statistics();
    judge();
    return std::move(result_);
  }

private:
  [[nodiscard]] double signed_or_not(double shear) const
  {
    return result_.magnitudes ? std::abs(shear) : shear;
  }
  [[nodiscard]] double shear(int element, const Vec3& at) const
  {
    if (nodal_.empty()) return signed_or_not(sheet_.shear[static_cast<std::size_t>(element)]);
    const Triangle& t = sheet_.flat.triangles[static_cast<std::size_t>(element)];
    const Vec3 &a = places_[t[0]], &b = places_[t[1]], &c = places_[t[2]];
    const Vec3 normal = cross(b - a, c - a);
    const double whole = norm_squared(normal);
    const double wb = dot(cross(at - a, c - a), normal) / whole,
                 wc = dot(cross(b - a, at - a), normal) / whole;
    return signed_or_not((1.0 - wb - wc) * nodal_[t[0]] + wb * nodal_[t[1]] + wc * nodal_[t[2]]);
  }

  /// Means over the elements round each node, by area of the flat sheet.
  [[nodiscard]] std::vector<double> nodal_means() const
  {
    std::vector<double> sum(places_.size(), 0.0), area(places_.size(), 0.0);
    for (std::size_t e = 0; e < sheet_.flat.triangles.size(); ++e) {
      const auto& [a, b, c] = sheet_.flat.triangles[e];
      const auto& x = sheet_.flat.points;
      const double size = norm(cross(x[b] - x[a], x[c] - x[a]));
      for (const int n : {a, b, c}) {
        sum[n] += size * sheet_.shear[e];
        area[n] += size;
      }
    }
    for (std::size_t n = 0; n < sum.size(); ++n)
      if (area[n] > 0.0) sum[n] /= area[n];
    return sum;
  }
  [[nodiscard]] Vec2 plan(const ReferencePoint& p) const
  {
    const Vec2 at{p[Role::x], p[Role::y]};
    return options_.mirror ? mirrors_.folded(at) : at;
  }

  void field()
  {
    const PlanSearch search(places_, sheet_.flat.triangles);
    for (ComparedPoint& point : result_.points) {
      const auto holders = search.holders(plan(point.reference));
      if (holders.empty()) continue;
      auto best = holders.begin();
      if (reference_.of(Role::z))
        best = std::min_element(holders.begin(), holders.end(), [&](const auto& a, const auto& b) {
          return std::abs(a.z - point.reference[Role::z]) < std::abs(b.z - point.reference[Role::z]);
        });
      const Vec2 at = plan(point.reference);
      point.computed = shear(best->element, {at.x, at.y, best->z});
    }
  }

  void outline()
  {
    auto edges = outline_edges(sheet_.flat.triangles);
    if (options_.mirror)
      std::erase_if(edges, [&](const auto& e) {
        return mirrors_.hold(sheet_.flat.points[e[0]], sheet_.flat.points[e[1]]);
      });
    const PlanSearch search(places_, sheet_.flat.triangles);
    for (ComparedPoint& point : result_.points) {
      const Vec2 at = plan(point.reference);
      double nearest = HUGE_VAL;
      for (const auto& [a, b] : edges) nearest = std::min(nearest, distance(at, places_[a], places_[b]));
      if (std::isfinite(nearest)) point.computed = search.holders(at).empty() ? -nearest : nearest;
    }
  }

  static double distance(Vec2 p, const Vec3& a, const Vec3& b)
  {
    const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
    const double share =
        squared > 0.0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squared, 0.0, 1.0) : 0.0;
    return std::hypot(p.x - a.x - share * dx, p.y - a.y - share * dy);
  }

  /// Along edges of triangles a section lies between two elements: both sides count alike.
  void section(Vec2 from)
  {
    const Vec2 to = *options_.to;
    if (std::hypot(to.x - from.x, to.y - from.y) < 1e-9)
      refuse(options_.centre ? "--centre and --to are one point in plan" : "--from and --to are one point");
    const auto left = cut_section(places_, sheet_.flat.triangles, from, to, true);
    const auto right = cut_section(places_, sheet_.flat.triangles, from, to, false);
    for (ComparedPoint& point : result_.points) {
      double sum = 0.0, away = 0.0;
      int found = 0;
      for (const auto* pieces : {&left, &right})
        if (const auto found_at = find(*pieces, point.reference, away)) {
          sum += shear(found_at->element, found_at->point);
          ++found;
        }
      if (found == 0) continue;
      point.computed = sum / found;
      point.distance = away;
    }
  }

  struct Found {
    int element;
    Vec3 point;
  };

  [[nodiscard]] std::optional<Found> find(const std::vector<SectionPiece>& pieces,
                                          const ReferencePoint& point, double& distance) const
  {
    if (result_.kind == ComparisonKind::section) {
      const double arc = point[Role::arc], slack = 1e-9 * (pieces.empty() ? 0.0 : pieces.back().arc_to);
      for (const SectionPiece& piece : pieces)
        if (arc >= piece.arc_from - slack && arc <= piece.arc_to + slack) {
          const double length = piece.arc_to - piece.arc_from;
          const double share = length > 0.0 ? std::clamp((arc - piece.arc_from) / length, 0.0, 1.0) : 0.0;
          return Found{piece.element, (1.0 - share) * piece.from + share * piece.to};
        }
      return std::nullopt;
    }
    // The pole is where the line starts: above the centre or below it.
    if (pieces.empty()) return std::nullopt;
    const Vec3& centre = *options_.centre;
    const Vec3 pole{0.0, 0.0, pieces.front().from.z < centre.z ? -1.0 : 1.0};
    const auto angle = [&](const Vec3& p) {
      const Vec3 v = p - centre;
      return std::atan2(norm(cross(v, pole)), dot(v, pole)) * 180.0 / M_PI;
    };
    for (const SectionPiece& piece : pieces) {
      const double a = angle(piece.from), b = angle(piece.to), wanted = point[Role::polar];
      if (wanted < std::min(a, b) - 1e-9 || wanted > std::max(a, b) + 1e-9) continue;
      const double share = a == b ? 0.0 : std::clamp((wanted - a) / (b - a), 0.0, 1.0);
      const Vec3 at = (1.0 - share) * piece.from + share * piece.to;
      distance = norm(at - centre);
      return Found{piece.element, at};
    }
    return std::nullopt;
  }

  void statistics()
  {
    double squares = 0.0, sum = 0.0;
    for (const ComparedPoint& point : result_.points) {
      if (!point.computed) continue;
      const double d = point.difference();
      ++result_.compared;
      sum += d;
      squares += d * d;
      if (result_.compared == 1 || std::abs(d) > result_.largest) {
        result_.largest = std::abs(d);
        result_.largest_line = point.reference.line;
      }
    }
    if (result_.compared == 0) return;
    result_.mean = sum / result_.compared;
    result_.rms = std::sqrt(squares / result_.compared);
  }

  void judge()
  {
    const bool outline = result_.kind == ComparisonKind::outline;
    const double scale = outline ? 1e3 : 1.0;
    const char* unit = outline ? "mm" : "deg";
    const auto fail = [&](std::string message) { result_.failures.push_back(std::move(message)); };
    std::vector<int> outside;
    for (const ComparedPoint& point : result_.points)
      if (!point.computed) outside.push_back(point.reference.line);
    if (!outside.empty() && !options_.mirror && (mirrors_.x || mirrors_.y) && reference_.of(Role::x))
      result_.hint = fmt::format("the sheet ends at {}: if that is a mirror, --mirror folds points into it",
                                 mirrors_.x && mirrors_.y ? "x = 0 and y = 0"
                                 : mirrors_.x             ? "x = 0"
                                                          : "y = 0");
    if (result_.compared == 0) return fail("no point of the reference is on the sheet");
    if (!outside.empty() && (options_.tolerance || options_.rms))
      fail(
          fmt::format("{} point(s) outside the sheet: line(s) {}", outside.size(), fmt::join(outside, ", ")));
    if (options_.tolerance && result_.largest > *options_.tolerance)
      fail(fmt::format("largest difference {:.4g} {} (line {}), limit {:.4g} {}", scale * result_.largest,
                       unit, result_.largest_line, scale * *options_.tolerance, unit));
    if (options_.rms && result_.rms > *options_.rms)
      fail(fmt::format("RMS {:.4g} {}, limit {:.4g} {}", scale * result_.rms, unit, scale * *options_.rms,
                       unit));
  }

  const SheetResult& sheet_;
  const ReferencePoints& reference_;
  const ComparisonOptions& options_;
  const std::vector<Vec3>& places_;
  Mirrors mirrors_;
  std::vector<double> nodal_; ///< shear at the nodes [deg]; empty unless asked for
  Comparison result_;
};

} // namespace

Comparison compare(const SheetResult& sheet, const ReferencePoints& reference,
                   const ComparisonOptions& options)
{
  return Comparer(sheet, reference, options).compare();
}

} // namespace towform
