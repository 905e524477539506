#include "mesh/imported_blank.hpp"
#include "case/file_issue.hpp"
#include "mesh/box.hpp"
#include "mesh/surface_check.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace towform {

namespace {

// Of the blank's width: what meshers leave of rounding is far below, the smallest element far above.
constexpr double same_place = 1e-6;

double width(const Box& box) { return std::max(box.high.x - box.low.x, box.high.y - box.low.y); }

double twice_area(const Vec3& a, const Vec3& b, const Vec3& c)
{
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

/// Smallest angle [rad]; negative for a triangle that is turned over.
double smallest_angle(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const double area = twice_area(a, b, c);
  return std::min({std::atan2(area, dot(b - a, c - a)), std::atan2(area, dot(c - b, a - b)),
                   std::atan2(area, dot(a - c, b - c))});
}

class Importer {
public:
  Importer(const MshMesh& mesh, const std::string& name) : mesh_(mesh), name_(name) {}

  SurfaceMesh triangles()
  {
    for (const MshMesh::Node& node : mesh_.nodes) out_.points.push_back(node.place + Vec3{}); // no -0
    flatten();
    check_places();
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e)
      mesh_.elements[e].corners() == 3 ? add_triangle(e) : add_quadrilateral(e);
    if (const auto fault = check_surface(out_)) refuse(*fault);
    return std::move(out_);
  }

private:
  void flatten()
  {
    const Box box = box_of(out_.points);
    const double wide = width(box);
    const MshMesh::Node& any = mesh_.nodes.front();
    if (!(wide >= 1e-6 && wide <= 1e3))
      fail(any.line, fmt::format("the blank would be {:.3g} m wide: is blank.mesh_unit right?", wide));
    for (std::size_t n = 1; n < out_.points.size(); ++n)
      if (std::abs(out_.points[n].z - out_.points[0].z) > same_place * wide)
        fail(mesh_.nodes[n].line,
             fmt::format("the blank is not flat: node {} is at z = {:.6g} mm and node {} at {:.6g} mm; it "
                         "has to lie in "
                         "one plane z = const",
                         mesh_.nodes[n].tag, 1e3 * out_.points[n].z, any.tag, 1e3 * out_.points[0].z));
    const double z = out_.points.front().z;
    for (Vec3& p : out_.points) p.z = z;
  }

  /// Nodes on top of each other leave slits in the sheet.
  void check_places() const
  {
    const double tolerance = same_place * width(box_of(out_.points));
    if (weld({out_.points, {}}, tolerance, false).points.size() == out_.points.size()) return;
    std::vector<int> order(out_.points.size());
    for (std::size_t n = 0; n < order.size(); ++n) order[n] = static_cast<int>(n);
    std::sort(order.begin(), order.end(), [&](int a, int b) { return out_.points[a].x < out_.points[b].x; });
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t j = i + 1; j < order.size(); ++j) {
        const auto [first, second] = std::minmax(order[i], order[j]);
        const Vec3 apart = out_.points[order[j]] - out_.points[order[i]];
        if (apart.x > tolerance) break;
        if (norm(apart) <= tolerance)
          fail(mesh_.nodes[second].line,
               fmt::format("node {} lies where node {} (line {}) does: the sheet would come apart there; "
                           "merge duplicate "
                           "nodes (in Gmsh: Coherence Mesh)",
                           mesh_.nodes[second].tag, mesh_.nodes[first].tag, mesh_.nodes[first].line));
      }
  }

  void add(std::size_t element, int a, int b, int c)
  {
    out_.triangles.push_back({a, b, c});
    element_.push_back(element);
  }

  void add_triangle(std::size_t e)
  {
    const auto& n = mesh_.elements[e].nodes;
    const bool turned = twice_area(at(n[0]), at(n[1]), at(n[2])) < 0.0;
    turned ? add(e, n[0], n[2], n[1]) : add(e, n[0], n[1], n[2]);
  }

  void add_quadrilateral(std::size_t e)
  {
    std::array<int, 4> n = mesh_.elements[e].nodes;
    const Vec3 &a = at(n[0]), &b = at(n[1]), &c = at(n[2]), &d = at(n[3]);
    if (twice_area(a, b, c) + twice_area(a, c, d) < 0.0) std::swap(n[1], n[3]);
    const std::array<Vec3, 4> x{at(n[0]), at(n[1]), at(n[2]), at(n[3])};
    const double first = std::min(smallest_angle(x[0], x[1], x[2]), smallest_angle(x[0], x[2], x[3]));
    const double second = std::min(smallest_angle(x[1], x[2], x[3]), smallest_angle(x[1], x[3], x[0]));
    if (!(std::max(first, second) > 0.0))
      fail(mesh_.elements[e].line,
           fmt::format("quadrilateral {} has no area or crosses itself: give its nodes in turn round it",
                       mesh_.elements[e].tag));
    if (takes_first_diagonal(x, first, second)) {
      add(e, n[0], n[1], n[2]);
      add(e, n[0], n[2], n[3]);
    } else {
      add(e, n[1], n[2], n[3]);
      add(e, n[1], n[3], n[0]);
    }
  }

  static bool takes_first_diagonal(const std::array<Vec3, 4>& x, double first, double second)
  {
    constexpr double close = 1e-6;
    if (std::abs(first - second) > close) return first > second;
    const Vec3 one = x[2] - x[0], other = x[3] - x[1];
    const double difference = norm(one) - norm(other);
    if (std::abs(difference) > close * norm(one)) return difference < 0.0;
    const Vec3 out = x[0] + x[1] + x[2] + x[3];
    const auto along = [&](const Vec3& v) { return std::abs(v.x * out.x + v.y * out.y); };
    return along(one) >= along(other);
  }

  [[noreturn]] void refuse(const SurfaceFault& fault) const
  {
    const auto shown = [&](int triangle) {
      const MshMesh::Element& e = mesh_.elements[element_[triangle]];
      return fmt::format("{} {}", e.corners() == 3 ? "triangle" : "quadrilateral", e.tag);
    };
    const auto line = [&](int triangle) { return mesh_.elements[element_[triangle]].line; };
    const std::string me = shown(fault.facet),
                      other = fmt::format("{} (line {})", shown(fault.other), line(fault.other));
    switch (fault.defect) {
    case SurfaceDefect::degenerate:
      fail(line(fault.facet),
           fmt::format("{} has no area or repeats a node ({} such in all)", me, fault.count));
    case SurfaceDefect::duplicate:
      fail(line(fault.facet), fmt::format("{} has the nodes of {} ({} such in all)", me, other, fault.count));
    case SurfaceDefect::crowded:
      fail(line(fault.facet),
           fmt::format(
               "{} shares an edge with more than one other element ({} such edges in all): they overlap", me,
               fault.count));
    case SurfaceDefect::orientation:
      break;
    }
    fail(line(fault.facet),
         fmt::format(
             "{} and {} lie on the same side of the edge they share ({} such edges in all): they overlap", me,
             other, fault.count));
  }

  [[noreturn]] void fail(int line, const std::string& message) const { refuse_line(name_, line, message); }

  [[nodiscard]] const Vec3& at(int node) const { return out_.points[static_cast<std::size_t>(node)]; }

  const MshMesh& mesh_;
  const std::string& name_;
  SurfaceMesh out_;
  std::vector<std::size_t> element_; // of every triangle
};

void put_on_mirror(SurfaceMesh& mesh, double Vec3::*component, char axis)
{
  const Box box = box_of(mesh.points);
  const double tolerance = same_place * width(box), low = box.low.*component;
  if (low < -tolerance)
    throw std::invalid_argument(fmt::format(
        "blank.symmetry keeps {0} >= 0, but the mesh reaches to {0} = {1:.6g} mm: mesh that part only, or "
        "take symmetry = \"none\"",
        axis, 1e3 * low));
  if (low > tolerance)
    throw std::invalid_argument(fmt::format(
        "blank.symmetry makes {0} = 0 a mirror, but the mesh begins at {0} = {1:.6g} mm: it has to "
        "reach the mirror",
        axis, 1e3 * low));
  for (Vec3& p : mesh.points)
    if (std::abs(p.*component) <= tolerance) p.*component = 0.0;
}

} // namespace

SurfaceMesh triangles_of(const MshMesh& mesh, const std::string& name)
{
  return Importer(mesh, name).triangles();
}

void put_on_mirrors(SurfaceMesh& mesh, Symmetry symmetry)
{
  if (symmetry == Symmetry::x || symmetry == Symmetry::quarter) put_on_mirror(mesh, &Vec3::x, 'x');
  if (symmetry == Symmetry::y || symmetry == Symmetry::quarter) put_on_mirror(mesh, &Vec3::y, 'y');
}

} // namespace towform
