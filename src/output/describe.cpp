#include "output/hdf5.hpp"
#include "towform/error.hpp"
#include "towform/results.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <sstream>

namespace towform {

namespace {

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  std::size_t not_finite = 0;

  void add(double value)
  {
    if (!std::isfinite(value)) {
      ++not_finite;
      return;
    }
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

std::string line(const std::string& name, const std::string& units, const Range& range)
{
  std::string text = fmt::format("    {:<18} {:<6}", name, units);
  if (range.low <= range.high) text += fmt::format(" {:>13.6g} {:>13.6g}", range.low, range.high);
  if (range.not_finite > 0) text += fmt::format("  {} values are not finite", range.not_finite);
  return text + '\n';
}

/// A line for a field, or one for each of its components.
std::string describe_field(hid_t frame, const std::string& name)
{
  const hdf5::Dataset dataset = hdf5::open_dataset(frame, name);
  const std::string units = fmt::format("[{}]", hdf5::text_attribute(dataset.id(), "units"));
  const hdf5::Shape shape = hdf5::shape_of(dataset);
  const std::size_t components = shape.size() > 1 ? shape[1] : 1;
  const std::vector<double> values = hdf5::read_numbers(dataset);
  std::string text;
  for (std::size_t c = 0; c < components; ++c) {
    Range range;
    for (std::size_t i = c; i < values.size(); i += components) range.add(values[i]);
    std::string label = name;
    if (components == 3) label += fmt::format(" {}", "xyz"[c]);
    if (components == 2) label += fmt::format(" {}", c + 1);
    text += line(label, units, range);
  }
  return text;
}

std::string describe_frames(hid_t file)
{
  const hdf5::Group frames = hdf5::open_group(file, "frames");
  std::vector<std::string> names = hdf5::link_names(frames.id());
  // 10000 comes after 9999
  std::stable_sort(names.begin(), names.end(),
                   [](const auto& a, const auto& b) { return a.size() < b.size(); });
  if (names.empty()) return "  frames     none\n";
  const hdf5::Group first = hdf5::open_group(frames.id(), names.front());
  const hdf5::Group last = hdf5::open_group(frames.id(), names.back());
  const double end = hdf5::number_attribute(last.id(), "time");
  std::string text = fmt::format("  frames     {}, from {:g} s to {:g} s\n", names.size(),
                                 hdf5::number_attribute(first.id(), "time"), end);
  text += fmt::format("  {:<27} {:>13} {:>13}\n", fmt::format("last frame, {:g} s", end), "min", "max");
  for (const std::string& name : hdf5::link_names(last.id())) text += describe_field(last.id(), name);
  return text;
}

std::string describe_inputs(const std::string& digests)
{
  std::string text;
  std::istringstream lines(digests);
  for (std::string digest_and_file; std::getline(lines, digest_and_file);)
    text += fmt::format("    {}\n", digest_and_file);
  return text.empty() ? text : "  inputs (SHA-256)\n" + text;
}

} // namespace

std::string describe_results(const std::filesystem::path& path)
{
  if (!std::filesystem::exists(path)) throw FileError(fmt::format("{}: no such file", path.string()));
  if (std::filesystem::is_directory(path))
    throw FileError(fmt::format("{}: is a directory; its results.h5 is wanted", path.string()));
  const hdf5::File file = hdf5::File::open(path, hdf5::File::Mode::read);
  for (const char* part : {"mesh", "mesh/triangles", "mesh/reference", "frames"})
    if (!hdf5::has_link(file.id(), part))
      throw FileError(fmt::format("{}: not a towform results file: there is no /{}", path.string(), part));
  const auto text = [&](const char* name) { return hdf5::text_attribute(file.id(), name); };
  const auto rows = [&](const char* name) {
    return hdf5::shape_of(hdf5::open_dataset(file.id(), name)).at(0);
  };
  return fmt::format("{}: {}\n", path.string(), text("title")) +
         fmt::format("  written by towform {} ({}), {}\n", text("version"), text("git_hash"), text("flags")) +
         fmt::format("  status     {}\n", text("status")) +
         fmt::format("  sheet      {} nodes, {} elements\n", rows("mesh/reference"), rows("mesh/triangles")) +
         describe_inputs(text("inputs")) + describe_frames(file.id());
}

} // namespace towform
