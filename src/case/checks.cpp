#include "checks.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <set>

namespace towform {

namespace {

struct Checker {
  const Case& c;
  std::vector<InputIssue>& issues;

  [[nodiscard]] bool given(const std::string& key) const { return c.locations.contains(key); }
  void issue(const std::string& key, const std::string& message) const
  {
    issues.push_back({c.where(key), message});
  }

  /// Is a key's value already known to be wrong?
  [[nodiscard]] bool unread(const std::string& key) const
  {
    const SourceLocation at = c.where(key);
    return std::any_of(issues.begin(), issues.end(), [&](const InputIssue& issue) {
      return issue.where.file == at.file && issue.where.line == at.line && issue.where.column == at.column;
    });
  }

  void blank() const
  {
    if (!given("blank")) return;
    yarns();
    tilt();
    if (given("blank.mesh")) return imported_blank();
    if (given("blank.elements") && given("blank.edge"))
      issue("blank.edge", "blank has both elements and edge; give one");
    if (!given("blank.elements") && !given("blank.edge")) issue("blank", "blank needs elements or edge");
    if (c.blank.element == ElementShape::quadrilateral && c.solver != SolverKind::implicit)
      issue("blank.element", "blank.element \"quadrilateral\" needs solver = \"implicit\"");
  }

  void tilt() const
  {
    const Vec2 tilt = c.blank.tilt;
    if (tilt == Vec2{}) return;
    const Symmetry symmetry = c.blank.symmetry;
    if ((tilt.y != 0.0 && (symmetry == Symmetry::x || symmetry == Symmetry::quarter)) ||
        (tilt.x != 0.0 && (symmetry == Symmetry::y || symmetry == Symmetry::quarter)))
      issue("blank.tilt", "blank.tilt turns the blank off a mirror plane of blank.symmetry");
    if (!c.boundaries.empty()) issue("blank.tilt", "blank.tilt: boundaries hold the edges of a flat blank");
    if (c.solver == SolverKind::implicit)
      issue("blank.tilt", "the implicit solver takes a flat blank: leave out blank.tilt");
  }

  void imported_blank() const
  {
    if (c.blank.mesh.empty() && !unread("blank.mesh")) issue("blank.mesh", "blank.mesh must not be empty");
    for (const char* key : {"size", "elements", "edge", "mesh_angle", "pattern", "element"})
      if (given(fmt::format("blank.{}", key)))
        issue(fmt::format("blank.{}", key),
              fmt::format("blank has both mesh and {}, which says how to mesh a rectangle; give one", key));
    if (c.solver == SolverKind::implicit)
      issue("blank.mesh",
            "the implicit solver meshes a rectangle itself and takes no blank.mesh; give size and "
            "elements, or take solver = \"explicit\"");
  }

  void yarns() const
  {
    const std::optional<Vec3>&first = c.blank.fibre_1, &second = c.blank.fibre_2;
    const bool has_first = given("blank.fibre_1"), has_second = given("blank.fibre_2");
    if (!has_first && !has_second) return;
    if (given("blank.fibre_angle"))
      issue("blank.fibre_angle", "blank has both fibre_angle and directions of its fibres; give one");
    if (has_first != has_second)
      return issue(has_first ? "blank.fibre_1" : "blank.fibre_2",
                   fmt::format("blank.fibre_{} needs blank.fibre_{}", has_first ? 1 : 2, has_first ? 2 : 1));
    bool good = true;
    for (const auto& [key, fibre] :
         {std::pair{"blank.fibre_1", &first}, std::pair{"blank.fibre_2", &second}}) {
      if (!*fibre) {
        good = false; // already an issue
      } else if ((*fibre)->z != 0.0) {
        good = false;
        issue(key, fmt::format("{} points out of the plane of the blank: its third number must be 0", key));
      } else if (!(norm(**fibre) >= 1e-100 && norm(**fibre) <= 1e100)) {
        good = false;
        issue(key, fmt::format("{} has no direction: its numbers are zero or beyond reason", key));
      }
    }
    if (!good) return;
    // Yarns this close are beyond the angles that any shear force is known for.
    constexpr double least = 5.0 * std::numbers::pi / 180.0;
    const double sine = norm(cross(normalized(*first), normalized(*second)));
    if (sine < std::sin(least))
      issue("blank.fibre_2",
            fmt::format("blank.fibre_2 is parallel to fibre_1, or nearly: {:.3g} degrees apart, 5 are "
                        "needed",
                        std::asin(sine) * 180.0 / std::numbers::pi));
  }

  void material() const
  {
    const MaterialParameters& m = c.material;
    if (!m.curves.empty() && !m.shear_tangent.empty())
      issue("material.curves", "material has both curves and shear_tangent; give one");
    if (!m.shear_tangent.empty() && (m.law == LawKind::viscous || m.law == LawKind::incremental))
      issue("material.law", fmt::format("law \"{}\" follows the rate, of which shear_tangent knows nothing; "
                                        "a sheet with shear_tangent needs law = \"elastic\"",
                                        m.law == LawKind::viscous ? "viscous" : "incremental"));
    if (m.bending_stiffness && !m.bending_table.empty())
      issue("material.bending_table", "material has both bending_stiffness and bending_table; give one");
    if (!m.has_model()) return;
    if (m.curve_rate_min > 0.0 && m.curve_rate_max > 0.0 && m.curve_rate_max <= m.curve_rate_min) {
      const std::string key =
          given("material.curve_rate_max") ? "material.curve_rate_max" : "material.curve_rate_min";
      issue(key, fmt::format("curve_rate_max ({} rad/s) must be greater than curve_rate_min ({} rad/s)",
                             m.curve_rate_max, m.curve_rate_min));
    }
    // Fibres of a tow cannot be packed closer than touching.
    const Constituents& k = m.constituents;
    if (!(k.fibre_volume_fraction > 0.0) || !(k.tow_width > 0.0)) return;
    const double in_tow = k.fibre_volume_fraction * (k.tow_width + k.tow_gap) / k.tow_width;
    const bool hexagonal = k.fibre_packing == FibrePacking::hexagonal;
    const double most = hexagonal ? std::numbers::pi / (2.0 * std::numbers::sqrt3) : std::numbers::pi / 4.0;
    if (in_tow >= most) {
      issue("material.fibre_volume_fraction",
            fmt::format("fibre_volume_fraction {} makes {:.3f} inside a tow, where {} packing ends at {:.3f}",
                        k.fibre_volume_fraction, in_tow, hexagonal ? "hexagonal" : "square", most));
    }
  }

  void load() const
  {
    const Symmetry symmetry = c.blank.symmetry;
    const bool half_x = symmetry == Symmetry::x || symmetry == Symmetry::quarter;
    const bool half_y = symmetry == Symmetry::y || symmetry == Symmetry::quarter;
    if ((half_x && c.load.gravity.x != 0.0) || (half_y && c.load.gravity.y != 0.0))
      issue("load.gravity", "load.gravity pulls the sheet off a mirror plane of blank.symmetry");
    const bool any = c.load.gravity != Vec3{};
    if (!c.load.pressure.empty() && c.solver == SolverKind::implicit)
      issue("load.pressure", "the implicit solver knows no pressure: take the explicit one");
    if (any && c.solver == SolverKind::implicit)
      issue("load.gravity", "the implicit solver knows no gravity: take the explicit one");
  }

  void motion(const std::string& label, const std::string& at, const Motion& motion) const
  {
    const bool displacement = given(at + ".displacement"), velocity = given(at + ".velocity");
    const bool table = given(at + ".table");
    if (motion.profile == Motion::Profile::table) {
      if (!table) issue(at, label + " has profile \"table\" but no table");
      if (displacement) issue(at + ".displacement", label + ": a table leaves no place for displacement");
      if (velocity) issue(at + ".velocity", label + ": a table leaves no place for velocity");
      return;
    }
    if (table) issue(at + ".table", label + " has a table; it needs profile = \"table\"");
    if (displacement && velocity)
      issue(at + ".velocity", label + " has both displacement and velocity; give one");
    if (!displacement && !velocity && !table) issue(at, label + " needs displacement or velocity");
    if (velocity && !displacement && motion.profile == Motion::Profile::smooth)
      issue(at + ".profile", label + ": profile \"smooth\" needs a displacement");
  }

  void name(const std::string& section, const std::string& at, const std::string& name,
            std::set<std::string>& names) const
  {
    if (!given(at + ".name") || name.empty()) return;
    const bool plain = std::all_of(name.begin(), name.end(), [](char letter) {
      return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
             (letter >= '0' && letter <= '9') || letter == '_' || letter == '-';
    });
    if (!plain)
      issue(at + ".name",
            fmt::format("{}.name \"{}\" may have letters, digits, _ and - only", section, name));
    if (!names.insert(name).second)
      issue(at + ".name", fmt::format("a second tool or boundary named \"{}\"", name));
  }

  void tool(std::size_t i, std::set<std::string>& names) const
  {
    const ToolParameters& t = c.tools[i];
    const std::string at = fmt::format("tool[{}]", i);
    const std::string name = t.name.empty() ? "tool" : "tool." + t.name;
    this->name("tool", at, t.name, names);
    const bool force = given(at + ".force"), motion_given = given(at + ".motion");
    if (force && motion_given) issue(at + ".force", name + " has both motion and force; give one");
    if (t.motion) motion(name + ".motion", at + ".motion", *t.motion);
  }

  void grip(const std::string& name, const std::string& at, const BoundaryParameters& b) const
  {
    if (!given(at + ".edge")) {
      issue(at, name + ".edge is missing (left, right, bottom or top: the edge that the grip holds)");
      return;
    }
    if (b.motion && !given(at + ".motion.axis"))
      issue(at + ".motion", name + ".motion.axis is missing (x, y or z: along which the grip moves)");
    const bool half_x = c.blank.symmetry == Symmetry::x || c.blank.symmetry == Symmetry::quarter;
    const bool half_y = c.blank.symmetry == Symmetry::y || c.blank.symmetry == Symmetry::quarter;
    using Edge = BoundaryParameters::Edge;
    if ((half_x && b.edge == Edge::left) || (half_y && b.edge == Edge::bottom))
      issue(at + ".edge", name + ".edge is not in the part that blank.symmetry keeps; hold the opposite one");
    const bool upright = b.edge == Edge::left || b.edge == Edge::right;
    const bool off_mirror = b.motion && ((half_x && !upright && b.motion->axis == Axis::x) ||
                                         (half_y && upright && b.motion->axis == Axis::y));
    if (off_mirror)
      issue(at + ".motion.axis", name + ".motion pulls the edge off the mirror plane that it crosses");
  }

  void picture_frame(const std::string& name, const std::string& at) const
  {
    if (given(at + ".edge"))
      issue(at + ".edge", name + ".edge has no effect: a picture frame holds all four edges");
    if (given(at + ".motion.axis"))
      issue(at + ".motion.axis",
            name + ".motion.axis has no effect: a picture frame opens along its diagonal");
    if (given("blank.mesh"))
      issue("blank.mesh", name + ": a picture frame needs a square blank, made by size and elements");
    else if (c.blank.size.x != c.blank.size.y)
      issue("blank.size", name + ": a picture frame needs a square blank");
    if (c.blank.symmetry != Symmetry::none)
      issue("blank.symmetry", name + ": a picture frame needs the whole blank, symmetry = \"none\"");
    if (c.boundaries.size() > 1)
      issue(at, name + ": a picture frame holds all four edges and leaves none to other boundaries");
  }

  void boundary(std::size_t i, std::set<std::string>& names) const
  {
    const BoundaryParameters& b = c.boundaries[i];
    const std::string at = fmt::format("boundary[{}]", i);
    const std::string name = b.name.empty() ? "boundary" : "boundary." + b.name;
    this->name("boundary", at, b.name, names);
    if (b.motion) motion(name + ".motion", at + ".motion", *b.motion);
    if (b.kind == BoundaryParameters::Kind::picture_frame)
      picture_frame(name, at);
    else
      grip(name, at, b);
    for (std::size_t j = 0; j < i; ++j) same_nodes(i, j);
  }

  void contact() const
  {
    constexpr double least = 0.1; // of the square of the step
    if (c.contact.room() >= least || unread("contact.damping") || unread("contact.penalty")) return;
    const double most = (1.0 - least - 0.5 * c.contact.penalty) / (2.0 * std::sqrt(c.contact.penalty));
    issue("contact.damping",
          fmt::format("contact.damping = {:g} leaves no stable step with contact.penalty = {:g}; at "
                      "most {:.2g}",
                      c.contact.damping, c.contact.penalty, most));
  }

  void report() const
  {
    for (const auto& [key, point] : {std::pair{"report.from", &c.report.from}, {"report.to", &c.report.to}})
      if (given(key) && !unread(key) && point->size() != 2)
        issue(key, fmt::format("{} must be [x, y], such as [0, \"100 mm\"]", key));
  }

  /// Two grips must not pull a node two ways.
  void same_nodes(std::size_t i, std::size_t j) const
  {
    const BoundaryParameters &b = c.boundaries[i], &other = c.boundaries[j];
    const std::string at = fmt::format("boundary[{}]", i);
    const auto is_grip = [](const BoundaryParameters& p) { return p.kind == BoundaryParameters::Kind::grip; };
    const std::string other_edge = fmt::format("boundary[{}].edge", j);
    if (!is_grip(b) || !is_grip(other) || !given(at + ".edge") || !given(other_edge)) return;
    if (unread(at + ".edge") || unread(other_edge)) return;
    using Edge = BoundaryParameters::Edge;
    const auto upright = [](Edge edge) { return edge == Edge::left || edge == Edge::right; };
    if (b.edge == other.edge)
      issue(at + ".edge", fmt::format("boundary.{} holds the same edge as boundary.{}", b.name, other.name));
    else if (upright(b.edge) != upright(other.edge) && (b.motion || other.motion))
      issue(at + ".edge", fmt::format("boundary.{} shares a corner with boundary.{}: neither can move",
                                      b.name, other.name));
  }
};

} // namespace

void check_case(const Case& c, std::vector<InputIssue>& issues)
{
  const Checker checker{c, issues};
  checker.blank();
  checker.material();
  checker.load();
  checker.contact();
  checker.report();
  std::set<std::string> names;
  for (std::size_t i = 0; i < c.tools.size(); ++i) checker.tool(i, names);
  for (std::size_t i = 0; i < c.boundaries.size(); ++i) checker.boundary(i, names);
}

} // namespace towform
