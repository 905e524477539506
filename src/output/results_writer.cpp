#include "case/float_traps.hpp"
#include "output/field.hpp"
#include "output/hdf5.hpp"
#include "output/text_file.hpp"
#include "output/xdmf.hpp"
#include "towform/error.hpp"
#include "towform/results.hpp"
#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <stdexcept>
#include <sys/file.h>
#include <unistd.h>

namespace towform {

namespace fs = std::filesystem;

namespace {

constexpr int schema_version = 1;

fs::path results_path(const fs::path& directory) { return directory / "results.h5"; }

hid_t file_type(Field::Number number)
{
  switch (number) {
  case Field::Number::int32:
    return H5T_STD_I32LE;
  case Field::Number::float32:
    return H5T_IEEE_F32LE;
  default:
    return H5T_IEEE_F64LE;
  }
}

void write_with_units(hid_t parent, const char* name, const hdf5::Shape& shape, hid_t memory, hid_t stored,
                      const void* data, const char* units)
{
  const hdf5::Dataset dataset = hdf5::write_dataset(parent, name, shape, memory, stored, data);
  hdf5::write_attribute(dataset.id(), "units", std::string(units));
}

void write_mesh(const hdf5::File& file, const SurfaceMesh& blank)
{
  static_assert(sizeof(Triangle) == 3 * sizeof(std::int32_t));
  const hdf5::Group mesh = hdf5::create_group(file.id(), "mesh");
  write_with_units(mesh.id(), "triangles", {blank.triangles.size(), 3}, H5T_NATIVE_INT, H5T_STD_I32LE,
                   blank.triangles.data(), "1");
  write_with_units(mesh.id(), "reference", {blank.points.size(), 3}, H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE,
                   blank.points.data(), "m");
}

/// The digests as `sha256sum` prints them, so that `sha256sum -c` checks them.
std::string digest_lines(const Provenance& provenance)
{
  std::string lines;
  for (const auto& [file, digest] : provenance.input_sha256) lines += fmt::format("{}  {}\n", digest, file);
  return lines;
}

void write_provenance(const hdf5::File& file, const Provenance& provenance)
{
  hdf5::write_attribute(file.id(), "schema_version", schema_version);
  hdf5::write_attribute(file.id(), "version", provenance.version);
  hdf5::write_attribute(file.id(), "git_hash", provenance.git_hash);
  hdf5::write_attribute(file.id(), "flags", provenance.flags);
  hdf5::write_attribute(file.id(), "title", provenance.title);
  hdf5::write_attribute(file.id(), "case", provenance.case_text);
  hdf5::write_attribute(file.id(), "resolved_case", provenance.resolved_case);
  hdf5::write_attribute(file.id(), "inputs", digest_lines(provenance));
}

/// The root's last entry. The first text stays behind as room in its header for the next one, whose name must be no
/// longer: a header that grows does so at the file's end, and cannot be read before the file knows that it is longer.
void set_first_status(const hdf5::File& file, const std::string& status)
{
  for (const char* name : {"latest", "status"}) hdf5::write_attribute(file.id(), name, status);
  hdf5::rename_attribute(file.id(), "latest", "status");
}

/// The new text is in the file before it replaces the old one.
void set_status(hdf5::File& file, const std::string& status)
{
  hdf5::write_attribute(file.id(), "latest", status);
  file.flush();
  hdf5::rename_attribute(file.id(), "latest", "status");
}

/// A program that has the file open to write, with the lock that HDF5 takes, and we would spoil it for each
/// other. Readers do not matter.
void refuse_other_writers(const fs::path& path)
{
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return; // whoever opens it next says why
  const bool taken = ::flock(file, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(file);
  if (taken)
    throw FileError(fmt::format("{}: is open for writing in another program; close it there", path.string()));
}

std::size_t rows_of(const Field& field, std::size_t nodes, std::size_t elements)
{
  return field.centre == Field::Centre::node ? nodes : elements;
}

/// Bytes a frame takes.
std::size_t frame_bytes(bool optional, std::size_t nodes, std::size_t elements)
{
  std::size_t bytes = header_bytes;
  for (const Field& field : fields())
    if (optional || !field.optional)
      bytes += rows_of(field, nodes, elements) * static_cast<std::size_t>(field.components) * size_of(field.stored);
  return bytes;
}

/// Throws std::invalid_argument when an array has a wrong length.
void check_rows(const Field& field, const Frame& frame, std::size_t nodes, std::size_t elements)
{
  const std::size_t rows = field.values(frame).rows, expected = rows_of(field, nodes, elements);
  if (rows != expected)
    throw std::invalid_argument(fmt::format("frame: {} has {} rows instead of {}", field.name, rows, expected));
}

/// Doubles in single precision, infinite where they are too large. HDF5 would take and give back buffers for each array.
std::vector<float> in_single_precision(const double* values, std::size_t count)
{
  const UntrappedFloats converting;
  std::vector<float> single(count);
  std::transform(values, values + count, single.begin(), [](double value) { return static_cast<float>(value); });
  return single;
}

// Not compressed: deflate at level 1 takes a quarter off the size of a noisy field and eight times as long.
void write_field(hid_t group, const Field& field, const Frame& frame)
{
  const Field::Values values = field.values(frame);
  hdf5::Shape shape{values.rows};
  if (field.components > 1) shape.push_back(static_cast<hsize_t>(field.components));
  const auto write = [&](hid_t memory, const void* data) {
    write_with_units(group, field.name, shape, memory, file_type(field.stored), data, field.units);
  };
  const std::size_t numbers = values.rows * static_cast<std::size_t>(field.components);
  switch (field.stored) {
  case Field::Number::int32:
    return write(H5T_NATIVE_INT32, values.data);
  case Field::Number::float32:
    return write(H5T_NATIVE_FLOAT, in_single_precision(static_cast<const double*>(values.data), numbers).data());
  case Field::Number::float64:
    return write(H5T_NATIVE_DOUBLE, values.data);
  }
}

} // namespace

ResultsWriter::ResultsWriter(fs::path directory, const SurfaceMesh& blank, const Provenance& provenance,
                             int expected_frames)
    : directory_(std::move(directory)), nodes_(blank.points.size()), elements_(blank.triangles.size())
{
  make_directory(directory_);
  const fs::path path = results_path(directory_);
  refuse_other_writers(path);
  fs::path temporary = path;
  temporary += ".new";
  try {
    std::ofstream(temporary, std::ios::trunc).close(); // there must be a file to reserve room behind
    reserve_space(temporary, header_bytes + 32 * static_cast<std::size_t>(expected_frames) +
                                 provenance.case_text.size() + provenance.resolved_case.size() +
                                 nodes_ * sizeof(Vec3) + elements_ * sizeof(Triangle));
    hdf5::File file = hdf5::File::create(temporary);
    write_provenance(file, provenance);
    write_mesh(file, blank);
    (void)hdf5::create_group(file.id(), "frames", static_cast<unsigned>(expected_frames), 4);
    set_first_status(file, "running");
    file.close();
    for (const char* of_earlier : {"results.xdmf", "summary.json", "report.html"}) { // results, about to be replaced
      std::error_code ignored;
      fs::remove(directory_ / of_earlier, ignored);
    }
    fs::rename(temporary, path);
  } catch (const fs::filesystem_error& e) {
    fs::remove(temporary);
    throw FileError(fmt::format("{}: cannot be written: {}", path.string(), e.code().message()));
  } catch (const FileError&) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw;
  }
}

ResultsWriter::ResultsWriter(fs::path directory, const SurfaceMesh& blank, int frames)
    : directory_(std::move(directory)), nodes_(blank.points.size()), elements_(blank.triangles.size())
{
  const fs::path path = results_path(directory_);
  refuse_other_writers(path);
  reserve_space(path, header_bytes);
  hdf5::File file = hdf5::File::open(path, hdf5::File::Mode::append);
  {
    const hdf5::Group group = hdf5::open_group(file.id(), "frames");
    const std::vector<std::string> names = hdf5::link_names(group.id());
    if (names.size() < static_cast<std::size_t>(frames))
      throw FileError(fmt::format("{}: holds {} frames where the checkpoint was written after {}",
                                  path.string(), names.size(), frames));
    for (int i = 0; i < frames; ++i) {
      const hdf5::Group frame = hdf5::open_group(group.id(), names[i]);
      clearance_ = hdf5::has_link(frame.id(), "clearance");
      count_frame(hdf5::number_attribute(frame.id(), "time"));
    }
    write_xdmf(); // before frames go that it names
    for (std::size_t i = frames; i < names.size(); ++i) hdf5::remove_link(group.id(), names[i]);
  }
  set_status(file, "running");
  file.close();
}

void ResultsWriter::append(const Frame& frame)
{
  const bool clearance = !frame.clearance.empty();
  for (const Field& field : fields())
    if (clearance || !field.optional) check_rows(field, frame, nodes_, elements_);
  append_fields(frame.time, clearance, [&](const Field&, const auto& write) { write(frame); });
}

void ResultsWriter::append(double time, bool clearance, const FieldSource& source)
{
  append_fields(time, clearance, [&](const Field& field, const auto& write) {
    const Frame part = source(field.name);
    check_rows(field, part, nodes_, elements_);
    write(part);
  });
}

/// Calls each(field, write) for the fields, which calls write(frame) with a frame that has the field.
template <class Each>
void ResultsWriter::append_fields(double time, bool clearance, const Each& each)
{
  if (frames_ == 0) clearance_ = clearance;
  if (clearance_ != clearance) throw std::invalid_argument("frame: clearance in some frames only");
  const fs::path path = results_path(directory_);
  refuse_other_writers(path);
  reserve_space(path, frame_bytes(clearance, nodes_, elements_));
  hdf5::File file = hdf5::File::open(path, hdf5::File::Mode::append);
  {
    // The frame is in the file, whole, before it gets its name: whenever the program dies, the file can be
    // read and no part of a frame is in it.
    const hdf5::Group group = hdf5::create_unnamed_group(file.id());
    hdf5::write_attribute(group.id(), "time", time);
    for (const Field& field : fields())
      if (clearance || !field.optional)
        each(field, [&](const Frame& frame) { write_field(group.id(), field, frame); });
    file.flush();
    hdf5::name_object(group.id(), file.id(), fmt::format("/frames/{:04}", frames_));
  }
  file.close();
  count_frame(time);
  write_xdmf();
}

void ResultsWriter::finish(const std::string& status)
{
  const fs::path path = results_path(directory_);
  refuse_other_writers(path);
  reserve_space(path, header_bytes + status.size());
  hdf5::File file = hdf5::File::open(path, hdf5::File::Mode::append);
  set_status(file, status);
  file.close();
}

void ResultsWriter::count_frame(double time)
{
  xdmf_ += xdmf_frame(static_cast<std::size_t>(frames_), time, nodes_, elements_, clearance_);
  ++frames_;
}

void ResultsWriter::write_xdmf() const { replace_file(directory_ / "results.xdmf", xdmf_text(xdmf_)); }

} // namespace towform
