#pragma once
#include "output/field_visitor.hpp"
#include "output/hdf5.hpp"
#include <memory>

namespace towform {

/// What a checkpoint belongs to; compared before anything is read from it.
struct CheckpointOrigin {
  std::string version, git_hash; ///< of the program that wrote it
  std::string solver;            ///< "explicit", "implicit"
  std::string resolved_case;     ///< the case with every value
  std::string inputs;            ///< digests of its files, as sha256sum prints them
};

/// Writes a checkpoint under a temporary name. An HDF5 file whose user block says what it is, how long it
/// is and the CRC-32 of all that follows, so that a damaged file never reaches HDF5. `commit` makes it
/// DIR/checkpoint.h5, keeping the one before as DIR/checkpoint.previous.h5. Throws FileError; the
/// checkpoints that were there then stay.
class CheckpointWriter final : public FieldVisitor {
public:
  /// `bytes` of values are to come: room for them is made sure of first.
  CheckpointWriter(std::filesystem::path directory, const CheckpointOrigin& origin, std::size_t bytes = 0);
  ~CheckpointWriter() override;
  void commit();

private:
  void numbers(const std::string& name, std::span<double> values, int columns) override;
  void integer(const std::string& name, std::int64_t& value) override;

  std::filesystem::path directory_, temporary_;
  std::unique_ptr<hdf5::File> file_;
  std::unique_ptr<hdf5::Group> state_;
  bool committed_ = false;
};

/// How many bytes the values take that it is shown.
class FieldBytes final : public FieldVisitor {
public:
  std::size_t bytes = 0;

private:
  static constexpr std::size_t header = 512; ///< a dataset's own, with room to spare
  void numbers(const std::string&, std::span<double> values, int) override
  {
    bytes += values.size_bytes() + header;
  }
  void integer(const std::string&, std::int64_t& value) override { bytes += sizeof(value) + header; }
};

/// A checkpoint whose CRC, length and schema are right. Throws CheckpointError naming the file and what is
/// wrong with it; so does every value that is missing or of another size.
class CheckpointReader final : public FieldVisitor {
public:
  explicit CheckpointReader(const std::filesystem::path& path);
  [[nodiscard]] const CheckpointOrigin& origin() const { return origin_; }

private:
  void numbers(const std::string& name, std::span<double> values, int columns) override;
  void integer(const std::string& name, std::int64_t& value) override;

  std::string path_;
  CheckpointOrigin origin_;
  std::unique_ptr<hdf5::File> file_;
  std::unique_ptr<hdf5::Group> state_;
};

std::filesystem::path checkpoint_path(const std::filesystem::path& directory);
std::filesystem::path previous_checkpoint_path(const std::filesystem::path& directory);

/// Those of an earlier run, before a new one starts.
void remove_checkpoints(const std::filesystem::path& directory);

} // namespace towform
