#include "output/results_reader.hpp"
#include "results_fixture.hpp"
#include "towform/error.hpp"

namespace towform {
namespace {

class ResultsReader : public Results {
protected:
  /// Three frames of the dome.
  void write() const
  {
    ResultsWriter writer(directory, mesh, dome::provenance());
    for (const double stroke : {0.0, 0.5, 1.0}) writer.append(dome::frame(mesh, stroke));
    writer.finish("done");
  }
  std::string refused(std::optional<int> frame = {}) const
  {
    const std::string said = message_of<FileError>([&] { read_sheet(directory / "results.h5", frame); });
    EXPECT_TRUE(said.starts_with((directory / "results.h5").string())) << said;
    return said;
  }
  /// Puts an array of these numbers in place of a dataset.
  void replace(const std::string& path, const hdf5::Shape& shape, const std::vector<double>& values,
               const std::string& units) const
  {
    write();
    hdf5::File file = open(hdf5::File::Mode::append);
    H5Ldelete(file.id(), path.c_str(), H5P_DEFAULT);
    {
      const hdf5::Dataset dataset =
          hdf5::write_dataset(file.id(), path, shape, H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE, values.data());
      hdf5::write_attribute(dataset.id(), "units", units);
    }
    file.close();
  }
};

TEST_F(ResultsReader, GivesBackWhatWasWritten)
{
  write();
  const SheetResult last = read_sheet(directory / "results.h5", {});
  const Frame frame = dome::frame(mesh, 1.0);
  EXPECT_EQ(last.frame, 2);
  EXPECT_EQ(last.frames, 3);
  EXPECT_EQ(last.time, frame.time);
  EXPECT_EQ(last.flat.points, mesh.points);
  EXPECT_EQ(last.flat.triangles, mesh.triangles);
  EXPECT_EQ(last.position, frame.position);
  ASSERT_EQ(last.shear.size(), frame.shear_angle.size());
  for (std::size_t e = 0; e < last.shear.size(); ++e)
    EXPECT_NEAR(last.shear[e], frame.shear_angle[e], 1e-5); // fields may be kept in single precision
  EXPECT_EQ(read_sheet(directory / "results.h5", 1).time, 0.5 * frame.time);
}

TEST_F(ResultsReader, SaysWhatAFileLacks)
{
  EXPECT_NE(refused().find("no such file"), std::string::npos);
  std::ofstream(directory / "results.h5") << "not results";
  EXPECT_NE(refused().find("cannot be opened"), std::string::npos);
  hdf5::File::create(directory / "results.h5").close();
  EXPECT_NE(refused().find("not a towform results file: there is no /mesh"), std::string::npos);
  {
    ResultsWriter empty(directory, mesh, dome::provenance());
  }
  EXPECT_NE(refused().find("holds no frame yet"), std::string::npos);
  write();
  EXPECT_NE(refused(3).find("there is no frame 3; there are frames 0 to 2"), std::string::npos);
  EXPECT_NE(refused(-1).find("there is no frame -1"), std::string::npos);
}

TEST_F(ResultsReader, ChecksSizesUnitsAndNumbers)
{
  const std::size_t nodes = mesh.points.size(), elements = mesh.triangles.size();
  replace("frames/0002/position", {nodes - 1, 3}, std::vector<double>(3 * (nodes - 1)), "m");
  EXPECT_NE(refused().find("position has 24 nodes, the mesh 25"), std::string::npos);
  replace("frames/0002/position", {3 * nodes}, std::vector<double>(3 * nodes), "m");
  EXPECT_NE(refused().find("is not an array of 3 column(s)"), std::string::npos);
  replace("frames/0002/position", {nodes, 3}, std::vector<double>(3 * nodes, NAN), "m");
  EXPECT_NE(refused().find("position has values that are not finite"), std::string::npos);
  replace("frames/0002/shear_angle", {elements}, std::vector<double>(elements), "rad");
  EXPECT_NE(refused().find("shear_angle is in rad, not deg"), std::string::npos);
  replace("frames/0002/shear_angle", {elements + 1}, std::vector<double>(elements + 1), "deg");
  EXPECT_NE(refused().find("shear_angle has 33 elements, the mesh 32"), std::string::npos);
  replace("mesh/triangles", {elements, 3}, std::vector<double>(3 * elements, 25.0), "1");
  EXPECT_NE(refused().find("element 0 names a node that is not there"), std::string::npos);
}

} // namespace
} // namespace towform
