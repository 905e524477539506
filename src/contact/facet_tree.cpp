#include "contact/facet_tree.hpp"
#include "contact/facet.hpp"
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
  corners_.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    triangles.emplace_back(a, b, c);
    corners_.push_back({mesh.points[a], mesh.points[b], mesh.points[c]});
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

int FacetTree::nearest(const Vec3& p, double bound) const
{
  struct Entry {
    int node;
    double distance_squared;
  };
  std::array<Entry, stack_size> stack;
  int top = 0;
  double best = bound * bound;
  int facet = -1;
  stack[top++] = {0, distance_squared(boxes_->nodes[0].box, p)};
  while (top > 0) {
    const Entry entry = stack[--top];
    if (entry.distance_squared > best) continue;
    const Boxes::Node& node = boxes_->nodes[entry.node];
    if (node.facet >= 0) {
      const double d2 = nearest_on_facet(corners_[node.facet], p).distance_squared;
      if (d2 < best || (d2 == best && (facet < 0 || node.facet < facet))) {
        best = d2;
        facet = node.facet;
      }
      continue;
    }
    Entry near{node.left, distance_squared(boxes_->nodes[node.left].box, p)};
    Entry far{node.left + 1, distance_squared(boxes_->nodes[node.left + 1].box, p)};
    if (far.distance_squared < near.distance_squared) std::swap(near, far);
    stack[top++] = far;
    stack[top++] = near;
  }
  return facet;
}

void FacetTree::within(const Vec3& p, double radius, std::vector<NearFacet>& found) const
{
  found.clear();
  std::array<int, stack_size> stack;
  int top = 0;
  stack[top++] = 0;
  const double limit = radius * radius;
  while (top > 0) {
    const Boxes::Node& node = boxes_->nodes[stack[--top]];
    if (distance_squared(node.box, p) > limit) continue;
    if (node.facet < 0) {
      stack[top++] = node.left;
      stack[top++] = node.left + 1;
    } else {
      const double d2 = nearest_on_facet(corners_[node.facet], p).distance_squared;
      if (d2 <= limit) found.push_back({node.facet, std::sqrt(d2)});
    }
  }
  std::sort(found.begin(), found.end(), [](const NearFacet& a, const NearFacet& b) {
    return a.distance < b.distance || (a.distance == b.distance && a.facet < b.facet);
  });
}

} // namespace towform
