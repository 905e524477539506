#include "key_table.hpp"
#include <algorithm>

namespace towform {

std::string Row::section() const
{
  const std::size_t dot = path.find('.');
  return dot == std::string::npos ? "" : path.substr(0, dot);
}

std::string Row::name() const { return path.substr(path.rfind('.') + 1); }

const Row& row_of(const std::string& path)
{
  const std::vector<Row>& rows = key_table();
  return *std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.path == path; });
}

bool is_list_section(const std::string& section) { return section == "tool" || section == "boundary"; }

bool is_motion_key(const Row& row)
{
  return row.path.starts_with("tool.motion.") || row.path.starts_with("boundary.motion.");
}

namespace {

/// Words for the enumerators of E, in their order.
template <class F>
Words words(F at, std::vector<std::string> names)
{
  using E = std::remove_reference_t<decltype(at(std::declval<Target&>()))>;
  return {std::move(names), [at](Target& t) { return static_cast<int>(at(t)); },
          [at](Target& t, int place) { at(t) = static_cast<E>(place); }};
}

// When a key counts: which blank, which model of the sheet and of its matrix was chosen before it.
bool rectangle(const Case& c) { return c.blank.mesh.empty(); }
bool square_yarns(const Case& c) { return !c.blank.fibre_1 && !c.blank.fibre_2; }
bool model(const Case& c) { return c.material.has_model(); }
bool formula(const Case& c) { return model(c) && c.material.constituents.matrix.model != MatrixModel::table; }
bool table(const Case& c) { return model(c) && c.material.constituents.matrix.model == MatrixModel::table; }
bool yasuda(const Case& c)
{
  return model(c) && c.material.constituents.matrix.model == MatrixModel::carreau_yasuda;
}
bool arrhenius(const Case& c)
{
  return model(c) && c.material.constituents.matrix.shift == TemperatureShift::arrhenius;
}
bool wlf(const Case& c) { return model(c) && c.material.constituents.matrix.shift == TemperatureShift::wlf; }
bool own_law(const Case& c) { return c.material.law == LawKind::own; }
bool bending(const Case& c) { return c.material.has_bending(); }

/// Words that mean something for grips only.
Words of_grips(Words w)
{
  return {std::move(w.names),
          [get = std::move(w.get)](Target& t) {
            return t.boundary->kind == BoundaryParameters::Kind::grip ? get(t) : -1;
          },
          std::move(w.set)};
}

using D = Dimension;

// clang-format off
// A member of the target as a function, so that one row is one line.
#define AT(member) [](Target& t) -> auto& { return t.member; } // NOLINT(bugprone-macro-parentheses)

std::vector<Row> all_rows()
{
  const std::vector<std::string> axes{"x", "y", "z"};
  return {
    {"title", AT(c.title), D::none, "\"\"", "", "shown in results and reports"},
    {"solver", words(AT(c.solver), {"explicit", "implicit"}), D::none, "explicit", "", "explicit dynamics, or quasi-static equilibrium for specimen tests"},

    {"blank.mesh", AT(c.blank.mesh), D::none, optional, "", "flat blank of any outline in place of a rectangle: Gmsh file, MSH 4.1 ASCII, triangles and quadrilaterals (cut in two where the triangles are best) in a plane z = const, looked for as a tool's mesh is"},
    {"blank.mesh_unit", AT(c.blank.mesh_unit), D::length, "1 m", "> 0", "length of the file's unit; \"mm\" stands for \"1 mm\"", "blank.mesh", true},
    {"blank.size", AT(c.blank.size), D::length, required, "> 0", "whole blank along x and y, centred on the origin; this or mesh", "", false, rectangle},
    {"blank.elements", AT(c.blank.elements), D::none, optional, "2 .. 20000000", "wanted number of elements of the whole blank; this or edge", "", false, rectangle},
    {"blank.edge", AT(c.blank.edge), D::length, optional, "> 0", "wanted edge of the grid's squares; this or elements", "", false, rectangle},
    {"blank.fibre_1", AT(c.blank.fibre_1), D::none, optional, "", "direction of the warp in the plane of the blank, of any length; with fibre_2, in place of fibre_angle"},
    {"blank.fibre_2", AT(c.blank.fibre_2), D::none, optional, "", "direction of the weft, not necessarily square to fibre_1; the sheet is free of force at the angle between the two, and shear is counted from there"},
    {"blank.fibre_angle", AT(c.blank.fibre_angle), D::angle, "0 deg", "", "warp against x, weft at right angles to it", "", false, square_yarns},
    {"blank.mesh_angle", AT(c.blank.mesh_angle), D::angle, "0 deg", "", "grid lines against the warp", "", false, rectangle},
    {"blank.pattern", words(AT(c.blank.pattern), {"cross", "diagonal", "unstructured"}), D::none, "diagonal", "", "how squares become triangles; unstructured has no grid", "", false, rectangle},
    {"blank.element", words(AT(c.blank.element), {"triangle", "quadrilateral"}), D::none, "triangle", "", "quadrilateral needs solver = \"implicit\" and keeps the grid's squares whole", "", false, rectangle},
    {"blank.thickness", AT(c.blank.thickness), D::length, required, "1 um .. 0.1 m", "of the whole sheet at the start"},
    {"blank.tilt", AT(c.blank.tilt), D::angle, "[0, 0]", "", "of the blank as it lies at the start, about x and then about y; explicit solver only"},
    {"blank.symmetry", words(AT(c.blank.symmetry), {"none", "x", "y", "quarter"}), D::none, "none", "", "x models the half x >= 0, y the half y >= 0, quarter both; a mesh has to be that part, its nodes on x = 0 and y = 0 are on the mirrors"},

    {"material.card", AT(c.material.card), D::none, optional, "", "gives the keys of this table that the case does not: a name in a folder cards, or a path ending in .toml"},
    {"material.source", AT(c.material.source), D::none, optional, "", "where the values come from; shown with every prediction"},
    {"material.curves", AT(c.material.curves), D::none, optional, "", "file of shear curves that takes the place of the model of the constituents, looked for as a tool's mesh is (named in a card, also beside it)"},
    {"material.shear_tangent", AT(c.material.shear_tangent), D::pressure, optional, "", "[c0, c1, …]: tangent shear modulus c0 + c1 g + c2 g^2 + … over the shear angle g in rad, times the thickness, in place of the model; negative counts as 0; law elastic only"},
    {"material.law", words(AT(c.material.law), {"viscous", "incremental", "elastic", "own"}), D::none, "viscous", "", "how the shear force follows the angle and its rate; own: a law of the program that calls towform as a library (docs/library.md)"},
    {"material.own_law", AT(c.material.own_law_words), D::none, required, "", "that law in the program's words, as its results record it", "", false, own_law},
    {"material.curve_selection", words(AT(c.material.curve_selection), {"next_higher", "interpolate"}), D::none, "next_higher", "", "which curve the incremental law follows"},
    {"material.velocity_scale", AT(c.material.velocity_scale), D::none, "1", "> 0", "factor on the rate where a curve is chosen, nowhere else"},
    {"material.temperature", AT(c.material.temperature), D::temperature, required, "200 K .. 1000 K", "of the sheet"},
    {"material.curve_rate_min", AT(c.material.curve_rate_min), D::angular_rate, "1 rad/s", "> 0", "rate of the first curve", "", false, model},
    {"material.curve_rate_max", AT(c.material.curve_rate_max), D::angular_rate, "20 rad/s", "> 0", "rate of the last curve", "", false, model},
    {"material.curve_count", AT(c.material.curve_count), D::none, "20", "1 .. 1000", "curves, in equal increments of rate", "", false, model},
    {"material.elastic_rate", AT(c.material.elastic_rate), D::angular_rate, "10 rad/s", "> 0", "rate of the curve that the elastic law follows"},
    {"material.fibre_modulus", AT(c.material.fibre_modulus), D::pressure, required, "> 0", "of one yarn direction, over the whole thickness"},
    {"material.compression_factor", AT(c.material.compression_factor), D::none, "0.1", "0 .. 1", "yarn stiffness in compression over that in tension"},
    {"material.yarn_damping", AT(c.material.yarn_damping), D::none, "0.05", "0 .. 1", "along the yarns, fraction of critical"},
    {"material.yarn_strain", words(AT(c.material.yarn_strain), {"auto", "strip", "triangle"}), D::none, "auto", "", "that yarns answer to: the mean over a strip of yarn, or a triangle's own, which locks where the mesh does not follow the yarns; auto looks whether it does"},
    {"material.strip_stiffness", AT(c.material.strip_stiffness), D::none, optional, "1 .. 10000", "spring that holds a triangle's yarn strain to its strip's, over the sheet's shear force at 45 degrees and 1 rad over time.end; 50 where it is not given, 300 where the mesh follows the yarns"},
    {"material.relaxation_ratio", AT(c.material.relaxation_ratio), D::none, "0.1", "1e-4 .. 1", "shear modulus of the viscous law over the yarn stiffness; a smaller one allows longer steps, and more of the shear is elastic"},
    {"material.bending_stiffness", AT(c.material.bending_stiffness), D::bending_stiffness, optional, "> 0", "moment per width over the curvature of a yarn; one for both families or [warp, weft]; without it or a table the sheet does not resist bending"},
    {"material.bending_table", AT(c.material.bending_table), D::force, optional, "> 0", "[[curvature, moment per width], …] of both families in place of bending_stiffness, curvatures rising; straight from (0, 0) through the points and on, odd, without hysteresis"},
    {"material.bending_damping", AT(c.material.bending_damping), D::none, "0.05", "0 .. 1", "of bending, fraction of critical for its fastest waves", "", false, bending},
    {"material.fibre_volume_fraction", AT(c.material.constituents.fibre_volume_fraction), D::none, required, "> 0, <= 0.9", "of the composite", "", false, model},
    {"material.tow_width", AT(c.material.constituents.tow_width), D::length, required, "> 0", "of a tow", "", false, model},
    {"material.tow_gap", AT(c.material.constituents.tow_gap), D::length, required, ">= 0", "between neighbouring tows", "", false, model},
    {"material.fibre_diameter", AT(c.material.constituents.fibre_diameter), D::length, required, "> 0", "of one filament", "", false, model},
    {"material.weave_factor", AT(c.material.constituents.weave_factor), D::none, "1", "> 0", "q of the weave, on the matrix between the tows", "", false, model},
    {"material.density", AT(c.material.constituents.density), D::density, required, "> 0", "of the composite"},
    {"material.tow_viscosity", words(AT(c.material.constituents.tow_viscosity), {"hexagonal_cell", "coffin"}), D::none, "hexagonal_cell", "", "model of a tow's viscosities", "", false, model},
    {"material.fibre_packing", words(AT(c.material.constituents.fibre_packing), {"hexagonal", "square"}), D::none, "hexagonal", "", "of the fibres in a tow", "", false, model},
    {"material.crossover_field", words(AT(c.material.constituents.crossover_field), {"derived", "printed"}), D::none, "derived", "", "velocity field between crossing tows", "", false, model},
    {"material.tow_kinematics", words(AT(c.material.constituents.tow_kinematics), {"measured", "minimum_power"}), D::none, "measured", "", "how fast the tows shear: as measured on a 2x2 twill, or with the least power", "", false, model},
    {"material.matrix.model", words(AT(c.material.constituents.matrix.model), {"cross", "carreau_yasuda", "power_law", "table"}), D::none, "cross", "", "viscosity against shear rate", "", false, model},
    {"material.matrix.shift", words(AT(c.material.constituents.matrix.shift), {"arrhenius", "wlf"}), D::none, "arrhenius", "", "of the viscosity with temperature", "", false, model},
    {"material.matrix.zero_shear_viscosity", AT(c.material.constituents.matrix.zero_shear_viscosity), D::viscosity, required, "> 0", "at the reference temperature", "", false, formula},
    {"material.matrix.time_constant", AT(c.material.constituents.matrix.time_constant), D::time, required, ">= 0", "at the reference temperature; a power law holds above the rate 1/time_constant, below it the viscosity is constant", "", false, formula},
    {"material.matrix.exponent", AT(c.material.constituents.matrix.exponent), D::none, required, "> 0, <= 1", "1 does not thin", "", false, formula},
    {"material.matrix.transition", AT(c.material.constituents.matrix.transition), D::none, "2", "> 0", "Yasuda's exponent a; 2 is Carreau's model", "", false, yasuda},
    {"material.matrix.table", AT(c.material.constituents.matrix.points), D::viscosity, required, "> 0", "[[shear rate in 1/s, viscosity], …] at the reference temperature, rates rising; log-log between them, constant below, power law above", "", false, table},
    {"material.matrix.reference_temperature", AT(c.material.constituents.matrix.reference_temperature), D::temperature, required, "200 K .. 1000 K", "of the viscosities and the time constant", "", false, model},
    {"material.matrix.activation_energy", AT(c.material.constituents.matrix.activation_energy), D::molar_energy, required, ">= 0", "Arrhenius shift with temperature", "", false, arrhenius},
    {"material.matrix.wlf_c1", AT(c.material.constituents.matrix.wlf_c1), D::none, required, ">= 0", "C1 of the WLF shift (of the decimal logarithm)", "", false, wlf},
    {"material.matrix.wlf_c2", AT(c.material.constituents.matrix.wlf_c2), D::none, required, "> 0", "C2 of the WLF shift, in K", "", false, wlf},

    {"tool.name", AT(tool->name), D::none, required, "", "letters, digits, _ and -; names the tool in results"},
    {"tool.mesh", AT(tool->mesh), D::none, required, "", "STL file, looked for beside the case, in the current folder and in towform's data"},
    {"tool.mesh_unit", AT(tool->mesh_unit), D::length, "1 m", "> 0", "length of the file's unit; \"mm\" stands for \"1 mm\"", "", true},
    {"tool.position", AT(tool->position), D::length, "[0, 0, 0]", "", "added to the mesh at the start"},
    {"tool.friction", AT(tool->friction), D::none, "0.3", "0 .. 10", "Coulomb coefficient against the sheet"},
    {"tool.force", AT(tool->force), D::force, optional, "", "pushes the tool along axis; this or motion, neither fixes it"},
    {"tool.axis", words(AT(tool->axis), axes), D::none, "z", "", "of the force", "tool.force"},
    {"tool.mass", AT(tool->mass), D::mass, "0.5 kg", "> 0", "of the tool that the force moves", "tool.force"},
    {"tool.damping", AT(tool->damping), D::none, "0.1", "0 .. 1", "of its motion on the sheet, fraction of critical", "tool.force"},
    {"tool.motion.axis", words(AT(motion()->axis), axes), D::none, "z", "", "of the motion"},
    {"tool.motion.profile", words(AT(motion()->profile), {"constant", "smooth", "table"}), D::none, "constant", "", "of the speed; smooth starts and ends at rest"},
    {"tool.motion.displacement", MotionAmount{Motion::Quantity::displacement}, D::length, optional, "", "reached at time.end; this or velocity"},
    {"tool.motion.velocity", MotionAmount{Motion::Quantity::velocity}, D::velocity, optional, "", "kept up throughout; this or displacement"},
    {"tool.motion.table", MotionTable{}, D::none, optional, "", "[[time, value], …] of profile table, values with a unit of length or velocity"},

    {"boundary.name", AT(boundary->name), D::none, required, "", "letters, digits, _ and -; names the boundary in results, unlike any tool"},
    {"boundary.kind", words(AT(boundary->kind), {"grip", "picture_frame"}), D::none, "grip", "", "holds one edge, or all four of a square blank in a frame hinged at the corners"},
    {"boundary.edge", of_grips(words(AT(boundary->edge), {"left", "right", "bottom", "top"})), D::none, optional, "", "that a grip holds: x = -a/2, x = a/2, y = -b/2, y = b/2; of a mesh the nodes on that side of its bounding box (within 1e-6 of its width), two or more"},
    {"boundary.motion.axis", of_grips(words(AT(motion()->axis), axes)), D::none, optional, "", "along which a grip moves; a frame's corner (a/2, b/2) moves along the diagonal, opening the frame"},
    {"boundary.motion.profile", words(AT(motion()->profile), {"constant", "smooth", "table"}), D::none, "constant", "", "of the speed; smooth starts and ends at rest"},
    {"boundary.motion.displacement", MotionAmount{Motion::Quantity::displacement}, D::length, optional, "", "reached at time.end; this or velocity"},
    {"boundary.motion.velocity", MotionAmount{Motion::Quantity::velocity}, D::velocity, optional, "", "kept up throughout; this or displacement"},
    {"boundary.motion.table", MotionTable{}, D::none, optional, "", "[[time, value], …] of profile table, values with a unit of length or velocity"},

    {"load.gravity", AT(c.load.gravity), D::acceleration, "[0, 0, 0]", "", "acceleration of every part of the sheet; explicit solver only"},
    {"load.pressure", AT(c.load.pressure), D::pressure, optional, "", "on the face of the sheet that looks along +z at the start, square to the sheet wherever it goes: one value or [[time, pressure], …], straight lines between the points; explicit solver only"},

    {"time.end", AT(c.time.end), D::time, required, "> 0", "of the run"},
    {"time.safety", AT(c.time.safety), D::none, "0.97", "> 0, <= 1", "step over the stable step"},
    {"time.mass_scaling", AT(c.time.mass_scaling), D::none, "1", "1 .. 1000000", "uniform factor on the sheet's mass"},
    {"time.lumping", AT(c.time.lumping), D::none, "0", "0 .. 0.5", "share of the sheet's mass that is put where yarns hold nodes stiffly, the rest in thirds of triangles on their corners (all under gravity): 0.2 makes steps a tenth to a half longer, but unstable where a sheet that hardly resists bending crumples freely"},
    {"time.step", AT(c.time.step), D::time, optional, "> 0", "wanted step: elements that need it are made heavier"},
    {"time.mass_damping", AT(c.time.mass_damping), D::frequency, "0", ">= 0", "force on a node over its mass and velocity"},
    {"time.subcycling", AT(c.time.subcycling), D::none, "true", "", "bending, slow beside the yarns' waves, is computed every few steps and held between, eight at most"},

    {"contact.penalty", AT(c.contact.penalty), D::none, "0.3", "> 0, <= 1", "stiffness of contact over node mass / step^2, of the sheet with its masses in thirds (time.lumping)"},
    {"contact.soft", AT(c.contact.soft), D::none, "0.1", "> 0, <= 1", "stiffness at first touch over that of penalty; 1 for a linear spring"},
    {"contact.soft_depth", AT(c.contact.soft_depth), D::none, "0.02", "0 .. 0.1", "how deep contact is soft, over the sheet's thickness"},
    {"contact.damping", AT(c.contact.damping), D::none, "0.1", "0 .. 1", "normal to the tool, fraction of critical"},
    {"contact.stick", AT(c.contact.stick), D::none, "0.1", "> 0, <= 1", "stiffness and damping along the tool over those normal to it"},

    {"gates.energy_error", AT(c.gates.energy_error), D::none, "0.02", "> 0", "largest error of the energy balance over the external work"},
    {"gates.kinetic_to_internal", AT(c.gates.kinetic_to_internal), D::none, "5", "> 0", "largest kinetic over internal energy in the second half of the run"},
    {"gates.penetration", AT(c.gates.penetration), D::length, "0.2 mm", "> 0", "deepest penetration of the sheet's surface into a tool"},
    {"gates.yarn_strain", AT(c.gates.yarn_strain), D::none, "0.05", "> 0", "99th percentile of the yarns' strain"},

    {"output.frames", AT(c.output.frames), D::none, "30", "1 .. 100000", "in results.h5 after the initial one"},
    {"output.history", AT(c.output.history), D::none, "200", "1 .. 1000000", "rows of history.csv after the initial one, evenly over the run: of an explicit one at the steps nearest to their times where these are many"},
    {"output.checkpoint", AT(c.output.checkpoint), D::time, "5 min", ">= 0", "wall time between checkpoints; 0: only when the run is interrupted"},
    {"output.report", AT(c.output.report), D::none, "true", "", "write report.html when the run ends"},

    {"report.locking_angle", AT(c.report.locking_angle), D::angle, "60 deg", "> 0 deg, < 90 deg", "shear above which the report takes the sheet to wrinkle; the default is typical of twills, not measured on this sheet"},
    {"report.reference", AT(c.report.reference), D::none, optional, "", "CSV file of published, exact or measured points to draw over the sheet's own, looked for as a tool's mesh is; its columns as for towform compare"},
    {"report.where", AT(c.report.where), D::none, "\"\"", "", "rows of the reference to take, as \"layup=0/90\"; more than one condition between commas", "report.reference"},
    {"report.columns", AT(c.report.columns), D::none, "\"\"", "", "columns of the reference to take, as \"x=y_mm, y=x_mm\"", "report.reference"},
    {"report.from", AT(c.report.from), D::length, optional, "", "[x, y] where the section starts, in plan; the middle of the blank without it"},
    {"report.to", AT(c.report.to), D::length, optional, "", "[x, y] where the section ends; a corner of the blank without it"},
    {"report.centre", AT(c.report.centre), D::length, optional, "", "of the sphere on which the reference counts polar angles", "report.reference"},
    {"report.mirror", AT(c.report.mirror), D::none, "false", "", "fold points of other quarters into the part that is modelled", "report.reference"},
    {"report.nodal", AT(c.report.nodal), D::none, "false", "", "compare means at the nodes in place of the elements' own values", "report.reference"},
  };
}
// clang-format on
#undef AT

} // namespace

const std::vector<Row>& key_table()
{
  static const std::vector<Row> rows = all_rows();
  return rows;
}

} // namespace towform
