#include "case/case_files.hpp"
#include "material/gf_pp.hpp"
#include "material/prediction.hpp"
#include "material/shear_resistance.hpp"
#include <fmt/format.h>
#include <sstream>
#include <sys/wait.h>

namespace towform {
namespace {

class MaterialCommand : public CaseFiles {
protected:
  void SetUp() override
  {
    CaseFiles::SetUp();
    write("case.toml",
          "[blank]\nthickness = \"1 mm\"\n[material]\ncard = \"gf_pp_twill\"\ntemperature = \"190 degC\"\n");
  }

  /// Exit code of `towform material ARGUMENTS`, run in the test's folder; its words are kept.
  int material(const std::string& arguments)
  {
    const std::string command =
        fmt::format("cd {} && {} material {} > out.txt 2>&1", at("").string(), TOWFORM_PROGRAM, arguments);
    const int status = std::system(command.c_str()); // NOLINT(concurrency-mt-unsafe)
    said = text("out.txt");
    return WEXITSTATUS(status);
  }

  [[nodiscard]] std::string text(const std::string& name) const
  {
    std::ostringstream all;
    all << std::ifstream(at(name)).rdbuf();
    return all.str();
  }

  std::string said;
};

TEST_F(MaterialCommand, PredictsATableAndCurves)
{
  ASSERT_EQ(material("predict case.toml -o curves.txt --table t.csv --rates 0.2,1,10 --angles 1,10,30 "
                     "--temperatures 180,'200 degC'"),
            0)
      << said;
  EXPECT_NE(said.find("typical values"), std::string::npos);
  std::istringstream table(text("t.csv"));
  std::string line;
  std::getline(table, line);
  EXPECT_EQ(line, "temperature_degC,rate_rad_per_s,theta_deg,shear_force_N_per_m,tow,inter_tow,crossover");
  std::vector<std::string> lines;
  while (std::getline(table, line)) lines.push_back(line);
  ASSERT_EQ(lines.size(), 18U);
  EXPECT_TRUE(lines[17].starts_with("200,10,30,")) << lines[17];
  const auto parts = ShearResistance(test::gf_pp_twill(), 1e-3, 473.15).parts(M_PI / 6.0, 10.0);
  EXPECT_EQ(lines[17], fmt::format("200,10,30,{:.10g},{:.10g},{:.10g},{:.10g}", parts.total(), parts.tow,
                                   parts.inter_tow, parts.crossover));
  EXPECT_EQ(read_curves(at("curves.txt")).curves.curves.size(), 20U);
}

TEST_F(MaterialCommand, TemperatureTakesAUnitOrDegreesCelsius)
{
  for (const char* t : {"200", "'200 degC'", "'473.15 K'"}) {
    ASSERT_EQ(material(fmt::format("predict case.toml --temperature {} -o c.txt", t)), 0) << said;
    EXPECT_NEAR(*read_curves(at("c.txt")).temperature, 473.15, 1e-9);
  }
}

TEST_F(MaterialCommand, ExitCodesSayWhatIsWrong)
{
  EXPECT_EQ(material("predict case.toml --angles 1,90"), 3) << said;
  EXPECT_EQ(material("predict case.toml --rates 0"), 3) << said;
  EXPECT_EQ(material("predict case.toml --rates=-1"), 3) << said;
  EXPECT_EQ(material("predict case.toml --temperatures 5000"), 3) << said;
  EXPECT_EQ(material("predict case.toml --temperature 5000"), 3) << said;
  EXPECT_EQ(material("predict case.toml --temperature warm"), 2) << said;
  EXPECT_EQ(material("predict case.toml --set material.fibre_volume_fraction=0.85"), 3) << said;
  EXPECT_EQ(material("predict case.toml --set material.tow_gap=-1mm"), 3) << said;
  EXPECT_EQ(material("predict case.toml --set material.fibre_volume_fraction=0.1"), 3) << said;
  EXPECT_EQ(material("predict none.toml"), 4) << said;
  EXPECT_EQ(material("predict case.toml -o no/where.txt"), 4) << said;
  EXPECT_EQ(material("predict"), 2) << said;
  write("t.csv", "angle_deg,force_N\n1,2\n2,3\n");
  EXPECT_EQ(material("fit t.csv -o c.txt --test picture-frame --side 115 --rate 1"), 4) << said;
  EXPECT_EQ(material("fit t.csv -o c.txt --test picture-frame --rate 1"), 2) << said;
  EXPECT_EQ(material("fit t.csv -o c.txt --test bias-extension --length 100 --width 100 --rate 1"), 3)
      << said;
  EXPECT_EQ(material("fit none.csv -o c.txt --test picture-frame --side 115 --rate 1"), 4) << said;
}

TEST_F(MaterialCommand, FitsATest)
{
  std::string rows = "angle_deg,shear_force_N_per_m,rate_rad_per_s\n";
  for (int i = 0; i <= 60; ++i)
    for (const double rate : {0.1, 1.0})
      rows += fmt::format("{},{},{}\n", i, (20.0 + i) * std::sqrt(rate), rate);
  write("t.csv", rows);
  ASSERT_EQ(
      material("fit t.csv -o c.txt --test picture-frame --side 115 --thickness '1 mm' --temperature 190"), 0)
      << said;
  const CurveFile file = read_curves(at("c.txt"));
  ASSERT_EQ(file.curves.curves.size(), 2U);
  EXPECT_EQ(file.curves.curves[0].rate(), 0.1);
  EXPECT_NEAR(file.curves.curves[1].force(30.0 * M_PI / 180.0), 50.0, 0.05);
}

TEST_F(MaterialCommand, MaterialKeysFollowTheirModel)
{
  const std::string head = "[blank]\nthickness = \"1 mm\"\n[material]\ntemperature = \"190 degC\"\n";
  const auto message = [&](const std::string& text) {
    try {
      read_material(write("m.toml", head + text));
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  const std::string twill = "card = \"gf_pp_twill\"\n";
  EXPECT_EQ(message(twill), "");
  EXPECT_NE(message(twill + "matrix = { model = \"table\" }\n").find("matrix.table is missing"),
            std::string::npos);
  EXPECT_EQ(message(twill + "matrix = { model = \"table\", table = [[0.1, \"300 Pa s\"], [10, 100]] }\n"),
            "");
  EXPECT_NE(
      message(twill + "matrix = { model = \"table\", table = [[1, 300], [1, 100]] }\n").find("higher rate"),
      std::string::npos);
  EXPECT_NE(message(twill + "matrix = { model = \"table\", table = [[1, 300], [10, 10]] }\n").find("stress"),
            std::string::npos);
  EXPECT_NE(message(twill + "matrix = { shift = \"wlf\" }\n").find("matrix.wlf_c2 is missing"),
            std::string::npos);
  EXPECT_EQ(message(twill + "matrix = { shift = \"wlf\", wlf_c1 = 3, wlf_c2 = 180 }\n"), "");
  EXPECT_NE(message("card = \"gf_pp_plain_weave\"\nlaw = \"viscous\"\n").find("needs law = \"elastic\""),
            std::string::npos);
  EXPECT_NE(message(twill + "curves = \"none.txt\"\n").find("\"none.txt\" is not there"), std::string::npos);
  write("c.txt", "");
  EXPECT_EQ(message("curves = \"c.txt\"\ndensity = 1480\nfibre_modulus = 1e9\n"), "");
}

TEST_F(MaterialCommand, ResolvedCasesReadBack)
{
  write("c.txt", "");
  for (const std::string& more :
       {std::string("material.matrix.model=carreau_yasuda"), std::string("material.curves=c.txt"),
        std::string("material.matrix={model=\"table\",table=[[0.1,300],[10,100]]}"),
        std::string("material.matrix={shift=\"wlf\",wlf_c1=3,wlf_c2=180}"),
        std::string("material.card=gf_pp_plain_weave")}) {
    std::vector<std::string> set{more};
    if (more.ends_with("weave")) set.emplace_back("material.law=elastic");
    const Case c = read(sample_case, set);
    write("resolved.toml", resolved_case(c));
    EXPECT_EQ(resolved_case(read_case(at("resolved.toml"))), resolved_case(c)) << more;
  }
}

} // namespace
} // namespace towform
