#include "contact/facet_tree.hpp"
#include <fcl/geometry/bvh/BVH_model.h>
#include <limits>

namespace towform {

static_assert(EIGEN_MAX_ALIGN_BYTES == 16, "FCL's package is built with 16-byte alignment");

namespace {
using Box = fcl::AABB<double>;

constexpr int stack_size = 128; // a walk never holds more entries than the tree has levels, plus one

double distance_squared(const Box& box, const Vec3& p)
{
  const double dx = std::max({box.min_.x() - p.x, 0.0, p.x - box.max_.x()});
  const double dy = std::max({box.min_.y() - p.y, 0.0, p.y - box.max_.y()});
  const double dz = std::max({box.min_.z() - p.z, 0.0, p.z - box.max_.z()});
  return dx * dx + dy * dy + dz * dz;
}
} // namespace

/// FCL's tree flattened: our traversal touches nothing else of it.
struct FacetTree::Boxes {
  struct Node {
    Box box;
    int left = -1; ///< right is left + 1; a leaf has facet >= 0
    int facet = -1;
  };
  std::vector<Node> nodes;
};

FacetTree::FacetTree(const SurfaceMesh& mesh)
{
  fcl::BVHModel<Box> model;
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

  auto boxes = std::make_unique<Boxes>();
  boxes->nodes.resize(static_cast<std::size_t>(model.getNumBVs()));
  for (int i = 0; i < model.getNumBVs(); ++i) {
    const auto& from = model.getBV(i);
    boxes->nodes[i] = {from.bv, from.isLeaf() ? -1 : from.leftChild(),
                       from.isLeaf() ? from.primitiveId() : -1};
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
  stack[top++] = {0, distance_squared(boxes_->nodes[0].box, p)};
  while (top > 0) {
    const Entry entry = stack[--top];
    if (entry.distance_squared > limit()) continue;
    const Boxes::Node& node = boxes_->nodes[entry.node];
    if (node.facet >= 0) {
      visit(node.facet, nearest_on_facet(facets_[node.facet], p).distance_squared);
      continue;
    }
    Entry near{node.left, distance_squared(boxes_->nodes[node.left].box, p)};
    Entry far{node.left + 1, distance_squared(boxes_->nodes[node.left + 1].box, p)};
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

std::size_t FacetTree::nearest_few(const Vec3& p, double bound, std::span<NearFacet> found) const
{
  struct Candidate {
    double distance_squared;
    int facet;
    auto operator<=>(const Candidate&) const = default;
  };
  std::array<Candidate, most_few + 1> best; // in order, with room for one to be dropped
  std::size_t count = 0;
  double limit = bound * bound;
  walk(
      p, [&] { return limit; },
      [&](int facet, double d2) {
        if (d2 > limit) return;
        const Candidate candidate{d2, facet};
        std::size_t at = count;
        for (; at > 0 && candidate < best[at - 1]; --at) best[at] = best[at - 1];
        best[at] = candidate;
        if (count < found.size()) ++count;
        if (count == found.size()) limit = std::min(limit, best[count - 1].distance_squared);
      });
  constexpr double down = 1.0 - 1e-6; // more than a float's rounding
  for (std::size_t i = 0; i < count; ++i)
    found[i] = {best[i].facet, static_cast<float>(down * std::sqrt(best[i].distance_squared))};
  return count;
}

} // namespace towform
