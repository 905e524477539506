#include "solver/statics_model.hpp"
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace towform {

namespace {

using Edge = BoundaryParameters::Edge;

std::vector<int> nodes_of(const QuadrilateralGrid& g, Edge edge)
{
  std::vector<int> nodes;
  const bool upright = edge == Edge::left || edge == Edge::right;
  for (int k = 0; k <= (upright ? g.ny : g.nx); ++k)
    nodes.push_back(edge == Edge::left    ? g.node(0, k)
                    : edge == Edge::right ? g.node(g.nx, k)
                    : edge == Edge::top   ? g.node(k, g.ny)
                                          : g.node(k, 0));
  return nodes;
}

void add_frame(const BoundaryParameters& b, const QuadrilateralGrid& g, Holds& holds)
{
  const int fixed = g.node(0, 0), driven = g.node(g.nx, g.ny);
  holds.groups.push_back({"", {}, std::nullopt});
  holds.held.push_back({fixed, static_cast<int>(holds.groups.size()) - 1});
  holds.groups.push_back({b.name, normalized(g.points[driven] - g.points[fixed]), b.motion});
  holds.held.push_back({driven, static_cast<int>(holds.groups.size()) - 1});
  for (const Edge edge : {Edge::left, Edge::right, Edge::bottom, Edge::top}) {
    const std::vector<int> nodes = nodes_of(g, edge);
    for (std::size_t k = 1; k + 1 < nodes.size(); ++k)
      holds.ties.push_back({nodes[k], nodes.front(), nodes.back(),
                            static_cast<double>(k) / static_cast<double>(nodes.size() - 1)});
  }
}

void add_grip(const BoundaryParameters& b, const QuadrilateralGrid& g, Holds& holds)
{
  const auto group = static_cast<int>(holds.groups.size());
  Vec3 direction;
  if (b.motion) direction = unit_vector(b.motion->axis);
  holds.groups.push_back({b.name, direction, b.motion});
  for (const int node : nodes_of(g, b.edge)) holds.held.push_back({node, group});
}

std::vector<InputIssue> issues_of(const Case& c)
{
  std::vector<InputIssue> issues;
  const auto issue = [&](const std::string& key, const std::string& message) {
    issues.push_back({c.where(key), message});
  };
  if (c.blank.element != ElementShape::quadrilateral)
    issue("blank.element", "the implicit solver needs blank.element = \"quadrilateral\"");
  if (!c.tools.empty())
    issue("tool[0]", "the implicit solver has no contact: take the explicit one for tools");
  if (std::none_of(c.boundaries.begin(), c.boundaries.end(),
                   [](const auto& b) { return b.motion.has_value(); }))
    issue("boundary", "the implicit solver needs a [[boundary]] with a motion");
  for (std::size_t i = 0; i < c.boundaries.size(); ++i) {
    const BoundaryParameters& b = c.boundaries[i];
    if (b.kind == BoundaryParameters::Kind::grip && b.motion && b.motion->axis == Axis::z)
      issue("boundary[" + std::to_string(i) + "].motion",
            "the implicit solver is planar: boundary." + b.name + " can move along x or y only");
  }
  return issues;
}

} // namespace

Holds holds_of(const std::vector<BoundaryParameters>& boundaries, const QuadrilateralGrid& grid)
{
  Holds holds;
  for (const BoundaryParameters& b : boundaries)
    b.kind == BoundaryParameters::Kind::picture_frame ? add_frame(b, grid, holds) : add_grip(b, grid, holds);
  return holds;
}

StaticsCase build_statics(const Case& c)
{
  std::vector<InputIssue> issues = issues_of(c);
  const auto make = [&](const char* key, auto maker) -> std::optional<decltype(maker())> {
    try {
      return maker();
    } catch (const std::logic_error& e) { // invalid_argument and domain_error: the user's values
      issues.push_back({c.where(key), e.what()});
    }
    return std::nullopt;
  };
  auto grid = make("blank", [&] { return make_quadrilateral_grid(c.blank); });
  auto material = make("material", [&] { return make_fabric_material(c.material, c.blank.thickness); });
  if (!issues.empty()) throw InputError(std::move(issues));

  const YarnLaw yarn{c.material.fibre_modulus * c.blank.thickness, c.material.compression_factor};
  Holds holds = holds_of(c.boundaries, *grid);
  StaticsModel model{grid->points, QuadrilateralMembrane(*grid, yarn, material->law),
                     LinearConstraints(grid->points.size(), std::move(holds.held), holds.ties),
                     std::move(holds.groups)};
  return {std::move(*grid), std::move(*material), std::move(model)};
}

} // namespace towform
