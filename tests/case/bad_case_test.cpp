#include "case_files.hpp"
#include <fmt/format.h>

namespace towform {

namespace {

struct Bad {
  int line;                ///< of the sample
  std::string replacement; ///< of that line
  std::string place;       ///< line:column of the only issue, or of the first
  std::string message;     ///< part of its message
};

// clang-format off
const std::vector<Bad> bad_lines{
    // Syntax
    {3, "size = [650 mm, 450 mm]", "3:13", "written in quotes: \"650 mm\""},
    {7, "thickness = \"1 mm", "7:18", "not TOML"},
    {7, "thickness = 1\nthickness = 2", "8:", "cannot redefine"},
    // Types
    {1, "title = 5", "1:9", "title must be text in quotes, not 5"},
    {1, "title = true", "1:9", "must be text in quotes, not true"},
    {3, "size = \"650 mm\"", "3:8", "blank.size must be two lengths, such as"},
    {3, "size = [1, 2, 3]", "3:8", "not a list of 3"},
    {3, "size = [1, true]", "3:12", "must be a length, such as"},
    {4, "elements = 21706.0", "4:12", "a whole number: write 21706, not 21706.0"},
    {4, "elements = 21706.5", "4:12", "must be a whole number, not 21706.5"},
    {4, "elements = \"21706\"", "4:12", "write 21706, not \"21706\""},
    {4, "elements = nan", "4:12", "must be a whole number"},
    {7, "thickness = [1]", "7:13", "must be a length"},
    {7, "thickness = 2024-01-01", "7:13", "not a date"},
    {8, "symmetry = 1", "8:12", "must be \"none\", \"x\", \"y\" or \"quarter\", not 1"},
    // Units
    {5, "fibre_angle = \"30 mm\"", "5:15", "\"30 mm\" is a length, not an angle; use rad or deg"},
    {7, "thickness = \"1\"", "7:13", "has no unit; it is a length: m, cm, mm"},
    {7, "thickness = \"1 MM\"", "7:13", "unknown unit `MM`; use m, cm, mm, um, \u00b5m or in; did you mean `mm`?"},
    {7, "thickness = \"thin\"", "7:13", "is not a length"},
    {7, "thickness = \"1e400 mm\"", "7:13", "beyond"},
    {7, "thickness = \"nan mm\"", "7:13", "is not a length"},
    {13, "temperature = \"190 C\"", "13:15", "unknown unit `C`; use K or degC"},
    {18, "friction = \"0.3 N\"", "18:12", "is a force; a plain number or % fits here"},
    {23, "force = \"3 kn\"", "23:9", "did you mean `kN`?"},
    {25, "end = \"60 min s\"", "25:7", "unknown unit"},
    // Not finite
    {5, "fibre_angle = inf", "5:15", "not a finite number"},
    {18, "friction = nan", "18:12", "not a finite number"},
    // Ranges
    {3, "size = [\"650 mm\", \"-450 mm\"]", "3:19", "\"-450 mm\" must be > 0"},
    {4, "elements = 1", "4:12", "must be within 2 .. 20000000"},
    {4, "elements = 99999999999", "4:12", "must be within 2 .. 20000000"},
    {7, "thickness = 1", "7:13", "1 must be within 1 um .. 0.1 m"},
    {7, "thickness = \"0.9 um\"", "7:13", "must be within 1 um .. 0.1 m"},
    {13, "temperature = 190", "13:15", "for Celsius write \"190 degC\""},
    {18, "friction = 11", "18:12", "must be within 0 .. 10"},
    {25, "end = 0", "25:7", "0 must be > 0"},
    {25, "end = 1\nsafety = \"101 %\"", "26:10", "must be > 0, <= 1"},
    {27, "frames = 0", "27:10", "must be within 1 .. 100000"},
    {14, "fibre_volume_fraction = 0", "14:25", "must be > 0, <= 0.9"},
    {14, "relaxation_ratio = 1e-5", "14:20", "must be within 1e-4 .. 1"},
    // Words
    {11, "law = \"viscos\"", "11:7", "did you mean `viscous`?"},
    {11, "law = \"plastic\"", "11:7", "must be \"viscous\", \"incremental\", \"elastic\" or \"own\""},
    {8, "pattern = \"daigonal\"", "8:11", "did you mean `diagonal`?"},
    {14, "matrix = { model = \"carreau\" }", "14:20", "must be \"cross\""},
    // Unknown keys
    {8, "symetry = \"x\"", "8:1", "unknown key `symetry` in [blank]; did you mean `symmetry`?"},
    {8, "friction = 0.3", "8:1", "unknown key `friction` in [blank]; did you mean `tool.friction`?"},
    {8, "width = 3", "8:1", "its keys are mesh, mesh_unit, size, elements"},
    {8, "axis = \"z\"", "8:1", "did you mean `tool.axis`, `tool.motion.axis` or `boundary.motion.axis`?"},
    {1, "thickness = 1", "1:1", "did you mean `blank.thickness`?"},
    {14, "matrix = { exponant = 0.3 }", "14:12", "unknown key `exponant` in [material.matrix]; did you mean `exponent`?"},
    {19, "displacement = 1", "19:1", "did you mean `tool.motion.displacement` or `boundary.motion.displacement`?"},
    {26, "[ouput]", "26:2", "unknown table [ouput]; did you mean `output`?"},
    {26, "[[gates]]", "26:1", "gates must be a table [gates]"},
    {26, "[[tools]]", "26:3", "unknown table [[tools]]; did you mean `tool`?"},
    {1, "gates = 3", "1:9", "gates must be a table [gates], not 3"},
    {19, "motion = \"down\"", "19:10", "tool.motion must be a table"},
    // Missing
    {3, "", "2:1", "blank.size is missing (two lengths"},
    {7, "", "2:1", "blank.thickness is missing"},
    {4, "", "2:1", "blank needs elements or edge"},
    {13, "", "9:1", "material.temperature is missing"},
    {16, "", "15:1", "tool.name is missing"},
    {17, "", "15:1", "tool.punch.mesh is missing"},
    {25, "", "24:1", "time.end is missing"},
    // Contradictions
    {4, "elements = 4\nedge = \"1 cm\"", "5:8", "both elements and edge"},
    {14, "curve_rate_min = \"30 rad/s\"", "14:18", "curve_rate_max (20 rad/s) must be greater than curve_rate_min (30 rad/s)"},
    {14, "curve_rate_max = \"1 rad/s\"", "14:18", "must be greater than"},
    {14, "fibre_volume_fraction = 0.85", "14:25", "hexagonal packing ends at 0.907"},
    {16, "name = \"holder\"", "21:8", "a second tool or boundary named \"holder\""},
    {16, "name = \"a b\"", "16:8", "letters, digits, _ and - only"},
    {16, "name = \"\"", "16:8", "tool.name must not be empty"},
    {18, "force = 3", "18:9", "tool.punch has both motion and force"},
    {18, "mass = 3", "18:1", "tool.punch.mass has no effect without force"},
    {18, "axis = \"x\"", "18:1", "tool.punch.axis has no effect without force"},
    {19, "motion = {}", "19:10", "needs displacement or velocity"},
    {19, "motion = { displacement = 1, velocity = 1 }", "19:41", "both displacement and velocity"},
    {19, "motion = { velocity = 1, profile = \"smooth\" }", "19:36", "profile \"smooth\" needs a displacement"},
    {19, "motion = { profile = \"table\" }", "19:10", "profile \"table\" but no table"},
    {19, "motion = { displacement = 1, table = [[0, 0], [1, \"1 m\"]] }", "19:38", "it needs profile = \"table\""},
    {19, "motion = { profile = \"table\", table = [[0, 0], [1, 1]] }", "19:39", "needs a unit of length or velocity"},
    {19, "motion = { profile = \"table\", table = [[0, \"1 m\"], [1, \"1 m/s\"]] }", "19:56", "mixes displacements and velocities"},
    {19, "motion = { profile = \"table\", table = [[0, \"1 m\"]] }", "19:39", "two or more points"},
    {19, "motion = { profile = \"table\", table = [[0, \"1 m\"], [0, \"2 m\"]] }", "19:53", "later than the point before"},
    {19, "motion = { profile = \"table\", table = [[-1, \"1 m\"], [0, \"2 m\"]] }", "19:41", "must be >= 0"},
    {19, "motion = { profile = \"table\", table = [[0, \"1 m\"], 3] }", "19:52", "must be a point [time, value]"},
    {19, "motion = { profile = \"table\", displacement = 1, table = [[0, \"1 m\"], [1, \"2 m\"]] }", "19:46", "no place for displacement"},
    // Files
    {10, "card = \"gf_pp_twil\"", "10:8", "\"gf_pp_twil\" is not a card; "},
    {10, "card = \"../gf_pp_twill\"", "10:8", "is not a card"},
    {10, "card = \"mine.toml\"", "10:8", "is not there; looked in"},
    {10, "card = 3", "10:8", "must be text"},
    {17, "mesh = \"meshes/pnch.stl\"", "17:8", "\"meshes/pnch.stl\" is not there; looked in"},
    {17, "mesh = \"meshes\"", "17:8", "is not there"},
    {17, "mesh = \"\"", "17:8", "must not be empty"},
};
// clang-format on

} // namespace

using BadCase = CaseFiles;

TEST_F(BadCase, EachIsNamedWithItsPlace)
{
  for (const Bad& bad : bad_lines) {
    const std::vector<InputIssue> issues = issues_of(sample_with(bad.line, bad.replacement));
    ASSERT_FALSE(issues.empty()) << bad.replacement;
    const std::string text = issues.front().text();
    EXPECT_EQ(issues.size(), 1U) << bad.replacement << '\n' << text << '\n' << issues.back().text();
    EXPECT_TRUE(text.starts_with("case.toml:" + bad.place)) << bad.replacement << '\n' << text;
    EXPECT_NE(text.find(bad.message), std::string::npos) << bad.replacement << '\n' << text;
  }
}

TEST_F(BadCase, AllAtOnceFromTopToBottom)
{
  const std::vector<InputIssue> issues =
      issues_of("[time]\nend = 0\n[blank]\nthicknes = 1\nsize = [1, \"2 s\"]\nelements = 3\n"
                "[[tool]]\nmesh = \"none.stl\"\n[material]\ncard = \"gf_pp_twill\"\n",
                {"contact.penalty=9"});
  std::vector<std::string> places;
  for (const InputIssue& issue : issues)
    places.push_back(fmt::format("{}:{}:{}", issue.where.file, issue.where.line, issue.where.column));
  const std::vector<std::string> expected{
      "case.toml:2:7", "case.toml:3:1", "case.toml:4:1", "case.toml:5:12",
      "case.toml:7:1", "case.toml:8:8", "case.toml:9:1", "--set contact.penalty=9:0:0"};
  EXPECT_EQ(places, expected);
}

TEST_F(BadCase, WithoutACardEveryConstituentIsAskedFor)
{
  const std::vector<InputIssue> issues = issues_of(sample_with(10, ""));
  std::string all;
  for (const InputIssue& issue : issues) {
    EXPECT_EQ(issue.where.line, 9);
    all += issue.message + '\n';
  }
  for (const char* key : {"fibre_volume_fraction", "tow_width", "tow_gap", "fibre_diameter", "density",
                          "matrix.zero_shear_viscosity", "matrix.time_constant", "matrix.exponent",
                          "matrix.reference_temperature", "matrix.activation_energy"})
    EXPECT_NE(all.find(fmt::format("material.{} is missing, here or in a card", key)), std::string::npos)
        << key;
  EXPECT_EQ(issues.size(), 10U);
}

TEST_F(BadCase, CardsAreCheckedByTheSameTable)
{
  write("cards/own.toml", "tow_width = \"4 s\"\nfriction = 1\ncard = \"x\"\n");
  const std::vector<InputIssue> issues = issues_of(sample_with(10, "card = \"own\""));
  std::vector<std::string> in_card;
  for (const InputIssue& issue : issues) {
    if (issue.where.file == "cards/own.toml") in_card.push_back(issue.text());
  }
  ASSERT_EQ(in_card.size(), 3U);
  EXPECT_TRUE(in_card[0].starts_with("cards/own.toml:1:13: material.tow_width: \"4 s\" is a time"))
      << in_card[0];
  EXPECT_TRUE(in_card[1].starts_with("cards/own.toml:2:1: unknown key `friction`")) << in_card[1];
  EXPECT_TRUE(in_card[2].starts_with("cards/own.toml:3:1: a card cannot name another card")) << in_card[2];
}

TEST_F(BadCase, UnknownCardNamesThoseThereAre)
{
  write("cards/own.toml", "");
  const std::vector<InputIssue> issues = issues_of(sample_with(10, "card = \"onw\""));
  ASSERT_EQ(issues.size(), 1U); // and not one more for every key the card would have given
  EXPECT_NE(issues[0].message.find("gf_pp_twill"), std::string::npos) << issues[0].message;
  EXPECT_NE(issues[0].message.find("own; did you mean `own`?"), std::string::npos) << issues[0].message;
}

TEST_F(BadCase, Overrides)
{
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"nonsense", "must be key.path=value"},
      {"=3", "must be key.path=value"},
      {"blank..size=3", "must be key.path=value"},
      {"blank.thicknes=1", "did you mean `thickness`?"},
      {"blank.thickness=2s", "\"2s\" is a time, not a length"},
      {"blank.thickness=1\nsafety = 2", "unknown unit"},
      {"tim.end=3", "unknown table [tim]"},
      {"time.end.x=3", "`end` is not a table"},
      {"tool.friction=3", "tool.NAME.key=value"},
      {"tool.punhc.friction=1", "there is no tool `punhc`; did you mean `punch`?"},
      {"tool.die.friction=1", "the case has punch and holder"},
      {"tool.punch.frction=1", "did you mean `friction`?"},
      {"tool.holder.mesh=none.stl", "is not there"},
      {"output.frames=3.0", "write 3, not 3.0"},
  };
  for (const auto& [text, message] : wrong) {
    const std::vector<InputIssue> issues = issues_of(sample_case, {text});
    ASSERT_EQ(issues.size(), 1U) << text;
    EXPECT_TRUE(issues[0].text().starts_with("--set " + text + ": ")) << issues[0].text();
    EXPECT_NE(issues[0].message.find(message), std::string::npos) << issues[0].text();
  }
}

TEST_F(BadCase, FilesThatAreNoCase)
{
  const auto only_issue = [](const std::filesystem::path& path) {
    try {
      read_case(path);
    } catch (const InputError& error) {
      EXPECT_EQ(error.issues().size(), 1U);
      return error.issues().front();
    }
    return InputIssue{};
  };
  const InputIssue missing = only_issue(at("nowhere.toml"));
  EXPECT_EQ(missing.code, ExitCode::files);
  EXPECT_NE(missing.text().find("nowhere.toml: cannot read the case file: No such file"), std::string::npos);
  EXPECT_NE(only_issue(at("meshes")).text().find("is a directory"), std::string::npos);
  const InputIssue bytes = only_issue(write("latin1.toml", "# ok\ntitle = \"\xe9\"\n"));
  EXPECT_NE(bytes.text().find("latin1.toml:2:10: is not UTF-8"), std::string::npos) << bytes.text();
  const InputIssue large = only_issue(write("large.toml", std::string(10'000'001, '#')));
  EXPECT_NE(large.text().find("larger than 10 MB"), std::string::npos) << large.text();
  const InputIssue deep = only_issue(write("deep.toml", [] {
    std::string key;
    for (int i = 0; i < 100'000; ++i) key += "a.";
    return "\n" + key + "a = 1";
  }()));
  EXPECT_NE(deep.text().find("deep.toml:2:1: not TOML"), std::string::npos) << deep.text();
}

TEST_F(BadCase, EmptyFileSaysWhatIsMissing)
{
  const std::vector<InputIssue> issues = issues_of("");
  ASSERT_EQ(issues.size(), 3U);
  EXPECT_EQ(issues[0].text(), "case.toml: table [blank] is missing; it needs size, thickness, and elements "
                              "or edge; or mesh and thickness");
  EXPECT_EQ(issues[1].text().find("case.toml: table [material] is missing"), 0U);
  EXPECT_EQ(issues[2].text(), "case.toml: table [time] is missing; it needs end");
}

TEST_F(BadCase, MissingMeshIsAMatterOfFiles)
{
  const auto code = [&](const std::string& text) {
    try {
      read(text);
    } catch (const InputError& error) {
      return error.code();
    }
    return ExitCode::done;
  };
  EXPECT_EQ(code(sample_with(17, "mesh = \"none.stl\"")), ExitCode::files);
  EXPECT_EQ(code(sample_with(17, "mesh = \"none.stl\"\nfriktion = 1")), ExitCode::case_file);
}

} // namespace towform
