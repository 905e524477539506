#include "output/results_reader.hpp"
#include "output/hdf5.hpp"
#include "towform/error.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace towform {

namespace {

class Reader {
public:
  explicit Reader(const std::filesystem::path& path) : name_(path.string())
  {
    if (!std::filesystem::exists(path)) throw FileError(fmt::format("{}: no such file", name_));
    if (std::filesystem::is_directory(path))
      throw FileError(fmt::format("{}: is a directory; its results.h5 is wanted", name_));
    file_.emplace(hdf5::File::open(path, hdf5::File::Mode::read));
    for (const char* part : {"mesh", "mesh/triangles", "mesh/reference", "frames"})
      if (!hdf5::has_link(file_->id(), part))
        fail(fmt::format("not a towform results file: there is no /{}", part));
  }

  SheetResult read(std::optional<int> frame)
  {
    SheetResult sheet;
    const std::string group = choose(frame, sheet);
    sheet.flat.points = points("mesh/reference");
    sheet.flat.triangles = triangles(sheet.flat.points.size());
    sheet.position = points(group + "/position");
    if (sheet.position.size() != sheet.flat.points.size())
      fail(fmt::format("/{}/position has {} nodes, the mesh {}", group, sheet.position.size(),
                       sheet.flat.points.size()));
    sheet.shear = numbers(group + "/shear_angle", "deg", 1);
    if (sheet.shear.size() != sheet.flat.triangles.size())
      fail(fmt::format("/{}/shear_angle has {} elements, the mesh {}", group, sheet.shear.size(),
                       sheet.flat.triangles.size()));
    sheet.time = hdf5::number_attribute(hdf5::open_group(file_->id(), group).id(), "time");
    return sheet;
  }

private:
  std::string choose(std::optional<int> frame, SheetResult& sheet)
  {
    const std::vector<std::string> names = hdf5::link_names(hdf5::open_group(file_->id(), "frames").id());
    sheet.frames = static_cast<int>(names.size());
    if (names.empty()) fail("holds no frame yet");
    sheet.frame = frame.value_or(sheet.frames - 1);
    if (sheet.frame < 0 || sheet.frame >= sheet.frames)
      fail(fmt::format("there is no frame {}; there are frames 0 to {}", sheet.frame, sheet.frames - 1));
    return fmt::format("frames/{:04}", sheet.frame);
  }

  /// A dataset of so many columns, in these units.
  std::vector<double> numbers(const std::string& path, const std::string& units, std::size_t columns)
  {
    const hdf5::Dataset dataset = hdf5::open_dataset(file_->id(), path);
    const hdf5::Shape shape = hdf5::shape_of(dataset);
    const bool fits = columns == 1 ? shape.size() == 1 : shape.size() == 2 && shape[1] == columns;
    if (!fits) fail(fmt::format("/{} is not an array of {} column(s)", path, columns));
    if (const std::string given = hdf5::text_attribute(dataset.id(), "units"); given != units)
      fail(fmt::format("/{} is in {}, not {}", path, given, units));
    std::vector<double> values = hdf5::read_numbers(dataset);
    if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
      fail(fmt::format("/{} has values that are not finite", path));
    return values;
  }

  std::vector<Vec3> points(const std::string& path)
  {
    const std::vector<double> values = numbers(path, "m", 3);
    std::vector<Vec3> result;
    for (std::size_t i = 0; i < values.size(); i += 3)
      result.push_back({values[i], values[i + 1], values[i + 2]});
    return result;
  }

  std::vector<Triangle> triangles(std::size_t nodes)
  {
    const std::vector<double> values = numbers("mesh/triangles", "1", 3);
    std::vector<Triangle> result;
    for (std::size_t i = 0; i < values.size(); i += 3) {
      Triangle t{};
      for (std::size_t k = 0; k < 3; ++k) {
        if (!(values[i + k] >= 0.0 && values[i + k] < static_cast<double>(nodes)))
          fail(fmt::format("/mesh/triangles: element {} names a node that is not there", i / 3));
        t[k] = static_cast<int>(values[i + k]);
      }
      result.push_back(t);
    }
    if (result.empty()) fail("the mesh has no elements");
    return result;
  }

  [[noreturn]] void fail(const std::string& message) const
  {
    throw FileError(fmt::format("{}: {}", name_, message));
  }

  std::string name_;
  std::optional<hdf5::File> file_;
};

} // namespace

SheetResult read_sheet(const std::filesystem::path& path, std::optional<int> frame)
{
  return Reader(path).read(frame);
}

} // namespace towform
