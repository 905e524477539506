#include "output/checkpoint_file.hpp"
#include "output/checksum.hpp"
#include "output/text_file.hpp"
#include "towform/error.hpp"
#include <cstdio>
#include <fmt/format.h>
#include <fstream>

namespace towform {

namespace fs = std::filesystem;

namespace {

constexpr int schema = 5;
constexpr hsize_t block_size = 512; ///< the smallest user block of HDF5

/// The user block: text, so that `head -4 checkpoint.h5` shows it.
std::string block_text(std::uintmax_t bytes, std::uint32_t crc)
{
  return fmt::format("towform checkpoint\nschema {}\nbytes {}\ncrc32 {:08x}\n", schema, bytes, crc);
}

struct Block {
  int schema = 0;
  unsigned long long bytes = 0;
  unsigned crc = 0;
};

Block read_block(const fs::path& path)
{
  std::ifstream file(path, std::ios::binary);
  std::string text(block_size, '\0');
  if (!file.read(text.data(), block_size))
    throw CheckpointError(fmt::format("{}: is too short to be a checkpoint", path.string()));
  Block block;
  if (std::sscanf(text.c_str(), "towform checkpoint\nschema %9d\nbytes %20llu\ncrc32 %8x\n", &block.schema,
                  &block.bytes, &block.crc) != 3)
    throw CheckpointError(fmt::format("{}: is not a checkpoint of towform", path.string()));
  return block;
}

void check_whole(const fs::path& path)
{
  const Block block = read_block(path);
  if (block.schema != schema)
    throw CheckpointError(
        fmt::format("{}: has schema {}, this towform reads schema {}", path.string(), block.schema, schema));
  if (const auto size = fs::file_size(path); size != block.bytes)
    throw CheckpointError(
        fmt::format("{}: is damaged: {} bytes instead of {}", path.string(), size, block.bytes));
  if (crc32_of_file(path, block_size) != block.crc)
    throw CheckpointError(fmt::format("{}: is damaged: its CRC is wrong", path.string()));
}

} // namespace

fs::path checkpoint_path(const fs::path& directory) { return directory / "checkpoint.h5"; }
fs::path previous_checkpoint_path(const fs::path& directory) { return directory / "checkpoint.previous.h5"; }

void remove_checkpoints(const fs::path& directory)
{
  // The newest last: as long as it is there, a run goes on from it and tidies up at its end.
  for (const fs::path& path : {previous_checkpoint_path(directory), checkpoint_path(directory)}) {
    std::error_code error;
    fs::remove(path, error);
    if (error) throw FileError(fmt::format("{}: cannot be removed: {}", path.string(), error.message()));
  }
}

CheckpointWriter::CheckpointWriter(fs::path directory, const CheckpointOrigin& origin, std::size_t bytes)
    : directory_(std::move(directory)), temporary_(checkpoint_path(directory_))
{
  temporary_ += ".new";
  const std::size_t room = bytes + header_bytes + origin.resolved_case.size() + origin.inputs.size();
  // HDF5 must not meet a full disk: it could not even close the file.
  std::ofstream(temporary_, std::ios::trunc).close();
  try {
    reserve_space(temporary_, room);
  } catch (const FileError&) {
    std::error_code ignored;
    fs::remove(temporary_, ignored);
    throw;
  }
  file_ = std::make_unique<hdf5::File>(hdf5::File::create(temporary_, block_size));
  for (const auto& [name, text] : {std::pair{"version", &origin.version},
                                   {"git_hash", &origin.git_hash},
                                   {"solver", &origin.solver},
                                   {"resolved_case", &origin.resolved_case},
                                   {"inputs", &origin.inputs}})
    hdf5::write_attribute(file_->id(), name, *text);
  state_ = std::make_unique<hdf5::Group>(hdf5::create_group(file_->id(), "state"));
  reserve_space(temporary_, room); // that of before went with the old file
}

CheckpointWriter::~CheckpointWriter()
{
  state_.reset();
  file_.reset();
  std::error_code ignored;
  if (!committed_) fs::remove(temporary_, ignored);
}

void CheckpointWriter::numbers(const std::string& name, std::span<double> values, int columns)
{
  hdf5::Shape shape{values.size() / static_cast<std::size_t>(columns)};
  if (columns > 1) shape.push_back(static_cast<hsize_t>(columns));
  (void)hdf5::write_dataset(state_->id(), name, shape, H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE, values.data());
}

void CheckpointWriter::integer(const std::string& name, std::int64_t& value)
{
  (void)hdf5::write_dataset(state_->id(), name, {1}, H5T_NATIVE_INT64, H5T_STD_I64LE, &value);
}

void CheckpointWriter::commit()
{
  state_.reset();
  file_->close();
  const std::string text = block_text(fs::file_size(temporary_), crc32_of_file(temporary_, block_size));
  overwrite_start(temporary_, text);
  sync_file(temporary_);
  std::error_code none_yet;
  fs::rename(checkpoint_path(directory_), previous_checkpoint_path(directory_), none_yet);
  std::error_code error;
  fs::rename(temporary_, checkpoint_path(directory_), error);
  if (error)
    throw FileError(
        fmt::format("{}: cannot be written: {}", checkpoint_path(directory_).string(), error.message()));
  committed_ = true;
  sync_file(directory_);
}

CheckpointReader::CheckpointReader(const fs::path& path) : path_(path.string())
{
  check_whole(path);
  try {
    file_ = std::make_unique<hdf5::File>(hdf5::File::open(path, hdf5::File::Mode::read));
    state_ = std::make_unique<hdf5::Group>(hdf5::open_group(file_->id(), "state"));
    for (const auto& [name, text] : {std::pair{"version", &origin_.version},
                                     {"git_hash", &origin_.git_hash},
                                     {"solver", &origin_.solver},
                                     {"resolved_case", &origin_.resolved_case},
                                     {"inputs", &origin_.inputs}})
      *text = hdf5::text_attribute(file_->id(), name);
  } catch (const FileError& e) {
    throw CheckpointError(e.what());
  }
}

namespace {

/// A dataset of so many numbers into memory of the same type.
void read_exactly(const hdf5::Group& state, const std::string& path, const std::string& name, hid_t memory,
                  std::size_t count, void* values)
{
  try {
    const hdf5::Dataset dataset = hdf5::open_dataset(state.id(), name);
    std::size_t stored = 1;
    for (const hsize_t n : hdf5::shape_of(dataset)) stored *= n;
    if (stored != count)
      throw CheckpointError(
          fmt::format("{}: /state/{} has {} numbers, the case needs {}", path, name, stored, count));
    if (count > 0)
      hdf5::check(H5Dread(dataset.id(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), dataset.id(),
                  "cannot read " + name);
  } catch (const FileError& e) {
    throw CheckpointError(e.what());
  }
}

} // namespace

void CheckpointReader::numbers(const std::string& name, std::span<double> values, int)
{
  read_exactly(*state_, path_, name, H5T_NATIVE_DOUBLE, values.size(), values.data());
}

void CheckpointReader::integer(const std::string& name, std::int64_t& value)
{
  read_exactly(*state_, path_, name, H5T_NATIVE_INT64, 1, &value);
}

} // namespace towform
