#include "contact/contact.hpp"
#include "contact/contact_lanes.hpp"
#include "contact/plane_search.hpp"
#include "parallel/parallel.hpp"
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

namespace towform {

Contact::Contact(const Tool& its_tool, int number, double half, double beta, double zeta, double mass_per_area, double dt)
    : tool(number), half_thickness(half), stiffness_per_area(beta * mass_per_area / (dt * dt)),
      damping_per_area(2.0 * zeta * std::sqrt(beta) * mass_per_area / dt),
      // Facets within three half thicknesses serve nodes that touch; longer lists cost more than searching for the others.
      neighbours(std::make_unique<const FacetNeighbours>(its_tool.surface, 3.0 * half))
{
}

void start(const Contact&, std::size_t nodes, ContactState& c)
{
  constexpr std::size_t group = NodeLanes::group;
  const std::size_t groups = (nodes + group - 1) / group, padded = groups * group;
  for (std::vector<double>* v : {&c.stick_x, &c.stick_y, &c.stick_z, &c.normal_force}) v->assign(padded, 0.0);
  ContactPlanes& p = c.planes;
  for (std::vector<double>* v : {&p.normal_x, &p.normal_y, &p.normal_z}) v->assign(padded, 0.0);
  for (std::vector<float>* v : {&p.anchor_x, &p.anchor_y, &p.anchor_z}) v->assign(padded, 0.0F);
  p.offset.assign(padded, no_plane);
  p.reach_squared.assign(nodes, -1.0F);
  p.reach_squared.resize(padded, HUGE_VALF); // padding never wakes
  p.found.assign(nodes, {});
  p.quiet_until.assign((nodes + NodeLanes::size - 1) / NodeLanes::size, 0.0);
  p.near.assign(groups, 0);
  p.touching.assign(groups, 1); // a state that is read may hold forces
}

namespace {

/// Nodes are taken in blocks: a block belongs to one thread, and sums run over blocks in their order.
constexpr int block_size = NodeLanes::size;
constexpr int groups_a_block = block_size / NodeLanes::group;

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
  const int g = n / NodeLanes::group;
  return {p.normal_x.data() + n, p.normal_y.data() + n, p.normal_z.data() + n, p.offset.data() + n,
          p.anchor_x.data() + n, p.anchor_y.data() + n, p.anchor_z.data() + n, p.reach_squared.data() + n,
          c.stick_x.data() + n,  c.stick_y.data() + n,  c.stick_z.data() + n,  c.normal_force.data() + n,
          p.near.data() + g,     p.touching.data() + g};
}

/// A block of nodes, brought near as far as it is needed.
class NodeBlock {
public:
  NodeBlock(State& s, std::span<const double> area, int first_node)
      : first(first_node), count(std::min(block_size, static_cast<int>(s.position.size()) - first)), s_(s), area_(area)
  {
  }
  void bring_places()
  {
    if (placed_) return;
    placed_ = true;
    split(s_.position.data() + first, count, lanes.x, lanes.y, lanes.z);
    fill_up({lanes.x, lanes.y, lanes.z});
  }
  /// Velocities and areas, and forces that begin at nothing.
  void bring_motion()
  {
    if (moving_) return;
    moving_ = true;
    split(s_.velocity.data() + first, count, lanes.vx, lanes.vy, lanes.vz);
    std::copy_n(area_.data() + first, count, lanes.area);
    for (double* force : {lanes.fx, lanes.fy, lanes.fz}) std::fill_n(force, count, 0.0);
    fill_up({lanes.vx, lanes.vy, lanes.vz, lanes.area, lanes.fx, lanes.fy, lanes.fz});
  }
  void give_forces()
  {
    if (!moving_) return;
    add(lanes.fx, lanes.fy, lanes.fz, count, s_.force.data() + first);
  }

  NodeLanes lanes; ///< filled up to whole groups
  const int first, count;

private:
  void fill_up(std::initializer_list<double*> arrays) const
  {
    for (int i = count; i % NodeLanes::group != 0; ++i)
      for (double* lane : arrays) lane[i] = 0.0;
  }

  bool placed_ = false, moving_ = false;
  State& s_;
  std::span<const double> area_;
};

/// Some of a block's groups, ascending.
struct Groups {
  std::array<std::uint8_t, groups_a_block> number; // NOLINT(cppcoreguidelines-pro-type-member-init): as far as count
  int count = 0;

  void add(int group) { number[count++] = static_cast<std::uint8_t>(group); }
  [[nodiscard]] const std::uint8_t* begin() const { return number.data(); }
  [[nodiscard]] const std::uint8_t* end() const { return number.data() + count; }
};

/// Of some groups' nodes [m].
double least_gap(const GapLanes& gaps, const Groups& groups)
{
  double least = HUGE_VAL;
  for (const std::uint8_t g : groups) least = std::min(least, gaps.least[g]);
  return least;
}

/// For how many steps a block is to be left alone at least.
constexpr double worth_a_rest = 10.0;

/// A tool against a block of nodes: search, gap, force, friction.
ContactSums meet(const Meeting& m, NodeBlock& block)
{
  NodeLanes& nodes = block.lanes;
  const int first = block.first, count = block.count;
  ContactPlanes& planes = m.state.planes;
  double& quiet_until = planes.quiet_until[first / block_size];
  if (planes.way < quiet_until) return {};
  block.bring_places();
  const ContactLanes lanes = lanes_from(m.state, first);
  const auto search_for = [&](int i) {
    search_plane(m.contact, m.tool, planes, Vec3{nodes.x[i], nodes.y[i], nodes.z[i]} - m.law.shift, first + i);
  };
  std::array<std::int32_t, block_size> out; // of their plane's reach
  if (look(nodes, lanes, m.law.shift, count, out.data()) > 0)
    for (int i = 0; i < count; ++i)
      if (out[i] != 0) search_for(i);
  GapLanes gaps;
  // A plane tells nothing of a node that has come behind it.
  const auto search_for_deep = [&](int g) {
    for (int i = g * NodeLanes::group; i < (g + 1) * NodeLanes::group; ++i)
      if (gaps.gap[i] < -m.law.half_thickness && out[i] == 0) search_for(i);
  };
  // Groups that touched a step ago are pressed anyway; of the others those that may touch are measured first.
  Groups near, pressed;
  for (int g = 0; g * NodeLanes::group < count; ++g)
    if (lanes.near[g] != 0 && lanes.touching[g] == 0) near.add(g);
  if (measure(nodes, lanes, m.law, near.begin(), near.count, gaps)) {
    for (const std::uint8_t g : near) search_for_deep(g);
    measure(nodes, lanes, m.law, near.begin(), near.count, gaps);
  }
  for (int g = 0; g * NodeLanes::group < count; ++g)
    if (lanes.touching[g] != 0 || (lanes.near[g] != 0 && gaps.least[g] < 0.0)) pressed.add(g);
  if (pressed.count == 0) {
    if (const double gap = least_gap(gaps, near); gap > worth_a_rest * planes.moved)
      quiet_until = planes.way + std::min(gap, least_room(nodes, lanes, m.law.shift, count));
    return {};
  }
  block.bring_motion();
  PressLanes sums;
  int done = press(nodes, lanes, m.law, pressed.begin(), 0, pressed.count, false, gaps, sums);
  while (done < pressed.count) {
    search_for_deep(pressed.number[static_cast<std::size_t>(done)]);
    done = press(nodes, lanes, m.law, pressed.begin(), done, pressed.count, true, gaps, sums);
  }
  return total(sums);
}

/// Whether a node of a block touches more tools than are counted of it.
bool touches_more(std::span<const ContactState> states, std::span<const double> counted, const NodeBlock& block)
{
  constexpr int group = NodeLanes::group;
  for (int g = 0; g * group < block.count; ++g) {
    int tools = 0; // of the group
    for (const ContactState& c : states) tools += c.planes.touching[block.first / group + g];
    if (tools < 2) continue;
    for (int n = block.first + g * group; n < block.first + std::min((g + 1) * group, block.count); ++n) {
      double touched = 0.0;
      for (const ContactState& c : states) touched += c.normal_force[n] > 0.0 ? 1.0 : 0.0;
      if (touched > counted[n]) return true;
    }
  }
  return false;
}

/// What the blocks tell of a tool, in their order.
void take_sums(std::span<const ContactSums> sums, ToolState& tool, ContactState& c, std::span<const Vec3> position,
               const ContactLaw& law)
{
  Vec3 force;
  tool.stiffness = 0.0;
  c.energies.elastic = 0.0;
  c.penetration = 0.0;
  std::size_t deepest = 0;
  for (std::size_t block = 0; block < sums.size(); ++block) {
    const ContactSums& sum = sums[block];
    force += sum.force;
    c.energies.elastic += sum.elastic;
    c.energies.damping += sum.damped;
    c.energies.friction += sum.rubbed;
    tool.stiffness += sum.stiffness;
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

bool contact_forces(std::span<const Contact> contacts, std::span<const Tool> tools, std::span<ToolState> tool_states,
                    std::span<ContactState> states, std::span<const double> area, std::span<const double> counted, State& s,
                    double dt, double moved)
{
  if (contacts.empty()) return false;
  const int nodes = static_cast<int>(s.position.size());
  const int blocks = (nodes + block_size - 1) / block_size;
  std::vector<Meeting> meetings;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact& contact = contacts[i];
    const Tool& tool = tools[contact.tool];
    const ToolState& t = tool_states[contact.tool];
    ContactPlanes& planes = states[i].planes;
    planes.moved = moved + std::abs(t.displacement - planes.shift);
    planes.way += planes.moved;
    planes.shift = t.displacement;
    meetings.push_back({contact, tool, states[i],
                        {t.displacement * tool.direction, t.velocity * tool.direction, tool.direction, contact.half_thickness,
                         contact.stiffness_per_area, contact.soft, contact.soft_depth, contact.damping_per_area,
                         contact.stick_ratio, tool.friction, dt}});
  }
  std::atomic<bool> more{false};
  std::vector<ContactSums> sums(contacts.size() * static_cast<std::size_t>(blocks));
  parallel_each(blocks, [&](int block) {
    NodeBlock its_nodes(s, area, block * block_size);
    for (std::size_t i = 0; i < meetings.size(); ++i)
      sums[i * static_cast<std::size_t>(blocks) + block] = meet(meetings[i], its_nodes);
    its_nodes.give_forces();
    if (!counted.empty() && touches_more(states, counted, its_nodes)) more = true;
  });
  for (std::size_t i = 0; i < contacts.size(); ++i)
    take_sums(std::span(sums).subspan(i * static_cast<std::size_t>(blocks), static_cast<std::size_t>(blocks)),
              tool_states[contacts[i].tool], states[i], s.position, meetings[i].law);
  return more;
}

} // namespace towform
