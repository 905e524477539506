#include "checks.hpp"
#include <algorithm>
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

  void blank() const
  {
    if (!given("blank")) return;
    if (given("blank.elements") && given("blank.edge"))
      issue("blank.edge", "blank has both elements and edge; give one");
    if (!given("blank.elements") && !given("blank.edge")) issue("blank", "blank needs elements or edge");
  }

  void material() const
  {
    const MaterialParameters& m = c.material;
    if (!m.curves.empty() && !m.shear_tangent.empty())
      issue("material.curves", "material has both curves and shear_tangent; give one");
    if (!m.shear_tangent.empty() && m.law != LawKind::elastic)
      issue("material.law", fmt::format("law \"{}\" follows the rate, of which shear_tangent knows nothing; "
                                        "a sheet with shear_tangent needs law = \"elastic\"",
                                        m.law == LawKind::viscous ? "viscous" : "incremental"));
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

  void tool(std::size_t i, std::set<std::string>& names) const
  {
    const ToolParameters& t = c.tools[i];
    const std::string at = fmt::format("tool[{}]", i);
    const std::string name = t.name.empty() ? "tool" : "tool." + t.name;
    if (given(at + ".name") && !t.name.empty()) {
      const bool plain = std::all_of(t.name.begin(), t.name.end(), [](char letter) {
        return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
               (letter >= '0' && letter <= '9') || letter == '_' || letter == '-';
      });
      if (!plain)
        issue(at + ".name", fmt::format("tool.name \"{}\" may have letters, digits, _ and - only", t.name));
      if (!names.insert(t.name).second)
        issue(at + ".name", fmt::format("a second tool named \"{}\"", t.name));
    }
    const bool force = given(at + ".force"), motion_given = given(at + ".motion");
    if (force && motion_given) issue(at + ".force", name + " has both motion and force; give one");
    if (t.motion) motion(name + ".motion", at + ".motion", *t.motion);
  }
};

} // namespace

void check_case(const Case& c, std::vector<InputIssue>& issues)
{
  const Checker checker{c, issues};
  checker.blank();
  checker.material();
  std::set<std::string> names;
  for (std::size_t i = 0; i < c.tools.size(); ++i) checker.tool(i, names);
}

} // namespace towform
