#pragma once
#include "contact/tool.hpp"
#include "towform/state.hpp"
#include <array>
#include <vector>

namespace towform {

/// Node-to-surface penalty contact of the sheet with one tool (physics: contact). A node touches when the
/// tool is nearer than half the sheet's thickness, on either face. Normal force k g + damping, never pulling;
/// Coulomb friction through a tangential spring k_t with return mapping, so that a resting sheet does not
/// creep.
struct Contact {
  int tool = 0;
  double half_thickness = 0.0;   ///< [m]
  std::vector<double> stiffness; ///< n, k = beta m / dt^2 [N/m]
  std::vector<double> damping;   ///< n, c = 2 zeta sqrt(k m), normal and while sticking [N s/m]
  double stick_ratio = 1.0;      ///< k_t / k
};

/// What the search remembers about a node: the facets below hold the nearest one while the node is within
/// `reach` of `anchor`. Only speed depends on it, never the result.
struct SearchMemory {
  static constexpr std::size_t capacity = 8;
  Vec3 anchor;         ///< in the tool's frame
  float reach = -1.0F; ///< [m]
  int count = 0;
  std::array<NearFacet, capacity> facets{}; ///< nearest to the anchor first
};

/// The plane of the facet that a node is nearest to while it is within a distance of `anchor`. Only speed
/// depends on it, as the facet search gives the same bits.
struct NearPlane {
  Vec3 normal;                 ///< of the facet
  double offset = 0.0;         ///< of the facet [m]
  Vec3 anchor;                 ///< in the tool's frame
  double reach_squared = -1.0; ///< [m^2]
};

/// Energies of contact with a tool. Elastic at t_n; the others since the start [J].
struct ContactEnergies {
  double elastic = 0.0, damping = 0.0, friction = 0.0;
};

/// What changes of a contact.
struct ContactState {
  std::vector<Vec3> stick;          ///< n, stretch of the tangential spring [m]
  std::vector<double> normal_force; ///< n [N]
  double penetration = 0.0;         ///< deepest at t_n [m]
  int deepest_node = 0;
  ContactEnergies energies;

  std::vector<NearPlane> plane;     ///< n
  std::vector<SearchMemory> memory; ///< n
  std::vector<double> wake;         ///< n, travel at which the tool may be reached [m]
  double travel = 0.0;              ///< bound of what any node has moved against the tool since the start [m]
};

/// Sizes a contact's state.
void start(const Contact& contact, std::size_t nodes, ContactState& c);

/// Adds the contact forces at x_n to s.force and sets the tool's reaction. `fastest` bounds the sheet's nodal
/// speeds over the last step [m/s].
void contact_forces(const Contact& contact, const Tool& tool, ToolState& tool_state, ContactState& c,
                    State& s, double dt, double fastest);

} // namespace towform
