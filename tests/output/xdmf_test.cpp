#include "results_fixture.hpp"

namespace towform {

namespace {

using Xdmf = Results;

/// Every part of a text that stands between two marks.
std::vector<std::string> all_between(const std::string& text, const std::string& begin,
                                     const std::string& end)
{
  std::vector<std::string> parts;
  for (auto at = text.find(begin); at != std::string::npos; at = text.find(begin, at)) {
    at += begin.size();
    parts.push_back(text.substr(at, text.find(end, at) - at));
  }
  return parts;
}

} // namespace

TEST_F(Xdmf, IndexesTheFramesAfterEachOne)
{
  ResultsWriter writer(directory, mesh, dome::provenance());
  EXPECT_FALSE(std::filesystem::exists(directory / "results.xdmf"));
  for (int i = 0; i < 3; ++i) {
    writer.append(dome::frame(mesh, i / 2.0));
    const std::string xdmf = text_of(directory / "results.xdmf");
    const std::vector<std::string> all{"0", "0.03", "0.06"};
    EXPECT_EQ(all_between(xdmf, "<Time Value=\"", "\"/>"),
              std::vector<std::string>(all.begin(), all.begin() + i + 1));
  }
  EXPECT_FALSE(std::filesystem::exists(directory / "results.xdmf.new"));
}

TEST_F(Xdmf, NamesDatasetsThatExistWithTheirShapes)
{
  ResultsWriter writer(directory, mesh, dome::provenance());
  writer.append(dome::frame(mesh, 0.0));
  writer.append(dome::frame(mesh, 1.0));
  const std::string xdmf = text_of(directory / "results.xdmf");
  const std::vector<std::string> items = all_between(xdmf, "<DataItem", "</DataItem>");
  EXPECT_EQ(items.size(), 2U * 17U); // triangles, reference and 15 fields in each frame
  const hdf5::File file = open();
  for (const std::string& item : items) {
    const hdf5::Dataset dataset = hdf5::open_dataset(file.id(), item.substr(item.find("results.h5:") + 11));
    const hdf5::Type type(H5Dget_type(dataset.id()));
    EXPECT_TRUE(contains(item, fmt::format(" Dimensions=\"{}\"", fmt::join(hdf5::shape_of(dataset), " "))))
        << item;
    EXPECT_TRUE(contains(item, fmt::format(" Precision=\"{}\"", H5Tget_size(type.id())))) << item;
    EXPECT_EQ(contains(item, " NumberType=\"Int\""), H5Tget_class(type.id()) == H5T_INTEGER) << item;
  }
  EXPECT_TRUE(contains(xdmf, "results.h5:/frames/0001/position<"));
}

TEST_F(Xdmf, LeavesOutTheClearanceOfASheetWithoutTools)
{
  ResultsWriter writer(directory, mesh, dome::provenance());
  Frame frame = dome::frame(mesh, 0.0);
  frame.clearance.clear();
  writer.append(frame);
  EXPECT_FALSE(contains(text_of(directory / "results.xdmf"), "clearance"));
  EXPECT_TRUE(contains(text_of(directory / "results.xdmf"), "curvature"));
  const hdf5::File file = open();
  EXPECT_EQ(hdf5::link_names(hdf5::open_group(file.id(), "frames/0000").id()).size(), 14U);
  EXPECT_THROW(writer.append(dome::frame(mesh, 1.0)), std::invalid_argument); // in all frames, or in none
}

} // namespace towform
