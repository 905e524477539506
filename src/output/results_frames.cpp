#include "output/results_frames.hpp"
#include "towform/error.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace towform {

namespace {

hdf5::File opened(const std::filesystem::path& path)
{
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored))
    throw FileError(fmt::format("{}: no such file", path.string()));
  hdf5::File file = hdf5::File::open(path, hdf5::File::Mode::read);
  if (!hdf5::has_link(file.id(), "frames"))
    throw FileError(fmt::format("{}: not a towform results file: there is no /frames", path.string()));
  return file;
}

} // namespace

ResultsFrames::ResultsFrames(const std::filesystem::path& path) : path_(path), file_(opened(path))
{
  names_ = hdf5::link_names(hdf5::open_group(file_.id(), "frames").id());
  // 10000 comes after 9999
  std::stable_sort(names_.begin(), names_.end(),
                   [](const auto& a, const auto& b) { return a.size() < b.size(); });
  if (names_.empty()) throw FileError(fmt::format("{}: holds no frame yet", path.string()));
  for (const std::string& name : names_)
    times_.push_back(hdf5::number_attribute(hdf5::open_group(file_.id(), "frames/" + name).id(), "time"));
  const hdf5::Group first = hdf5::open_group(file_.id(), "frames/" + names_.front());
  for (const std::string& name : hdf5::link_names(first.id())) {
    const hdf5::Dataset dataset = hdf5::open_dataset(first.id(), name);
    const hdf5::Shape shape = hdf5::shape_of(dataset);
    if (shape.empty() || shape.size() > 2) continue;
    fields_.push_back({name, hdf5::text_attribute(dataset.id(), "units"), shape[0],
                       shape.size() > 1 ? static_cast<std::size_t>(shape[1]) : 1});
  }
}

const FrameField* ResultsFrames::find(const std::string& field) const
{
  const auto found =
      std::find_if(fields_.begin(), fields_.end(), [&](const FrameField& f) { return f.name == field; });
  return found == fields_.end() ? nullptr : &*found;
}

std::vector<double> ResultsFrames::values(std::size_t frame, const FrameField& field) const
{
  const std::string place = "frames/" + names_[frame] + '/' + field.name;
  std::vector<double> values = hdf5::read_numbers(hdf5::open_dataset(file_.id(), place));
  if (values.size() != field.rows * field.components)
    throw FileError(fmt::format("{}: /{} has {} values, the first frame {}", path_.string(), place,
                                values.size(), field.rows * field.components));
  return values;
}

std::string ResultsFrames::text(const std::string& attribute) const
{
  if (H5Aexists(file_.id(), attribute.c_str()) <= 0) return "";
  return hdf5::text_attribute(file_.id(), attribute);
}

} // namespace towform
