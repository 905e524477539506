#include "mesh/imported_blank.hpp"
#include "mesh/msh_files.hpp"
#include "mesh/msh_reader.hpp"
#include <algorithm>
#include <random>

namespace towform {
namespace {

/// Line numbers matter: a triangle, a quadrilateral, an edge and a corner, tags that skip, one node for
/// nothing.
const std::string plate = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
1
2 1 "the sheet"
$EndPhysicalNames
$Nodes
2 6 3 70
0 1 0 1
3
0 0 0
2 1 1 5
10
20
30
40
70
2 0 0 0.5 0.5
2 1 0 0.5 0.5
0 1 0 0.5 0.5
3 0.5 0 0.5 0.5
9 9 9 0.5 0.5
$EndNodes
$Elements
4 4 1 9
0 1 15 1
1 3
1 1 1 1
2 3 10
2 1 2 1
7 10 40 20
2 1 3 1
9 3 10 20 30
$EndElements
)";

MshMesh parse(const std::string& text) { return parse_msh(text, "blank.msh", 1e-3); }

std::string replaced(const std::string& what, const std::string& with)
{
  std::string text = plate;
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

TEST(MshReader, KeepsSurfaceElementsAndTheirNodes)
{
  const MshMesh mesh = parse(plate);
  ASSERT_EQ(mesh.nodes.size(), 5U); // node 70 belongs to nothing
  EXPECT_EQ(mesh.nodes[0].tag, 3);
  EXPECT_EQ(mesh.nodes[3].place, (Vec3{0.0, 1e-3, 0.0})); // millimetres
  EXPECT_EQ(mesh.nodes[4].place, (Vec3{3e-3, 0.5e-3, 0.0}));
  EXPECT_EQ(mesh.nodes[4].line, 22);
  ASSERT_EQ(mesh.elements.size(), 2U);
  EXPECT_EQ(mesh.elements[0].corners(), 3);
  EXPECT_EQ(mesh.elements[0].nodes, (std::array<int, 4>{1, 4, 2, -1}));
  EXPECT_EQ(mesh.elements[0].tag, 7);
  EXPECT_EQ(mesh.elements[0].line, 32);
  EXPECT_EQ(mesh.elements[1].corners(), 4);
  EXPECT_EQ(mesh.elements[1].nodes, (std::array<int, 4>{0, 1, 2, 3}));
}

TEST(MshReader, TakesOtherLineEndsBlankLinesAndSections)
{
  std::string windows;
  for (const char c : plate) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(parse(windows).elements.size(), 2U);
  EXPECT_EQ(
      parse(replaced("$Nodes\n2 6", "$Comments\nwords $Nodes\n\n$EndComments\n\n$Nodes\n\n2 6")).nodes.size(),
      5U);
  EXPECT_EQ(parse(replaced("$MeshFormat\n", "\n$MeshFormat\n")).nodes.size(), 5U);
}

TEST(MshReader, SaysWhatIsWrongAndOnWhichLine)
{
  struct Wrong {
    std::string what, with, place, message;
  };
  const std::vector<Wrong> all{
      {"$MeshFormat", "$Meshformat", "1", "is not a Gmsh mesh: a .msh file begins with $MeshFormat"},
      {"4.1 0 8", "2.2 0 8", "2", "is of MSH version 2.2, towform reads 4.1: `gmsh OLD.msh -save"},
      {"4.1 0 8", "4 0 8", "2", "is of MSH version 4, towform reads 4.1"},
      {"4.1 0 8", "4.1 1 8", "2", "is a binary MSH file, towform reads ASCII"},
      {"4.1 0 8", "4.1", "2", "'4.1' should hold version, 0 for ASCII"},
      {"$EndMeshFormat", "$EndFormat", "3", "expected $EndMeshFormat, found '$EndFormat'"},
      {"$EndPhysicalNames\n", "", "4", "this section has no $EndPhysicalNames: the file is truncated"},
      {"$Nodes\n2 6", "$Odes\n2 6", "8", "this section has no $EndOdes"},
      {"$EndNodes\n", "$EndNodes\n7\n", "25", "'7' stands outside the sections"},
      {"2 6 3 70", "2 6 3", "9", "'2 6 3' should hold blocks, nodes, lowest and highest tag"},
      {"2 6 3 70", "2 -6 3 70", "9", "counts cannot be negative"},
      {"2 6 3 70", "2 6000000000000 3 70", "9", "claims 6000000000000 nodes in 2 blocks, for which the"},
      {"2 6 3 70", "999999999 6 3 70", "9", "in 999999999 blocks, for which the"},
      {"2 6 3 70", "2 99999999999999999999 3 70", "9", "'99999999999999999999' is not a whole number"},
      {"2 6 3 70", "2 7 3 70", "9", "the blocks hold 1 nodes fewer than this line counts"},
      {"2 6 3 70", "2 5 3 70", "13", "a block of 5 nodes, where the section's first line leaves 4"},
      {"2 6 3 70", "3 6 3 70", "24", "$Nodes ends where a block of nodes should follow"},
      {"2 6 3 70", "1 6 3 70", "9", "the blocks hold 5 nodes fewer"},
      {"2 1 1 5", "2 1 1 -5", "13", "a block of -5 nodes"},
      {"2 1 1 5", "4 1 1 5", "13", "a block of dimension 4"},
      {"2 1 1 5", "2 1 1 4", "18", "'70' should hold x, y and z"},
      {"20\n30", "20.5\n30", "15", "'20.5' is not a whole number"},
      {"20\n30", "10\n30", "20", "a second node with tag 10; the first is on line 19"},
      {"2 1 0 0.5 0.5", "2 nan 0 0.5 0.5", "20", "'nan' is not a finite number"},
      {"2 1 0 0.5 0.5", "2 -inf 0 0.5 0.5", "20", "'-inf' is not a finite number"},
      {"2 1 0 0.5 0.5", "2 1e999 0 0.5 0.5", "20", "'1e999' is not a number"},
      {"2 1 0 0.5 0.5", "2 1,5 0 0.5 0.5", "20", "'1,5' is not a number: the line should hold x, y and z"},
      {"2 1 0 0.5 0.5", "2 1 0 0.5", "20", "should hold x, y and z of a node"},
      {"$EndNodes\n", "$EndNodes\n$Nodes\n", "25", "a second section $Nodes; the first is on line 8"},
      {"4 4 1 9", "4 400 1 9", "26", "claims 400 elements in 4 blocks"},
      {"4 4 1 9", "4 5 1 9", "26", "the blocks hold 1 elements fewer than this line counts"},
      {"4 4 1 9", "3 4 1 9", "26", "the blocks hold 1 elements fewer than this line counts"},
      {"2 1 2 1\n", "2 1 9 1\n", "31",
       "6-node triangles in the surface: a blank takes 3-node triangles (type 2)"},
      {"2 1 2 1\n", "2 1 16 1\n", "31", "8-node quadrilaterals in the surface"},
      {"2 1 2 1\n", "2 1 77 1\n", "31", "elements of type 77 in the surface"},
      {"2 1 2 1\n", "3 1 4 1\n", "31", "4-node tetrahedra fill a volume, a blank is flat"},
      {"2 1 2 1\n", "7 1 2 1\n", "31", "a block of dimension 7"},
      {"7 10 40 20", "7 10 40", "32", "'7 10 40' should hold the tag of an element and of its 3 nodes"},
      {"7 10 40 20", "7 10 40 20 30", "32", "an element of 3 nodes has 4 numbers behind its tag"},
      {"7 10 40 20", "7 10 41 20", "32", "element 7 uses node 41, which is not there"},
      {"7 10 40 20", "9 10 40 20", "34", "a second element with tag 9; the first is on line 32"},
      {"2 1 2 1\n7 10 40 20\n2 1 3 1\n9 3 10 20 30\n", "1 1 1 2\n7 10 40\n9 3 10\n", "34",
       "$Elements ends where a block of elements should follow"},
  };
  for (const Wrong& wrong : all) {
    const std::string text = replaced(wrong.what, wrong.with);
    const std::string said = test::refusal([&] { parse(text); });
    EXPECT_TRUE(said.starts_with("blank.msh:" + wrong.place + ":1: ")) << said << " | " << wrong.with;
    EXPECT_NE(said.find(wrong.message), std::string::npos) << said << " | " << wrong.with;
  }
}

TEST(MshReader, RefusesAFileCutAnywhere)
{
  const std::size_t end = plate.rfind("$EndElements") + std::string("$EndElements").size();
  for (std::size_t length = 0; length < end; ++length) {
    const std::string said = test::refusal([&] { parse(plate.substr(0, length)); });
    EXPECT_TRUE(said.starts_with("blank.msh:")) << said;
  }
  EXPECT_NO_THROW(parse(plate.substr(0, end)));
}

TEST(MshReader, DamageIsRefusedOrHarmless)
{
  // Bytes changed, lines swapped, dropped and doubled at random: nothing but a mesh or an issue may come out.
  std::mt19937 random(11);
  const auto below = [&](std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  };
  const std::string bytes = "0123456789 -.+eE$\n\0nai";
  int read = 0;
  for (int k = 0; k < 20000; ++k) {
    std::string text = plate;
    for (std::size_t i = below(3) + 1; i > 0; --i) {
      const std::size_t from = text.rfind('\n', below(text.size())) + 1, to = text.find('\n', from) + 1;
      switch (below(3)) {
      case 0:
        text[below(text.size())] = bytes[below(bytes.size())];
        break;
      case 1:
        text.erase(from, to - from);
        break;
      default:
        text.insert(to, text.substr(from, to - from));
      }
    }
    try {
      const MshMesh mesh = parse(text);
      triangles_of(mesh, "blank.msh");
      ++read;
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("blank.msh:")) << error.what();
    }
  }
  EXPECT_GT(read, 100); // comments and unused nodes bear some damage
}

TEST(MshReader, RefusesAMeshOfNothing)
{
  const std::string head = plate.substr(0, plate.find("$PhysicalNames"));
  EXPECT_NE(test::refusal([&] { parse(head); }).find("there is no section $Nodes"), std::string::npos);
  const std::string nodes = plate.substr(0, plate.find("$Elements"));
  EXPECT_NE(test::refusal([&] { parse(nodes); }).find("there is no section $Elements"), std::string::npos);
  const std::string said =
      test::refusal([&] { parse(nodes + "$Elements\n1 1 1 1\n1 1 1 1\n2 3 10\n$EndElements\n"); });
  EXPECT_NE(said.find("there are no triangles or quadrilaterals"), std::string::npos) << said;
}

} // namespace
} // namespace towform
