#include "init_command.hpp"
#include "output/text_file.hpp"
#include "towform/case_schema.hpp"
#include "towform/error.hpp"
#include <filesystem>
#include <fmt/format.h>

namespace towform {

namespace {

namespace fs = std::filesystem;

constexpr const char* starting_case = R"(#:schema case.schema.json
# A case to start from: a quarter of a hemisphere, some seconds of wall time.
#
#     towform check case.toml --preview preview      what would be run, and a page to look at it
#     towform run case.toml -o results               ends with results/report.html
#
# Numbers are SI; text takes a unit, as "300 mm". Every key with its unit, default and range: docs/case_keys.md, or
# `man towform`. Any of them can be set for one run: --set blank.elements=12800
title = "My first forming case"

[blank]
size = ["300 mm", "300 mm"]     # along x and y, centred on the origin, flat in z = 0
elements = 3200                 # of the whole blank; finer shows more, and costs the third power of it
fibre_angle = "0 deg"           # warp against x; try "45 deg" with symmetry = "none"
thickness = "1 mm"
symmetry = "quarter"            # "none" for the whole blank, "x" or "y" for half of it

[material]
card = "gf_pp_twill"            # typical glass/polypropylene twill, not measured: put your own values here
temperature = "190 degC"        # of the sheet; it stays what it is
# fibre_modulus = "1 GPa"       # stiffer yarns stretch less and take smaller steps

[[tool]]
name = "punch"
mesh = "meshes/hemisphere_punch.stl"     # comes with towform; your own STL lies beside this file
# mesh_unit = "mm"                       # an STL file carries no unit; without this its lengths are metres
friction = 0.3                           # Coulomb, against the sheet
motion = { axis = "z", displacement = "-75 mm", profile = "smooth" }   # reached at time.end

[[tool]]
name = "die"                             # neither motion nor force: it stands
mesh = "meshes/hemisphere_die.stl"
friction = 0.3

[[tool]]
name = "holder"
mesh = "meshes/hemisphere_holder.stl"
friction = 0.3
force = "-35 N"                          # along axis, z by default: it follows the sheet

[time]
end = "75 ms"                   # 75 mm in 75 ms: faster than most presses; slower takes longer to compute

[output]
frames = 30                     # of the sheet, in results.h5 and in the report
# report = false                # no report.html at the end

[report]
locking_angle = "60 deg"        # what the report judges shear by; typical of twills, measure your own
)";

/// Both files or neither: what is there is not overwritten.
void init(const fs::path& directory)
{
  const fs::path case_file = directory / "case.toml", schema = directory / "case.schema.json";
  for (const fs::path& path : {case_file, schema}) {
    std::error_code ignored;
    if (fs::exists(path, ignored))
      throw FileError(
          fmt::format("{}: is there already; name another directory: towform init DIR", path.string()));
  }
  make_directory(directory);
  replace_file(schema, case_schema());
  replace_file(case_file, starting_case);
  fmt::print(
      "wrote {} and {}\nlook at it:  towform check {} --preview {}\nform it:     towform run {} -o {}\n",
      case_file.string(), schema.filename().string(), case_file.string(), (directory / "preview").string(),
      case_file.string(), (directory / "results").string());
}

} // namespace

void add_init_command(CLI::App& app)
{
  CLI::App* command =
      app.add_subcommand("init", "write a commented case to start from, and its schema for editors");
  auto directory = std::make_shared<std::string>(".");
  command->add_option("directory", *directory, "where to; made when missing [.]")->type_name("DIR");
  command->callback([directory] { init(*directory); });
}

} // namespace towform
