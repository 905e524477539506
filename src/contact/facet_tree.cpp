#include "contact/facet_tree.hpp"
#include "mesh/box.hpp"
#include <fcl/geometry/bvh/BVH_model.h>
#include <algorithm>
#include <cmath>

namespace towform {

static_assert(EIGEN_MAX_ALIGN_BYTES == 16, "FCL's package is built with 16-byte alignment");

namespace {

constexpr int stack_size = 128; // a walk never holds more entries than the tree has levels, plus one

inline Box grown(const Box& box, double distance)
{
  const Vec3 by{distance, distance, distance};
  return {box.low - by, box.high + by};
}

} // namespace

/// FCL's tree flattened: our traversal touches nothing else of it.
struct FacetTree::Boxes {
  static RoundedBox rounded(const fcl::AABB<double>& box)
  {
    RoundedBox its;
    for (int k = 0; k < 3; ++k) {
      its.low[k] = std::nextafter(static_cast<float>(box.min_[k]), -HUGE_VALF);
      its.high[k] = std::nextafter(static_cast<float>(box.max_[k]), HUGE_VALF);
    }
    return its;
  }
  static bool overlap(const RoundedBox& a, const Box& b)
  {
    return a.low[0] <= b.high.x && b.low.x <= a.high[0] && a.low[1] <= b.high.y && b.low.y <= a.high[1] && a.low[2] <= b.high.z &&
           b.low.z <= a.high[2];
  }
  struct Node {
    RoundedBox box;
    int left = -1; ///< right is left + 1; a leaf has facet >= 0
    int facet = -1;
  };
  std::vector<Node> nodes;
};

FacetTree::FacetTree(const SurfaceMesh& mesh)
{
  fcl::BVHModel<fcl::AABB<double>> model;
  model.beginModel(static_cast<int>(mesh.triangles.size()), static_cast<int>(mesh.points.size()));
  std::vector<fcl::Vector3d> points;
  points.reserve(mesh.points.size());
  for (const Vec3& p : mesh.points) points.emplace_back(p.x, p.y, p.z);
  std::vector<fcl::Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  facets_.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    triangles.emplace_back(a, b, c);
    facets_.emplace_back(std::array{mesh.points[a], mesh.points[b], mesh.points[c]});
  }
  model.addSubModel(points, triangles);
  model.endModel();

  boxes_of_facets_.resize(facets_.size());
  auto boxes = std::make_unique<Boxes>();
  boxes->nodes.resize(static_cast<std::size_t>(model.getNumBVs()));
  for (int i = 0; i < model.getNumBVs(); ++i) {
    const auto& from = model.getBV(i);
    boxes->nodes[i] = {Boxes::rounded(from.bv), from.isLeaf() ? -1 : from.leftChild(), from.isLeaf() ? from.primitiveId() : -1};
    if (from.isLeaf()) boxes_of_facets_[from.primitiveId()] = boxes->nodes[i].box;
  }
  boxes_ = std::move(boxes);
  if (depth() >= stack_size)
    throw std::runtime_error("the tree over a tool's facets is too deep: are their sizes wildly different?");
}

int FacetTree::depth() const
{
  std::vector<int> level(boxes_->nodes.size(), 1); // children come after their parents
  int deepest = 1;
  for (std::size_t i = 0; i < level.size(); ++i) {
    deepest = std::max(deepest, level[i]);
    const Boxes::Node& node = boxes_->nodes[i];
    if (node.facet < 0) level[node.left] = level[node.left + 1] = level[i] + 1;
  }
  return deepest;
}

FacetTree::~FacetTree() = default;
FacetTree::FacetTree(FacetTree&&) noexcept = default;
FacetTree& FacetTree::operator=(FacetTree&&) noexcept = default;

/// Visits facets from the nearest box on, as long as `limit()` [m^2] lets them: what lies farther is left
/// out.
template <class Limit, class Visit>
void FacetTree::walk(const Vec3& p, const Limit& limit, const Visit& visit) const
{
  struct Entry {
    int node;
    double distance_squared;
  };
  std::array<Entry, stack_size> stack;
  int top = 0;
  stack[top++] = {0, boxes_->nodes[0].box.distance_squared(p)};
  while (top > 0) {
    const Entry entry = stack[--top];
    if (entry.distance_squared > limit()) continue;
    const Boxes::Node& node = boxes_->nodes[entry.node];
    if (node.facet >= 0) {
      visit(node.facet, nearest_on_facet(facets_[node.facet], p).distance_squared);
      continue;
    }
    Entry near{node.left, boxes_->nodes[node.left].box.distance_squared(p)};
    Entry far{node.left + 1, boxes_->nodes[node.left + 1].box.distance_squared(p)};
    if (far.distance_squared < near.distance_squared) std::swap(near, far);
    stack[top++] = far;
    stack[top++] = near;
  }
}

int FacetTree::nearest(const Vec3& p, double bound) const
{
  double best = bound * bound;
  int facet = -1;
  walk(
      p, [&] { return best; },
      [&](int other, double d2) {
        if (d2 < best || (d2 == best && (facet < 0 || other < facet))) {
          best = d2;
          facet = other;
        }
      });
  return facet;
}

FacetTree::Roughly FacetTree::roughly_nearest(const Vec3& p, double bound) const
{
  constexpr double share = 0.7;
  double best = bound * bound;
  int facet = -1;
  walk(
      p, [&] { return share * share * best; },
      [&](int other, double d2) {
        if (d2 >= best) return;
        best = d2;
        facet = other;
      });
  return {facet, share * std::sqrt(best)};
}

/// Facets in boxes that are wanted.
template <class Wanted>
void FacetTree::find(const Wanted& wanted, std::vector<int>& found) const
{
  found.clear();
  std::array<int, stack_size> open;
  int top = 0;
  open[top++] = 0;
  while (top > 0) {
    const Boxes::Node& node = boxes_->nodes[open[--top]];
    if (!wanted(node.box)) continue;
    if (node.facet >= 0) {
      found.push_back(node.facet);
    } else {
      open[top++] = node.left;
      open[top++] = node.left + 1;
    }
  }
}

void FacetTree::find_in_box_round(std::span<const Vec3> points, double distance, std::vector<int>& found) const
{
  const Box round = grown(box_of(points), distance);
  find([&](const RoundedBox& box) { return Boxes::overlap(box, round); }, found);
}

void FacetTree::find_in_front(const Facet& facet, std::span<const Vec3> points, double distance, std::vector<int>& found) const
{
  const Box round = grown(box_of(points), distance);
  const Vec3& n = facet.normal;
  const auto highest = [&](const RoundedBox& box) {
    return (n.x > 0.0 ? box.high[0] : box.low[0]) * n.x + (n.y > 0.0 ? box.high[1] : box.low[1]) * n.y +
           (n.z > 0.0 ? box.high[2] : box.low[2]) * n.z - facet.offset;
  };
  find([&](const RoundedBox& box) { return Boxes::overlap(box, round) && highest(box) > 0.0; }, found);
}

} // namespace towform
