#include "dome.hpp"
#include "output/hdf5.hpp"
#include "temporary_directory.hpp"
#include "towform/error.hpp"
#include <limits>

namespace towform {

namespace {

class DescribeResults : public TemporaryDirectory {
protected:
  void expect_line(const std::string& text, const std::string& line) const
  {
    EXPECT_NE(text.find(line + "\n"), std::string::npos) << line << "\nis not in\n" << text;
  }
  std::filesystem::path path = directory / "results.h5";
  SurfaceMesh mesh = dome::sheet(4);
};

} // namespace

TEST_F(DescribeResults, TellsWhatIsInTheFile)
{
  ResultsWriter writer(directory, mesh, dome::provenance());
  Frame frame = dome::frame(mesh, 1.0);
  frame.shear_angle.assign(32, 1.5);
  frame.shear_angle[3] = -2.25;
  frame.fibre_strain[5][1] = 0.5;
  frame.fibre_strain[6][1] = -0.75;
  frame.temperature[7] = std::numeric_limits<double>::quiet_NaN();
  writer.append(dome::frame(mesh, 0.0));
  writer.append(frame);
  writer.finish("stopped by a gate");
  const std::string text = describe_results(path);
  expect_line(text, path.string() + ": " + dome::provenance().title);
  expect_line(text, "  written by towform 0.1.0 (0123456789ab), GNU Release");
  expect_line(text, "  status     stopped by a gate");
  expect_line(text, "  sheet      25 nodes, 32 elements");
  expect_line(text, "    " + std::string(64, 'b') + "  meshes/a punch.stl");
  expect_line(text, "  frames     2, from 0 s to 0.06 s");
  expect_line(text, "    shear_angle        [deg]          -2.25           1.5");
  expect_line(text, "    position z         [m]                0          0.08");
  expect_line(text, "    fibre_strain 2     [1]            -0.75           0.5");
  expect_line(text, "    temperature        [K]           463.15        463.15  1 values are not finite");
}

TEST_F(DescribeResults, TakesAFileWithNoFrameYet)
{
  const ResultsWriter writer(directory, mesh, dome::provenance());
  expect_line(describe_results(path), "  frames     none");
}

TEST_F(DescribeResults, RejectsWhatIsNoResultsFile)
{
  const auto message = [](const std::filesystem::path& file) {
    return message_of<FileError>([&] { describe_results(file); });
  };
  EXPECT_EQ(message(path), path.string() + ": no such file");
  EXPECT_EQ(message(directory), directory.string() + ": is a directory; its results.h5 is wanted");
  std::ofstream(path) << "text";
  EXPECT_EQ(message(path), path.string() + ": cannot be opened: file signature not found");
  hdf5::File::create(path).close();
  EXPECT_EQ(message(path), path.string() + ": not a towform results file: there is no /mesh");
}

} // namespace towform
