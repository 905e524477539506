#include "results_fixture.hpp"
#include <map>
#include <set>

namespace towform {

TEST_F(Results, HoldTheMeshAndWhereTheyCameFrom)
{
  ResultsWriter(directory, mesh, dome::provenance()).finish("done");
  const hdf5::File file = open();
  const hdf5::Dataset triangles = hdf5::open_dataset(file.id(), "mesh/triangles");
  EXPECT_EQ(hdf5::shape_of(triangles), (hdf5::Shape{32, 3}));
  const hdf5::Type type(H5Dget_type(triangles.id()));
  EXPECT_GT(H5Tequal(type.id(), H5T_STD_I32LE), 0);
  EXPECT_EQ(hdf5::read_numbers(triangles)[3 * 31 + 1], mesh.triangles[31][1]);
  const std::vector<double> reference = hdf5::read_numbers(hdf5::open_dataset(file.id(), "mesh/reference"));
  ASSERT_EQ(reference.size(), 75U);
  EXPECT_EQ(reference[3 * 7 + 1], mesh.points[7].y);

  const auto text = [&](const char* name) { return hdf5::text_attribute(file.id(), name); };
  const Provenance p = dome::provenance();
  EXPECT_EQ(text("version"), p.version);
  EXPECT_EQ(text("git_hash"), p.git_hash);
  EXPECT_EQ(text("flags"), p.flags);
  EXPECT_EQ(text("title"), p.title);
  EXPECT_EQ(text("case"), p.case_text);
  EXPECT_EQ(text("resolved_case"), p.resolved_case);
  EXPECT_EQ(text("status"), "done");
  EXPECT_EQ(text("inputs"),
            std::string(64, 'a') + "  cases/dome.toml\n" + std::string(64, 'b') + "  meshes/a punch.stl\n");
  EXPECT_EQ(hdf5::number_attribute(file.id(), "schema_version"), 1.0);
}

TEST_F(Results, KeepACaseTextBeyondTheLimitOfAnHdf5Attribute)
{
  Provenance provenance = dome::provenance();
  provenance.case_text.assign(200'000, 'x'); // 64 KiB is what fits an object's header
  const ResultsWriter writer(directory, mesh, provenance);
  EXPECT_EQ(hdf5::text_attribute(open().id(), "case"), provenance.case_text);
  EXPECT_EQ(hdf5::text_attribute(open().id(), "status"), "running");
}

TEST_F(Results, HaveRoomForTheNextStatus)
{
  ResultsWriter writer(directory, mesh, dome::provenance());
  writer.append(dome::frame(mesh, 0.5));
  // The text takes a heap of its own; a header that grew as well would lie beyond the end that the file knows of, for
  // whoever reads it just then.
  constexpr std::uintmax_t heap = 4096;
  const std::uintmax_t size = std::filesystem::file_size(directory / "results.h5");
  for (const char* status : {"interrupted", "running", "stopped at t = 1 ms", "done"}) {
    writer.finish(status);
    EXPECT_EQ((std::filesystem::file_size(directory / "results.h5") - size) % heap, 0U) << status;
    EXPECT_EQ(hdf5::text_attribute(open().id(), "status"), status);
  }
}

TEST_F(Results, AreTheSameWhenFieldsAreMadeOneByOne)
{
  const Frame frame = dome::frame(mesh, 1.0);
  std::vector<std::string> made;
  const std::filesystem::path other = directory / "other";
  ResultsWriter(directory, mesh, dome::provenance()).append(frame);
  ResultsWriter(other, mesh, dome::provenance()).append(frame.time, !frame.clearance.empty(), [&](std::string_view field) {
    made.emplace_back(field);
    return frame;
  });
  EXPECT_EQ(text_of(other / "results.h5"), text_of(directory / "results.h5"));
  EXPECT_EQ(text_of(other / "results.xdmf"), text_of(directory / "results.xdmf"));
  EXPECT_EQ(made.front(), "position");
  EXPECT_EQ(std::set(made.begin(), made.end()).size(), made.size());
}

TEST_F(Results, HoldEveryFieldOfAFrameWithItsUnits)
{
  const std::map<std::string, std::pair<std::string, hdf5::Shape>> expected = {
      {"position", {"m", {25, 3}}},    {"velocity", {"m/s", {25, 3}}},   {"contact_pressure", {"Pa", {25}}},
      {"shear_angle", {"deg", {32}}},  {"shear_rate", {"rad/s", {32}}},  {"curve_index", {"1", {32}}},
      {"curve_position", {"1", {32}}}, {"shear_force", {"N/m", {32}}},   {"fibre_1", {"1", {32, 3}}},
      {"fibre_2", {"1", {32, 3}}},     {"fibre_strain", {"1", {32, 2}}}, {"thickness", {"m", {32}}},
      {"temperature", {"K", {32}}},    {"clearance", {"m", {25}}},       {"curvature", {"1/m", {32, 2}}},
  };
  ResultsWriter writer(directory, mesh, dome::provenance());
  writer.append(dome::frame(mesh, 0.5));
  const hdf5::File file = open();
  const hdf5::Group frame = hdf5::open_group(file.id(), "frames/0000");
  EXPECT_EQ(hdf5::number_attribute(frame.id(), "time"), 0.03);
  EXPECT_EQ(hdf5::link_names(frame.id()).size(), expected.size());
  for (const auto& [name, units_and_shape] : expected) {
    const hdf5::Dataset dataset = hdf5::open_dataset(frame.id(), name);
    EXPECT_EQ(hdf5::text_attribute(dataset.id(), "units"), units_and_shape.first) << name;
    EXPECT_EQ(hdf5::shape_of(dataset), units_and_shape.second) << name;
  }
}

TEST_F(Results, KeepPositionsToTheBitAndTheRestToSevenDigits)
{
  Frame frame = dome::frame(mesh, 1.0);
  for (std::size_t i = 0; i < 32; ++i) { // a different value in every place, so that none can be mistaken
    const double x = 0.1 + static_cast<double>(i);
    frame.shear_angle[i] = x;
    frame.shear_rate[i] = 2 * x;
    frame.curve_index[i] = static_cast<std::int32_t>(i) + 1;
    frame.curve_position[i] = 3 * x;
    frame.shear_force[i] = 4 * x;
    frame.fibre_1[i] = {5 * x, 6 * x, 7 * x};
    frame.fibre_2[i] = {8 * x, 9 * x, 10 * x};
    frame.fibre_strain[i] = {11 * x, 12 * x};
    frame.thickness[i] = 13 * x;
    frame.curvature[i] = {19 * x, 20 * x};
    frame.temperature[i] = 14 * x;
  }
  for (std::size_t i = 0; i < 25; ++i) {
    frame.velocity[i] = {15.1, 16.1, 17.1 + static_cast<double>(i)};
    frame.contact_pressure[i] = 18.1 + static_cast<double>(i);
    frame.clearance[i] = 21.1 + static_cast<double>(i);
  }
  ResultsWriter writer(directory, mesh, dome::provenance());
  writer.append(frame);
  const auto value = [&](const char* name, std::size_t place) {
    return values(fmt::format("frames/0000/{}", name)).at(place);
  };
  const auto single = [](double x) { return static_cast<double>(static_cast<float>(x)); };
  for (std::size_t i = 0; i < 25; ++i) {
    EXPECT_EQ(value("position", 3 * i), frame.position[i].x);
    EXPECT_EQ(value("position", 3 * i + 2), frame.position[i].z);
  }
  const double x = 31.1; // of element 31
  EXPECT_EQ(value("shear_angle", 31), single(x));
  EXPECT_EQ(value("shear_rate", 31), single(2 * x));
  EXPECT_EQ(value("curve_index", 31), 32);
  EXPECT_EQ(value("curve_position", 31), single(3 * x));
  EXPECT_EQ(value("shear_force", 31), single(4 * x));
  EXPECT_EQ(value("fibre_1", 3 * 31 + 1), single(6 * x));
  EXPECT_EQ(value("fibre_2", 3 * 31 + 2), single(10 * x));
  EXPECT_EQ(value("fibre_strain", 2 * 31), single(11 * x));
  EXPECT_EQ(value("fibre_strain", 2 * 31 + 1), single(12 * x));
  EXPECT_EQ(value("thickness", 31), single(13 * x));
  EXPECT_EQ(value("temperature", 31), single(14 * x));
  EXPECT_EQ(value("velocity", 3 * 24 + 2), single(41.1));
  EXPECT_EQ(value("contact_pressure", 24), single(42.1));
  EXPECT_EQ(value("clearance", 24), single(45.1));
  EXPECT_EQ(value("curvature", 2 * 31), single(19 * x));
  EXPECT_EQ(value("curvature", 2 * 31 + 1), single(20 * x));
}

TEST_F(Results, TakeNoMoreThanTheirNumbersAndALittle)
{
  mesh = dome::sheet(40);
  ResultsWriter writer(directory, mesh, dome::provenance());
  for (int i = 0; i < 5; ++i) writer.append(dome::frame(mesh, 0.25 * i));
  writer.finish("done");
  const auto numbers = mesh.points.size() * (24 + 12 + 8) + mesh.triangles.size() * (7 * 4 + 24 + 16);
  const auto frame_size = std::filesystem::file_size(directory / "results.h5") / 5;
  EXPECT_LT(frame_size, numbers + 40'000); // the mesh, shared by the five frames, and headers
}

TEST_F(Results, ReplaceThoseOfAnEarlierRun)
{
  {
    ResultsWriter first(directory, mesh, dome::provenance());
    first.append(dome::frame(mesh, 1.0));
  }
  const ResultsWriter second(directory, mesh, dome::provenance());
  EXPECT_TRUE(frames().empty());
  EXPECT_FALSE(std::filesystem::exists(directory / "results.xdmf")); // it named frames that are gone
}

TEST_F(Results, GoIntoANewDirectoryAndItsParents)
{
  const ResultsWriter writer(directory / "a/b", mesh, dome::provenance());
  EXPECT_TRUE(std::filesystem::is_regular_file(directory / "a/b/results.h5"));
}

} // namespace towform
