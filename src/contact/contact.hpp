#pragma once
#include "contact/facet_neighbours.hpp"
#include "contact/tool.hpp"
#include "towform/state.hpp"
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace towform {

/// Node-to-surface penalty contact of the sheet with one tool (physics: contact). A node touches when the
/// tool is nearer than half the sheet's thickness, on either face. Normal force of a spring and damping, never pulling: the
/// spring has the part `soft` of its stiffness k down to a small depth, so that nodes that graze a tool do not bounce off it;
/// Coulomb friction through a tangential spring k_t with return mapping, so that a resting sheet does not
/// creep. Stiffness and damping are in proportion to a node's part of the sheet, with m its mass were that spread evenly:
/// k = beta m / dt^2, c = 2 zeta sqrt(k m).
struct Contact {
  int tool = 0;
  double half_thickness = 0.0;     ///< [m]
  double stiffness_per_area = 0.0; ///< [N/m^3]
  double soft = 1.0;               ///< stiffness at first touch over k; 1: a linear spring
  double soft_depth = 0.0;         ///< [m]
  double damping_per_area = 0.0;   ///< of the normal motion [N s/m^3]
  double stick_ratio = 1.0;        ///< stiffness and, while sticking, damping along the tool over those normal to it
  std::unique_ptr<const FacetNeighbours> neighbours;

  Contact() = default;
  /// With `tool` number `number`, which must stay where it is. `beta` and `zeta` [-] at steps of dt [s] of a sheet of
  /// `mass_per_area` [kg/m^2].
  Contact(const Tool& tool, int number, double half_thickness, double beta, double zeta, double mass_per_area, double dt);
};

/// Energies of contact with a tool. Elastic at t_n; the others since the start [J].
struct ContactEnergies {
  double elastic = 0.0, damping = 0.0, friction = 0.0;
};

/// Where a search has found a node's nearest point.
struct FoundLast {
  int facet = -1;     ///< -1 before the first search
  int rival = -1;     ///< the facet beyond the edge that it was on; -1 for none
  float clear = -1.0F; ///< FacetNeighbours::Nearest::clear from the anchor [m]; negative: not known, or no rival
};

/// What a search has found out about nodes, as long as they are within a distance of an anchor: the plane of the facet
/// that a node is nearest to, or that it cannot touch; or both facets of an edge that it is nearest to. Only speed depends
/// on it, as a search gives the same bits. Arrays that vectors read are padded to whole groups of nodes (NodeLanes).
struct ContactPlanes {
  std::vector<double> normal_x, normal_y, normal_z, offset; ///< n, normal . x = offset [m]; far below for no plane
  std::vector<float> anchor_x, anchor_y, anchor_z;          ///< n, in the tool's frame [m]
  std::vector<float> reach_squared;                         ///< n [m^2]; negative: to be searched for
  std::vector<FoundLast> found;                             ///< n
  std::vector<double> quiet_until;    ///< per block, the way at which one of its nodes may have come near the tool [m]
  double way = 0.0;                   ///< how far a node may have moved against the tool since the start [m]
  double moved = 0.0;                 ///< of that in the last step [m]
  double shift = 0.0;                 ///< of the tool, when that was last added to [m]
  std::vector<std::uint8_t> near;     ///< per group, whether one of them has a plane
  std::vector<std::uint8_t> touching; ///< per group, whether one of them touches the tool
};

/// What changes of a contact.
struct ContactState {
  std::vector<double> stick_x, stick_y, stick_z; ///< n and padding, stretch of the tangential spring [m]
  std::vector<double> normal_force;              ///< n and padding [N]
  double penetration = 0.0; ///< deepest at t_n [m]
  int deepest_node = 0;
  ContactEnergies energies;
  ContactPlanes planes;
};

/// Sizes a contact's state.
void start(const Contact& contact, std::size_t nodes, ContactState& c);

/// How far from the tool a node at p [tool's frame] is at least, as the last search told [m]; 0 where it did not.
[[nodiscard]] double least_distance(const Contact& contact, const ContactState& c, std::size_t node, const Vec3& p);

/// Signed distance from the tool of a node at p [tool's frame] [m], where the plane that the last search found still tells it.
[[nodiscard]] std::optional<double> distance_from_plane(const ContactPlanes& planes, std::size_t node, const Vec3& p);

/// Adds the contact forces at x_n to s.force and sets the tools' reactions. `area` of each node's part of the sheet [m^2]; `moved`
/// bounds how far a node has moved since the forces were last computed [m]. Returns whether a node touches more tools than are
/// `counted` of it (a number a node; empty: never).
bool contact_forces(std::span<const Contact> contacts, std::span<const Tool> tools, std::span<ToolState> tool_states,
                    std::span<ContactState> states, std::span<const double> area, std::span<const double> counted, State& s,
                    double dt, double moved);

} // namespace towform
