#include "case_files.hpp"
#include <numbers>

namespace towform {

using ReadCase = CaseFiles;

TEST_F(ReadCase, SampleInSiUnits)
{
  const Case c = read(sample_case);
  EXPECT_EQ(c.title, "Double dome, 0/90");
  EXPECT_EQ(c.path, at("case.toml"));
  EXPECT_EQ(c.text, sample_case);
  // Every value is the double nearest to the decimal number.
  EXPECT_EQ(c.blank.size, (Vec2{0.65, 0.45}));
  EXPECT_EQ(c.blank.elements, 21706);
  EXPECT_FALSE(c.blank.edge);
  EXPECT_DOUBLE_EQ(c.blank.fibre_angle, std::numbers::pi / 4);
  EXPECT_EQ(c.blank.mesh_angle, 0.0);
  EXPECT_EQ(c.blank.pattern, Pattern::diagonal);
  EXPECT_EQ(c.blank.thickness, 0.001);
  EXPECT_EQ(c.blank.symmetry, Symmetry::none);
  ASSERT_EQ(c.tools.size(), 2U);
  const ToolParameters& punch = c.tools[0];
  EXPECT_EQ(punch.name, "punch");
  EXPECT_EQ(punch.mesh, at("meshes/punch.stl"));
  EXPECT_EQ(punch.mesh_unit, 1.0);
  EXPECT_EQ(punch.friction, 0.25);
  ASSERT_TRUE(punch.motion);
  EXPECT_EQ(punch.motion->axis, Axis::z);
  EXPECT_EQ(punch.motion->quantity, Motion::Quantity::displacement);
  EXPECT_EQ(punch.motion->amount, -0.06);
  EXPECT_EQ(punch.motion->duration, 0.06);
  EXPECT_FALSE(punch.force);
  const ToolParameters& holder = c.tools[1];
  EXPECT_EQ(holder.force, -35.0);
  EXPECT_EQ(holder.axis, Axis::z);
  EXPECT_EQ(holder.mass, 0.5);
  EXPECT_EQ(holder.friction, 0.3);
  EXPECT_FALSE(holder.motion);
  EXPECT_EQ(c.time.end, 0.06);
  EXPECT_EQ(c.output.frames, 40);
}

TEST_F(ReadCase, DefaultsOfWhatIsNotGiven)
{
  const Case c = read(sample_case);
  EXPECT_EQ(c.material.velocity_scale, 1.0);
  EXPECT_EQ(c.material.curve_rate_min, 1.0);
  EXPECT_EQ(c.material.curve_rate_max, 20.0);
  EXPECT_EQ(c.material.curve_count, 20);
  EXPECT_EQ(c.material.elastic_rate, 10.0);
  EXPECT_EQ(c.time.safety, 0.97);
  EXPECT_EQ(c.time.mass_scaling, 1.0);
  EXPECT_FALSE(c.time.step);
  EXPECT_EQ(c.time.mass_damping, 0.0);
  EXPECT_EQ(c.contact.penalty, 0.3);
  EXPECT_EQ(c.contact.soft, 0.1);
  EXPECT_EQ(c.contact.soft_depth, 0.02);
  EXPECT_EQ(c.contact.damping, 0.1);
  EXPECT_EQ(c.contact.stick, 0.1);
  EXPECT_EQ(c.gates.energy_error, 0.02);
  EXPECT_EQ(c.gates.kinetic_to_internal, 5.0);
  EXPECT_EQ(c.gates.penetration, 0.0002);
  EXPECT_EQ(c.gates.yarn_strain, 0.05);
  EXPECT_EQ(c.output.history, 200);
}

TEST_F(ReadCase, CardGivesTheConstituentsAndTheCaseComesFirst)
{
  const Case c = read(sample_case);
  const Constituents& k = c.material.constituents;
  EXPECT_EQ(c.material.card, "gf_pp_twill");
  EXPECT_EQ(c.material.card_file.filename(), "gf_pp_twill.toml");
  EXPECT_EQ(c.material.temperature, 190 + 273.15);
  EXPECT_EQ(c.material.fibre_modulus, 2e9); // the card has 1 GPa
  EXPECT_EQ(c.material.compression_factor, 0.1);
  EXPECT_EQ(c.material.yarn_damping, 0.05);
  EXPECT_EQ(c.material.relaxation_ratio, 0.1);
  EXPECT_EQ(k.fibre_volume_fraction, 0.35);
  EXPECT_EQ(k.tow_width, 0.00455);
  EXPECT_EQ(k.tow_gap, 0.00045);
  EXPECT_EQ(k.fibre_diameter, 17e-6);
  EXPECT_EQ(k.weave_factor, 1.0);
  EXPECT_EQ(k.density, 1480.0);
  EXPECT_EQ(k.matrix.zero_shear_viscosity, 300.0);
  EXPECT_EQ(k.matrix.time_constant, 0.03);
  EXPECT_EQ(k.matrix.exponent, 0.35);
  EXPECT_EQ(k.matrix.reference_temperature, 190 + 273.15);
  EXPECT_EQ(k.matrix.activation_energy, 40000.0);
}

TEST_F(ReadCase, CardOfTheCasesFolderComesBeforeOurs)
{
  write("cards/gf_pp_twill.toml", R"(fibre_volume_fraction = "40 %"
tow_width = "4 mm"
tow_gap = 0
fibre_diameter = "10 um"
density = "1.5 g/cm^3"
fibre_modulus = "3 GPa"
matrix = { zero_shear_viscosity = 10, time_constant = 0, exponent = 1, reference_temperature = 500, activation_energy = 0 }
)");
  const Case c = read(sample_case + "[material.matrix]\nexponent = 0.5\n");
  EXPECT_EQ(c.material.constituents.fibre_volume_fraction, 0.4);
  EXPECT_EQ(c.material.constituents.density, 1500.0);
  EXPECT_EQ(c.material.constituents.matrix.exponent, 0.5); // one key of a card's sub-table replaced
  EXPECT_EQ(c.material.constituents.matrix.zero_shear_viscosity, 10.0);
  EXPECT_EQ(c.material.card, at("cards/gf_pp_twill.toml").string()); // not ours: named by its path
  EXPECT_EQ(c.where("material.tow_gap").file, at("cards/gf_pp_twill.toml").string());
  EXPECT_EQ(c.where("material.tow_gap").line, 3);
}

TEST_F(ReadCase, PlacesOfKeys)
{
  const Case c = read(sample_case);
  const auto place = [&](const std::string& key) {
    const SourceLocation where = c.where(key);
    return std::pair(where.line, where.column);
  };
  EXPECT_EQ(place("blank.size"), std::pair(3, 8));
  EXPECT_EQ(place("blank.edge"), std::pair(2, 1)); // not given: its table
  EXPECT_EQ(place("tool[1].mesh"), std::pair(22, 8));
  EXPECT_EQ(place("tool[1].friction"), std::pair(20, 1));
  EXPECT_EQ(place("tool[0].motion.displacement"), std::pair(19, 39));
  EXPECT_EQ(place("contact.penalty"), std::pair(0, 0)); // not even its table: the file
  EXPECT_EQ(c.where("contact.penalty").file, at("case.toml").string());
}

TEST_F(ReadCase, MotionTableTakesItsQuantityFromItsUnits)
{
  const Case c = read(sample_with(
      19,
      R"(motion = { axis = "x", profile = "table", table = [[0, 0], ["10 ms", "-2 m/s"], ["1 s", -1]] })"));
  const Motion& motion = *c.tools[0].motion;
  EXPECT_EQ(motion.axis, Axis::x);
  EXPECT_EQ(motion.quantity, Motion::Quantity::velocity);
  ASSERT_EQ(motion.table.size(), 3U);
  EXPECT_EQ(motion.table[1].time, 0.01);
  EXPECT_EQ(motion.table[1].value, -2.0);
  EXPECT_EQ(motion.table[2].value, -1.0);
}

TEST_F(ReadCase, OverridesReplaceAndAdd)
{
  const Case c = read(sample_case, {"blank.thickness=2mm", "blank.fibre_angle=30 deg", "blank.symmetry=\"x\"",
                                    "tool.holder.mesh_unit=mm", "tool.punch.motion.displacement=-0.5",
                                    "contact.penalty=0.2", "material.matrix.exponent=0.5", "title=A = B",
                                    "blank.size=[\"1 m\", 2]"});
  EXPECT_EQ(c.blank.thickness, 0.002);
  EXPECT_DOUBLE_EQ(c.blank.fibre_angle, std::numbers::pi / 6);
  EXPECT_EQ(c.blank.symmetry, Symmetry::x);
  EXPECT_EQ(c.tools[1].mesh_unit, 0.001);
  EXPECT_EQ(c.tools[0].motion->amount, -0.5);
  EXPECT_EQ(c.contact.penalty, 0.2);
  EXPECT_EQ(c.material.constituents.matrix.exponent, 0.5);
  EXPECT_EQ(c.title, "A = B");
  EXPECT_EQ(c.blank.size, (Vec2{1.0, 2.0}));
  EXPECT_EQ(c.text, sample_case);
  EXPECT_EQ(c.where("contact.penalty").file, "--set contact.penalty=0.2");
}

TEST_F(ReadCase, AnOverrideTakesThePlaceOfTheKeyItExcludes)
{
  const Case c = read(sample_case, {"blank.edge=5 mm", "tool.punch.motion.velocity=-1 m/s"});
  EXPECT_FALSE(c.blank.elements);
  EXPECT_EQ(c.blank.edge, 0.005);
  EXPECT_EQ(c.tools[0].motion->quantity, Motion::Quantity::velocity);
}

TEST_F(ReadCase, ResolvedCaseReadsBackToItself)
{
  write("cards/own.toml", "tow_width = \"4 mm\"\ntow_gap = 0\nfibre_diameter = \"10 um\"\n"
                          "fibre_volume_fraction = 0.5\ndensity = 1500\nfibre_modulus = 1e9\n"
                          "[matrix]\nzero_shear_viscosity = 10\ntime_constant = 1e-3\nexponent = 0.3\n"
                          "reference_temperature = 500\nactivation_energy = 1\n");
  const std::vector<std::string> cases{
      sample_case,
      sample_with(10, "card = \"own\""),
      sample_with(1, "title = 'quotes \" and \\ back'"),
      sample_with(4, "edge = \"0.3 in\""),
      sample_with(19, R"(motion = { profile = "table", table = [[0, "0 mm"], ["10 ms", "-2 mm"]] })"),
      sample_with(19, R"(motion = { profile = "table", table = [[0, "0 mm/s"], ["10 ms", "-2 m/s"]] })"),
      sample_with(19, R"(motion = { axis = "y", velocity = "7 mm/s" })"),
      sample_with(25, "end = 0.1\nstep = \"3 us\""),
  };
  for (const std::string& text : cases) {
    const std::string resolved = resolved_case(read(text));
    // In another folder, as the results of a run are.
    const Case again = read_case(write("elsewhere/case.toml", resolved));
    EXPECT_EQ(resolved_case(again), resolved);
  }
  EXPECT_NE(resolved_case(read(sample_case)).find("size = [\"0.65 m\", \"0.45 m\"]"), std::string::npos);
}

} // namespace towform
