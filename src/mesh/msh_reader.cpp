#include "mesh/msh_reader.hpp"
#include "mesh/mesh_file.hpp"
#include "mesh/msh_lines.hpp"
#include "towform/error.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace towform {

namespace {

// A node takes two lines, "1" and "0 0 0"; the shortest element, a point, is "1 1"; each with its end of
// line.
constexpr std::size_t least_bytes_of_node = 8, least_bytes_of_element = 4;
constexpr std::size_t file_element_limit = 20'000'000; // as of generated blanks

/// What the user knows a type of element as; types as in Gmsh's manual.
std::string type_name(std::int64_t type)
{
  switch (type) {
  case 4:
    return "4-node tetrahedra";
  case 5:
    return "8-node hexahedra";
  case 9:
    return "6-node triangles";
  case 10:
    return "9-node quadrilaterals";
  case 16:
    return "8-node quadrilaterals";
  default:
    return fmt::format("elements of type {}", type);
  }
}

class Parser {
public:
  Parser(std::string_view text, const std::string& name, double unit) : lines_(text, name), unit_(unit) {}

  MshMesh parse()
  {
    format();
    while (lines_.next()) section();
    if (nodes_at_ == 0) lines_.fail("there is no section $Nodes: the file is truncated or holds no mesh");
    if (elements_at_ == 0)
      lines_.fail("there is no section $Elements: the file is truncated or holds no mesh");
    if (elements_.empty())
      lines_.fail_at(elements_at_, "there are no triangles or quadrilaterals: mesh the surface (gmsh -2)");
    return with_used_nodes();
  }

private:
  struct Element {
    std::array<std::int64_t, 4> nodes; // tags
    std::int64_t tag;
    int corners, line;
  };

  void format()
  {
    if (!lines_.next() || lines_.line() != "$MeshFormat")
      lines_.fail("is not a Gmsh mesh: a .msh file begins with $MeshFormat");
    lines_.expect_line("the version of the format");
    const std::string_view version = lines_.line().substr(0, lines_.line().find_first_of(" \t"));
    if (version != "4.1")
      lines_.fail(fmt::format(
          "is of MSH version {}, towform reads 4.1: `gmsh OLD.msh -save -format msh41 -o NEW.msh` "
          "converts it",
          version.substr(0, 10)));
    const auto& numbers = lines_.reals(3, "version, 0 for ASCII, and the size of numbers");
    if (numbers[1] != 0.0)
      lines_.fail("is a binary MSH file, towform reads ASCII: save it with Mesh.Binary = 0");
    end_of("MeshFormat");
  }

  void section()
  {
    const std::string_view line = lines_.line();
    if (!line.starts_with('$') || line.starts_with("$End"))
      lines_.fail(fmt::format("'{}' stands outside the sections: expected the start of one, such as $Nodes",
                              line.substr(0, 40)));
    if (line == "$Nodes") return nodes();
    if (line == "$Elements") return elements();
    const std::string end = fmt::format("$End{}", line.substr(1));
    const int start = lines_.number();
    while (lines_.next())
      if (lines_.line() == end) return;
    lines_.fail_at(start, fmt::format("this section has no {}: the file is truncated, export it again", end));
  }

  /// The first line of $Nodes or $Elements: blocks and their things in all.
  std::pair<std::int64_t, std::int64_t> counts(const std::string& things, std::size_t least_bytes)
  {
    lines_.expect_line(fmt::format("the number of {}", things));
    const auto& n = lines_.whole_numbers(4, fmt::format("blocks, {}, lowest and highest tag", things));
    if (n[0] < 0 || n[1] < 0) lines_.fail("counts cannot be negative");
    const std::size_t most = lines_.bytes_left() / least_bytes;
    if (static_cast<std::uint64_t>(n[1]) > most || static_cast<std::uint64_t>(n[0]) > most)
      lines_.fail(fmt::format(
          "claims {} {} in {} blocks, for which the {} bytes that follow are too few: the file is "
          "truncated or its counts are wrong",
          n[1], things, n[0], lines_.bytes_left()));
    if (static_cast<std::uint64_t>(n[1]) > 3 * file_element_limit)
      lines_.fail(fmt::format("{} {} are more than towform can take; coarsen the mesh", n[1], things));
    return {n[0], n[1]};
  }

  void nodes()
  {
    if (nodes_at_ != 0)
      lines_.fail(fmt::format("a second section $Nodes; the first is on line {}", nodes_at_));
    nodes_at_ = lines_.number();
    auto [blocks, left] = counts("nodes", least_bytes_of_node);
    nodes_.reserve(static_cast<std::size_t>(left));
    for (; blocks > 0; --blocks) {
      content("Nodes", "a block of nodes");
      const auto& head = lines_.whole_numbers(4, "dimension, tag, parametric (0 or 1) and nodes of a block");
      const std::int64_t dimension = head[0], parametric = head[2], count = head[3];
      if (dimension < 0 || dimension > 3)
        lines_.fail(fmt::format("a block of dimension {}: 0 to 3 there are", dimension));
      check_block(count, left, "nodes");
      left -= count;
      const std::size_t first = nodes_.size();
      for (std::int64_t i = 0; i < count; ++i) {
        content("Nodes", "the tag of a node");
        nodes_.push_back({{}, lines_.whole_numbers(1, "the tag of a node").front(), 0});
      }
      const std::size_t components = 3 + static_cast<std::size_t>(parametric != 0 ? dimension : 0);
      for (std::size_t i = first; i < nodes_.size(); ++i) {
        content("Nodes", "the place of a node");
        const auto& x = lines_.reals(components, "x, y and z of a node");
        nodes_[i].place = {unit_ * x[0], unit_ * x[1], unit_ * x[2]};
        nodes_[i].line = lines_.number();
      }
    }
    if (left > 0)
      lines_.fail_at(nodes_at_ + 1,
                     fmt::format("the blocks hold {} nodes fewer than this line counts", left));
    end_of("Nodes");
  }

  void elements()
  {
    if (elements_at_ != 0)
      lines_.fail(fmt::format("a second section $Elements; the first is on line {}", elements_at_));
    elements_at_ = lines_.number();
    auto [blocks, left] = counts("elements", least_bytes_of_element);
    for (; blocks > 0; --blocks) {
      content("Elements", "a block of elements");
      const auto& head = lines_.whole_numbers(4, "dimension, tag, type and elements of a block");
      const std::int64_t dimension = head[0], type = head[2], count = head[3];
      check_block(count, left, "elements");
      left -= count;
      const int corners = corners_of(dimension, type);
      for (std::int64_t i = 0; i < count; ++i) {
        content("Elements", "an element");
        if (corners > 0) element(corners);
      }
    }
    if (left > 0)
      lines_.fail_at(elements_at_ + 1,
                     fmt::format("the blocks hold {} elements fewer than this line counts", left));
    end_of("Elements");
  }

  void element(int corners)
  {
    const auto& n = lines_.whole_numbers(1 + static_cast<std::size_t>(corners),
                                         fmt::format("the tag of an element and of its {} nodes", corners));
    if (n.size() != 1 + static_cast<std::size_t>(corners))
      lines_.fail(fmt::format("an element of {} nodes has {} numbers behind its tag", corners, n.size() - 1));
    Element e{{n[1], n[2], n[3], corners == 4 ? n[4] : 0}, n[0], corners, lines_.number()};
    elements_.push_back(e);
    if (elements_.size() > file_element_limit)
      lines_.fail(fmt::format("more than {} elements; coarsen the mesh", file_element_limit));
  }

  /// Corners of the elements of a block; 0 when they are none of the blank.
  int corners_of(std::int64_t dimension, std::int64_t type) const
  {
    if (dimension == 0 || dimension == 1) return 0;
    if (dimension == 2 && type == 2) return 3;
    if (dimension == 2 && type == 3) return 4;
    if (dimension == 3)
      lines_.fail(fmt::format("{} fill a volume, a blank is flat: save the mesh of its surface only",
                              type_name(type)));
    if (dimension != 2) lines_.fail(fmt::format("a block of dimension {}: 0 to 3 there are", dimension));
    lines_.fail(
        fmt::format("{} in the surface: a blank takes 3-node triangles (type 2) and 4-node quadrilaterals "
                    "(type 3); mesh with order 1",
                    type_name(type)));
  }

  void check_block(std::int64_t count, std::int64_t left, const char* things) const
  {
    if (count >= 0 && count <= left) return;
    lines_.fail(
        fmt::format("a block of {} {}, where the section's first line leaves {}", count, things, left));
  }

  /// The next line of a section that must not end yet.
  void content(const std::string& section, const std::string& wanted)
  {
    lines_.expect_line(wanted);
    if (lines_.line() == "$End" + section)
      lines_.fail(
          fmt::format("${} ends where {} should follow: its counts are wrong or the file is incomplete",
                      section, wanted));
  }

  void end_of(const std::string& section)
  {
    const std::string end = "$End" + section;
    lines_.expect_line(end);
    if (lines_.line() != end)
      lines_.fail(fmt::format("expected {}, found '{}': the section's counts are wrong", end,
                              lines_.line().substr(0, 40)));
  }

  MshMesh with_used_nodes()
  {
    std::vector<int> by_tag = sorted_by_tag(nodes_, "node");
    sorted_by_tag(elements_, "element");
    MshMesh mesh;
    std::vector<char> used(nodes_.size(), 0);
    for (const Element& e : elements_) {
      MshMesh::Element made{{-1, -1, -1, -1}, e.tag, e.line};
      for (int k = 0; k < e.corners; ++k) {
        const auto found =
            std::lower_bound(by_tag.begin(), by_tag.end(), e.nodes[k],
                             [&](int node, std::int64_t tag) { return nodes_[node].tag < tag; });
        if (found == by_tag.end() || nodes_[*found].tag != e.nodes[k])
          lines_.fail_at(e.line,
                         fmt::format("element {} uses node {}, which is not there", e.tag, e.nodes[k]));
        made.nodes[k] = *found;
        used[*found] = 1;
      }
      mesh.elements.push_back(made);
    }
    std::vector<int> number(nodes_.size(), -1);
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      if (used[n] == 0) continue;
      number[n] = static_cast<int>(mesh.nodes.size());
      mesh.nodes.push_back(nodes_[n]);
    }
    for (MshMesh::Element& e : mesh.elements)
      for (int k = 0; k < e.corners(); ++k) e.nodes[k] = number[e.nodes[k]];
    return mesh;
  }

  template <class Thing>
  std::vector<int> sorted_by_tag(const std::vector<Thing>& things, const char* what) const
  {
    std::vector<int> order(things.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return things[a].tag < things[b].tag; });
    const auto same = std::adjacent_find(order.begin(), order.end(),
                                         [&](int a, int b) { return things[a].tag == things[b].tag; });
    if (same != order.end())
      lines_.fail_at(things[*(same + 1)].line, fmt::format("a second {} with tag {}; the first is on line {}",
                                                           what, things[*same].tag, things[*same].line));
    return order;
  }

  MshLines lines_;
  double unit_;
  int nodes_at_ = 0, elements_at_ = 0; // lines of the sections
  std::vector<MshMesh::Node> nodes_;
  std::vector<Element> elements_;
};

} // namespace

MshMesh parse_msh(std::string_view text, const std::string& name, double unit)
{
  return Parser(text, name, unit).parse();
}

MshMesh read_msh(const std::filesystem::path& path, double unit)
{
  return parse_msh(read_mesh_file(path, "a Gmsh file"), path.string(), unit);
}

} // namespace towform
