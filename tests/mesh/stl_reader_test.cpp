#include "towform/error.hpp"
#include "towform/surface_mesh.hpp"
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <unistd.h>

namespace towform {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for every test.
class Stl : public testing::Test {
protected:
  void SetUp() override
  {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() /
              (std::string("towform_stl_") + info->name() + "_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path file(const std::string& bytes, const std::string& name = "tool.stl")
  {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }

  static void expect_error(const fs::path& path, const std::string& what)
  {
    try {
      read_stl(path);
      FAIL() << "accepted; expected: " << what;
    } catch (const FileError& e) {
      EXPECT_EQ(std::string(e.what()), path.string() + what);
    }
  }

  fs::path folder_;
};

using Facet = std::array<Vec3, 3>;
const std::vector<Facet> tetrahedron{{{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}},
                                     {{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}},
                                     {{{0, 0, 0}, {0, 0, 1}, {0, 1, 0}}},
                                     {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};

std::string binary(const std::vector<Facet>& facets, std::string title = "a title")
{
  title.resize(80, '\0');
  const auto count = static_cast<std::uint32_t>(facets.size());
  title.append(reinterpret_cast<const char*>(&count), 4);
  for (const Facet& f : facets) {
    float values[12] = {};
    for (int k = 0; k < 3; ++k) {
      values[3 + 3 * k] = static_cast<float>(f[k].x);
      values[4 + 3 * k] = static_cast<float>(f[k].y);
      values[5 + 3 * k] = static_cast<float>(f[k].z);
    }
    title.append(reinterpret_cast<const char*>(values), 48);
    title.append(2, '\0');
  }
  return title;
}

std::string ascii(const std::vector<Facet>& facets)
{
  std::string text = "solid tetrahedron of facets\n";
  for (const Facet& f : facets) {
    text += "  facet normal nan 0 0\n    outer loop\n";
    for (const Vec3& p : f) {
      text += "      vertex " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) +
              "\n";
    }
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid tetrahedron\n";
}

const SurfaceMesh welded_tetrahedron{{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
                                     {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {2, 1, 3}}};

void expect_equal(const SurfaceMesh& a, const SurfaceMesh& b)
{
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.triangles, b.triangles);
}

} // namespace

TEST_F(Stl, ReadsBinaryAndTextAlike)
{
  expect_equal(read_stl(file(binary(tetrahedron))), welded_tetrahedron);
  expect_equal(read_stl(file(ascii(tetrahedron))), welded_tetrahedron);
}

TEST_F(Stl, SizeDecidesWhenABinaryFileBeginsWithSolid)
{
  expect_equal(read_stl(file(binary(tetrahedron, "solid from some program"))), welded_tetrahedron);
}

TEST_F(Stl, ReadsTextInAnyCaseWithWindowsLinesPlusSignsAndSeveralSolids)
{
  std::string one = "\nSOLID\r\nFACET NORMAL 0 0 1\r\nOUTER LOOP\r\nVERTEX +0 0 0\r\nVERTEX 1e0 0 0\r\n"
                    "VERTEX 0 1.0E+00 0\r\nENDLOOP\r\nENDFACET\r\nENDSOLID\r\n";
  std::string two =
      "solid b\nfacet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\n"
      "endfacet\nendsolid b";
  expect_equal(read_stl(file(one + two)),
               {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}}});
}

TEST_F(Stl, MultipliesByTheUnit)
{
  const SurfaceMesh mesh = read_stl(file(binary(tetrahedron)), 0.001);
  EXPECT_EQ(mesh.points[1], (Vec3{0, 0.001, 0}));
  EXPECT_THROW(read_stl(file(binary(tetrahedron)), 0.0), std::invalid_argument);
}

TEST_F(Stl, JoinsPointsThatDifferByRounding)
{
  std::vector<Facet> facets = tetrahedron;
  facets[3][0].x = 1.0 + 1e-7;
  EXPECT_EQ(read_stl(file(binary(facets))).points.size(), 4u);
  facets[3][0].x = 1.0 + 1e-5;
  EXPECT_EQ(read_stl(file(binary(facets))).points.size(), 5u);
}

TEST_F(Stl, WritesWhatItReads)
{
  SurfaceMesh mesh = welded_tetrahedron;
  for (Vec3& p : mesh.points) p = {0.3 * p.x + 0.1, 0.7 * p.y, -0.2 * p.z};
  std::swap(mesh.points[0], mesh.points[2]);
  for (const auto& title : std::vector<std::string>{"tool", "solid tool", std::string(200, 't')}) {
    const fs::path path = folder_ / "out.stl";
    write_stl(path, mesh, title);
    EXPECT_EQ(fs::file_size(path), 84u + 50u * 4u);
    const SurfaceMesh back = read_stl(path);
    ASSERT_EQ(back.triangles.size(), mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        const Vec3 &p = mesh.points[mesh.triangles[t][k]], &q = back.points[back.triangles[t][k]];
        EXPECT_EQ(static_cast<float>(q.x), static_cast<float>(p.x));
        EXPECT_EQ(static_cast<float>(q.y), static_cast<float>(p.y));
        EXPECT_EQ(static_cast<float>(q.z), static_cast<float>(p.z));
      }
    }
    std::ifstream in(path, std::ios::binary);
    std::string start(5, ' ');
    in.read(start.data(), 5);
    EXPECT_NE(start, "solid");
  }
}

TEST_F(Stl, WritesUnitNormals)
{
  write_stl(folder_ / "out.stl", {{{0, 0, 1}, {2, 0, 1}, {0, 3, 1}}, {{0, 1, 2}}}, "");
  std::ifstream in(folder_ / "out.stl", std::ios::binary);
  in.seekg(84);
  float normal[3];
  in.read(reinterpret_cast<char*>(normal), sizeof normal);
  EXPECT_EQ(normal[0], 0.0f);
  EXPECT_EQ(normal[1], 0.0f);
  EXPECT_EQ(normal[2], 1.0f);
}

TEST_F(Stl, SaysWhyItCannotWrite)
{
  EXPECT_THROW(write_stl(folder_, welded_tetrahedron, ""), FileError);
  EXPECT_THROW(write_stl(folder_ / "none" / "tool.stl", welded_tetrahedron, ""), FileError);
}

TEST_F(Stl, NamesMissingAndUnusableFiles)
{
  expect_error(folder_ / "none.stl", ": no such file; check the mesh's path");
  expect_error(folder_, ": is a directory; give the path of an STL file");
  expect_error("/dev/null", ": is not a regular file; give the path of an STL file");
  expect_error(file(""), ": is empty; export the mesh again");
  if (::geteuid() == 0) return; // root may read everything
  const fs::path locked = file(binary(tetrahedron), "locked.stl");
  fs::permissions(locked, fs::perms::none);
  expect_error(locked, ": cannot be opened: Permission denied");
}

TEST_F(Stl, RejectsWhatIsNotStl)
{
  expect_error(file("ply\nformat ascii"), ": is not an STL file: 16 bytes that do not begin with 'solid'");
  expect_error(file("  \n "), ": is not an STL file: 4 bytes that do not begin with 'solid'");
}

TEST_F(Stl, RejectsTruncatedAndLyingBinaryFiles)
{
  std::string bytes = binary(tetrahedron, "solid even so");
  const std::string claim = ": is truncated or not an STL file: its header claims ";
  expect_error(file(bytes.substr(0, 283)),
               claim + "4 facets, which take 284 bytes, but it has 283; export it again");
  expect_error(file(bytes + "x"), claim + "4 facets, which take 284 bytes, but it has 285; export it again");
  const std::uint32_t lie = 4000000000u;
  std::memcpy(bytes.data() + 80, &lie, 4);
  expect_error(file(bytes), claim +
                                "4000000000 facets, which take 200000000084 bytes, but it has 284; export it "
                                "again");
}

TEST_F(Stl, RejectsFilesWithoutFacets)
{
  expect_error(file(binary({})), ": has no facets; export the mesh again");
  expect_error(file("solid nothing\nendsolid nothing\n"), ": has no facets; export the mesh again");
}

TEST_F(Stl, RejectsCoordinatesThatAreNotFinite)
{
  std::vector<Facet> facets = tetrahedron;
  facets[2][1].z = std::numeric_limits<double>::quiet_NaN();
  expect_error(file(binary(facets)), ": facet 3 has a coordinate that is not finite; export the mesh again");
  expect_error(file(ascii(facets)),
               ":19: facet 3 has a coordinate that is not finite ('nan'); export the mesh again");
  facets[2][1].z = -std::numeric_limits<double>::infinity();
  expect_error(file(binary(facets)), ": facet 3 has a coordinate that is not finite; export the mesh again");
}

TEST_F(Stl, NamesTheLineOfABadText)
{
  const std::string good = ascii(tetrahedron);
  std::string bad = good;
  bad.replace(bad.find("endloop"), 7, "endlop!");
  expect_error(file(bad), ":7: expected 'endloop', found 'endlop!'; this is not a valid ASCII STL file");
  bad = good;
  bad.replace(bad.find("1.000000"), 8, "1.0000x0");
  expect_error(file(bad), ":5: expected a number, found '1.0000x0'; this is not a valid ASCII STL file");
  bad = good;
  bad.replace(bad.find("1.000000"), 8, "1e999");
  expect_error(file(bad), ":5: expected a number, found '1e999'; this is not a valid ASCII STL file");
  expect_error(file(good + "junk"),
               ":31: expected 'solid', found 'junk'; this is not a valid ASCII STL file");
  expect_error(file("solid a\n\nvertex 0 0 0\nendsolid a"),
               ":3: expected 'facet' or 'endsolid', found 'vertex'; this is not a valid ASCII STL file");
}

TEST_F(Stl, NamesTheLineWhereATextEndsTooSoon)
{
  const std::string good = ascii(tetrahedron);
  expect_error(
      file(good.substr(0, good.find("endsolid"))),
      ":30: the file ends where 'facet' or 'endsolid' should follow; it is truncated, export it again");
  expect_error(file(good.substr(0, good.find("vertex") + 7)),
               ":4: the file ends where a number should follow; it is truncated, export it again");
  expect_error(file("solid a\n facet normal 0 0"), ":2: the file ends where the three numbers of a normal "
                                                   "should follow; it is truncated, export it again");
}

TEST_F(Stl, ChecksTheSurface)
{
  std::vector<Facet> facets = tetrahedron;
  std::swap(facets[2][0], facets[2][1]);
  expect_error(file(binary(facets)),
               ": facets 1 and 3 share an edge but face opposite sides (3 such edges in all); "
               "orient all normals outwards in the program that made the mesh");
  facets = tetrahedron;
  facets.push_back(facets[1]);
  expect_error(file(ascii(facets)), ": facet 5 has the same corners as facet 2 (1 such facet in all); remove "
                                    "duplicate facets in the program that made the mesh");
  facets = tetrahedron;
  facets.push_back({{{0, 0, 0}, {1, 0, 0}, {1, -1, -1}}});
  expect_error(file(binary(facets)),
               ": facet 1 shares an edge with more than one other facet (1 such edge in all); "
               "keep only the surface that touches the sheet");
  facets = tetrahedron;
  facets[1][2] = {1, 1e-7, 0};
  expect_error(file(binary(facets)),
               ": facet 2 has no area or repeats a corner (1 such facet in all); remove "
               "degenerate facets in the program that made the mesh");
}

TEST_F(Stl, RejectsAFileOfOnePoint)
{
  expect_error(
      file(binary({{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}}})),
      ": facet 1 has no area or repeats a corner (1 such facet in all); remove degenerate facets in the "
      "program that made the mesh");
}

} // namespace towform
