#pragma once
#include <cstddef>
#include <filesystem>
#include <hdf5.h>
#include <string>
#include <utility>
#include <vector>

/// A thin layer over HDF5's C interface: handles close themselves, and every failure becomes a FileError with
/// the file's name and HDF5's reason. HDF5's own printing of errors is turned off by the first File.
namespace towform::hdf5 {

/// Owns an HDF5 identifier.
template <herr_t (*Close)(hid_t)>
class Handle {
public:
  Handle() = default;
  explicit Handle(hid_t id) : id_(id) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle(Handle&& other) noexcept : id_(other.release()) {}
  Handle& operator=(Handle&& other) noexcept
  {
    std::swap(id_, other.id_);
    return *this;
  }
  ~Handle()
  {
    if (id_ >= 0) Close(id_);
  }
  [[nodiscard]] hid_t id() const { return id_; }
  hid_t release() { return std::exchange(id_, H5I_INVALID_HID); }

private:
  hid_t id_ = H5I_INVALID_HID;
};

using Attribute = Handle<H5Aclose>;
using Dataset = Handle<H5Dclose>;
using Group = Handle<H5Gclose>;
using Properties = Handle<H5Pclose>;
using Space = Handle<H5Sclose>;
using Type = Handle<H5Tclose>;

/// An open file. No lock is taken, so that a reader that holds the file open cannot stop a run.
class File {
public:
  enum class Mode { read, append };
  /// Replaces a file that is there; the first `user_block` bytes (0, 512, 1024, …) are left to the caller.
  static File create(const std::filesystem::path& path, hsize_t user_block = 0);
  static File open(const std::filesystem::path& path, Mode mode);

  void flush();
  /// Writes out what is buffered and closes; throws FileError when that fails (a destructor could not say
  /// so).
  void close();
  [[nodiscard]] hid_t id() const { return handle_.id(); }

private:
  File(std::filesystem::path path, hid_t id) : path_(std::move(path)), handle_(id) {}
  std::filesystem::path path_;
  Handle<H5Fclose> handle_;
};

/// Passes on what an HDF5 function returned; throws FileError when it is negative: file of `where` (any
/// identifier in the file), `what` was tried, HDF5's reason.
hid_t check(hid_t result, hid_t where, const std::string& what);

using Shape = std::vector<hsize_t>;

// `parent` is a File, a Group or a Dataset's identifier.
Group create_group(hid_t parent, const std::string& name);
/// A group whose header has room for so many links with names of so many characters: naming an object in it
/// then is one write in place, which a reader sees whole or not at all.
Group create_group(hid_t parent, const std::string& name, unsigned links, unsigned characters);
Group create_unnamed_group(hid_t parent); ///< vanishes when closed unless `name_object` names it
void name_object(hid_t object, hid_t parent, const std::string& name);
Group open_group(hid_t parent, const std::string& name);
Dataset open_dataset(hid_t parent, const std::string& name);
bool has_link(hid_t parent, const std::string& name);
void remove_link(hid_t parent, const std::string& name);
std::vector<std::string> link_names(hid_t group); ///< ascending

/// Writes an array: `memory` is the type it has, `stored` the type it gets in the file.
Dataset write_dataset(hid_t parent, const std::string& name, const Shape& shape, hid_t memory, hid_t stored,
                      const void* data);
Shape shape_of(const Dataset& dataset);
/// All values of a dataset of numbers, whatever their type in the file; rows one after the other.
std::vector<double> read_numbers(const Dataset& dataset);

void write_attribute(hid_t object, const std::string& name, const std::string& text); ///< replaces
void write_attribute(hid_t object, const std::string& name, double value);
void write_attribute(hid_t object, const std::string& name, int value);
void rename_attribute(hid_t object, const std::string& from, const std::string& to); ///< replaces
std::string text_attribute(hid_t object, const std::string& name);
double number_attribute(hid_t object, const std::string& name);

} // namespace towform::hdf5
