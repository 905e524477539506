#include "contact/contact.hpp"
#include "contact/contact_lanes.hpp"
#include "parallel/parallel.hpp"
#include <algorithm>
#include <array>
#include <cmath>

namespace towform {

Contact::Contact(const Tool& its_tool, int number, double half, double beta, double zeta, double dt)
    : tool(number), half_thickness(half), stiffness_per_mass(beta / (dt * dt)),
      damping_per_mass(2.0 * zeta * std::sqrt(beta) / dt),
      // Facets within four half thicknesses serve nodes up to two from the tool.
      neighbours(std::make_unique<const FacetNeighbours>(its_tool.surface, 4.0 * half))
{
}

void start(const Contact&, std::size_t nodes, ContactState& c)
{
  for (std::vector<double>* v : {&c.stick_x, &c.stick_y, &c.stick_z, &c.normal_force})
    v->assign(nodes, 0.0);
  ContactPlanes& p = c.planes;
  for (std::vector<double>* v : {&p.normal_x, &p.normal_y, &p.normal_z, &p.offset, &p.anchor_x, &p.anchor_y,
                                 &p.anchor_z})
    v->assign(nodes, 0.0);
  p.reach_squared.assign(nodes, -1.0);
  p.facet.assign(nodes, -1);
}

namespace {

/// Nodes are taken in blocks: a block belongs to one thread, and sums run over blocks in their order.
constexpr int block_size = NodeLanes::size;

/// A contact as its blocks see it.
struct Meeting {
  const Contact& contact;
  const Tool& tool;
  ContactState& state;
  ContactLaw law;
};

ContactLanes lanes_from(ContactState& c, int n)
{
  ContactPlanes& p = c.planes;
  return {p.normal_x.data() + n,     p.normal_y.data() + n, p.normal_z.data() + n, p.offset.data() + n,
          p.anchor_x.data() + n,     p.anchor_y.data() + n, p.anchor_z.data() + n, p.reach_squared.data() + n,
          c.stick_x.data() + n,      c.stick_y.data() + n,  c.stick_z.data() + n,  c.normal_force.data() + n};
}

/// Search: the tool's point nearest to p [tool's frame], and the plane that tells it from now on.
void search(const Meeting& m, const Vec3& p, int node)
{
  ContactPlanes& planes = m.state.planes;
  int& facet = planes.facet[node];
  std::optional<FacetNeighbours::Nearest> nearest;
  if (facet >= 0) nearest = m.contact.neighbours->nearest(p, facet);
  if (!nearest) {
    facet = m.tool.surface.nearest(p, facet).facet;
    nearest = m.contact.neighbours->nearest(p, facet);
    if (!nearest) nearest = FacetNeighbours::Nearest{m.tool.surface.at(p, facet), 0.0};
  }
  const SurfacePoint& point = nearest->point;
  facet = point.facet;
  planes.anchor_x[node] = p.x;
  planes.anchor_y[node] = p.y;
  planes.anchor_z[node] = p.z;
  // Behind the rim of an open surface there is no tool.
  const bool behind_rim = point.distance < 0.0 && point.on_border;
  const double gap = behind_rim ? 0.0 : (point.distance - m.contact.half_thickness) * (1.0 - 1e-9);
  const double reach = std::max(nearest->reach, gap);
  planes.reach_squared[node] = reach > 0.0 ? reach * reach : -1.0;
  planes.normal_x[node] = point.normal.x;
  planes.normal_y[node] = point.normal.y;
  planes.normal_z[node] = point.normal.z;
  if (behind_rim || gap > nearest->reach)
    planes.offset[node] = no_plane;
  else if (point.inside)
    planes.offset[node] = m.tool.surface.tree().facet(facet).offset;
  else
    planes.offset[node] = dot(point.normal, p) - point.distance;
}

/// A tool against a block of nodes: search, gap, force, friction.
ContactSums meet(const Meeting& m, NodeLanes& nodes, const double* mass, int first, int count)
{
  const ContactLanes lanes = lanes_from(m.state, first);
  std::array<long long, block_size> marks;
  const Awake awake = look(nodes, lanes, m.law, count, marks.data());
  if (awake.marked > 0)
    for (int i = 0; i < count; ++i)
      if (marks[i] != 0) search(m, Vec3{nodes.x[i], nodes.y[i], nodes.z[i]} - m.law.shift, first + i);
  return awake.near + awake.marked > 0 ? push(nodes, lanes, mass, m.law, count) : ContactSums{};
}

void gather(const State& s, int first, int count, NodeLanes& nodes)
{
  for (int i = 0; i < count; ++i) {
    const Vec3 &x = s.position[first + i], &v = s.velocity[first + i];
    nodes.x[i] = x.x;
    nodes.y[i] = x.y;
    nodes.z[i] = x.z;
    nodes.vx[i] = v.x;
    nodes.vy[i] = v.y;
    nodes.vz[i] = v.z;
    nodes.fx[i] = nodes.fy[i] = nodes.fz[i] = 0.0;
  }
}

/// What the blocks tell of a tool, in their order.
void take_sums(std::span<const ContactSums> sums, ToolState& tool, ContactState& c, std::span<const Vec3> position,
               const ContactLaw& law)
{
  Vec3 force;
  c.energies.elastic = 0.0;
  c.penetration = 0.0;
  std::size_t deepest = 0;
  for (std::size_t block = 0; block < sums.size(); ++block) {
    const ContactSums& sum = sums[block];
    force += sum.force;
    c.energies.elastic += sum.elastic;
    c.energies.damping += sum.damped;
    c.energies.friction += sum.rubbed;
    if (sum.penetration > c.penetration) {
      c.penetration = sum.penetration;
      deepest = block;
    }
  }
  tool.reaction = -force;
  if (c.penetration == 0.0) return;
  const ContactPlanes& p = c.planes;
  for (std::size_t n = deepest * block_size; n < position.size(); ++n) {
    const Vec3 x = position[n] - law.shift;
    const double gap = (p.normal_x[n] * x.x + p.normal_y[n] * x.y + p.normal_z[n] * x.z - p.offset[n]) -
                       law.half_thickness;
    if (-gap != c.penetration) continue;
    c.deepest_node = static_cast<int>(n);
    return;
  }
}

} // namespace

void contact_forces(std::span<const Contact> contacts, std::span<const Tool> tools, std::span<ToolState> tool_states,
                    std::span<ContactState> states, std::span<const double> mass, State& s, double dt)
{
  if (contacts.empty()) return;
  const int nodes = static_cast<int>(s.position.size());
  const int blocks = (nodes + block_size - 1) / block_size;
  std::vector<Meeting> meetings;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact& contact = contacts[i];
    const Tool& tool = tools[contact.tool];
    const ToolState& t = tool_states[contact.tool];
    meetings.push_back({contact, tool, states[i],
                        {t.displacement * tool.direction, t.velocity * tool.direction, contact.half_thickness,
                         contact.stiffness_per_mass, contact.damping_per_mass,
                         contact.stick_ratio, tool.friction, dt}});
  }
  std::vector<ContactSums> sums(contacts.size() * static_cast<std::size_t>(blocks));
  parallel_each(blocks, [&](int block) {
    NodeLanes lanes;
    const int first = block * block_size, count = std::min(block_size, nodes - first);
    gather(s, first, count, lanes);
    for (std::size_t i = 0; i < meetings.size(); ++i)
      sums[i * static_cast<std::size_t>(blocks) + block] = meet(meetings[i], lanes, mass.data() + first, first, count);
    for (int i = 0; i < count; ++i) s.force[first + i] += {lanes.fx[i], lanes.fy[i], lanes.fz[i]};
  });
  for (std::size_t i = 0; i < contacts.size(); ++i)
    take_sums(std::span(sums).subspan(i * static_cast<std::size_t>(blocks), static_cast<std::size_t>(blocks)),
              tool_states[contacts[i].tool], states[i], s.position, meetings[i].law);
}

} // namespace towform
