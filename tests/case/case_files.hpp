#pragma once
#include "towform/case.hpp"
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace towform {

/// A folder of its own for a test's case, meshes and cards; removed afterwards.
class CaseFiles : public testing::Test {
protected:
  void SetUp() override
  {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              (std::string("towform_") + test->name() + "_" + std::to_string(getpid()));
    write("meshes/punch.stl", "");
    write("meshes/holder.stl", "");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::filesystem::path at(const std::string& name) const { return folder_ / name; }

  std::filesystem::path write(const std::string& name, const std::string& text) const
  {
    std::filesystem::create_directories(at(name).parent_path());
    std::ofstream(at(name), std::ios::binary) << text;
    return at(name);
  }

  Case read(const std::string& text, const std::vector<std::string>& overrides = {}) const
  {
    return read_case(write("case.toml", text), overrides);
  }

  /// What is wrong with a case, one line each, its folder left out; empty when nothing is.
  [[nodiscard]] std::vector<InputIssue> issues_of(const std::string& text,
                                                  const std::vector<std::string>& overrides = {}) const
  {
    try {
      read(text, overrides);
    } catch (const InputError& error) {
      std::vector<InputIssue> issues = error.issues();
      for (InputIssue& issue : issues) {
        if (issue.where.file.starts_with(folder_.string()))
          issue.where.file.erase(0, folder_.string().size() + 1);
      }
      return issues;
    }
    return {};
  }

private:
  std::filesystem::path folder_;
};

/// The case that the user's guide shows; line numbers matter to the tests.
inline const std::string sample_case = R"(title = "Double dome, 0/90"
[blank]
size = ["650 mm", "450 mm"]
elements = 21706
fibre_angle = "45 deg"
mesh_angle = "0 deg"
thickness = "1 mm"
symmetry = "none"
[material]
card = "gf_pp_twill"
law = "viscous"
curve_selection = "next_higher"
temperature = "190 degC"
fibre_modulus = "2 GPa"
[[tool]]
name = "punch"
mesh = "meshes/punch.stl"
friction = 0.25
motion = { axis = "z", displacement = "-60 mm", profile = "constant" }
[[tool]]
name = "holder"
mesh = "meshes/holder.stl"
force = "-35 N"
[time]
end = "60 ms"
[output]
frames = 40
)";

/// The sample with one line replaced (lines count from 1).
inline std::string sample_with(int line, const std::string& replacement)
{
  std::string result;
  std::size_t start = 0;
  for (int i = 1; start < sample_case.size(); ++i) {
    const std::size_t end = sample_case.find('\n', start);
    result += (i == line ? replacement : sample_case.substr(start, end - start)) + "\n";
    start = end + 1;
  }
  return result;
}

} // namespace towform
