#include "output/hdf5.hpp"
#include "case/float_traps.hpp"
#include "towform/error.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <numeric>

namespace towform::hdf5 {

namespace {

/// The innermost entry of HDF5's error stack is the cause; those round it only say who called.
std::string innermost_reason()
{
  std::string reason;
  const auto first = [](unsigned n, const H5E_error2_t* entry, void* text) -> herr_t {
    if (n == 0 && entry->desc != nullptr) *static_cast<std::string*>(text) = entry->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, first, &reason);
  // With files it lists everything it knows; the system's own words are enough.
  const std::string mark = "error message = '";
  if (const auto begin = reason.find(mark); begin != std::string::npos) {
    const auto from = begin + mark.size();
    return reason.substr(from, reason.find('\'', from) - from);
  }
  return reason.empty() ? "unknown reason" : reason;
}

std::string file_name(hid_t object)
{
  const ssize_t length = H5Fget_name(object, nullptr, 0);
  if (length <= 0) return "HDF5";
  std::string name(static_cast<std::size_t>(length), '\0');
  H5Fget_name(object, name.data(), name.size() + 1);
  return name;
}

/// HDF5 prints nothing, and does not tidy up when the program ends: a file that a full disk kept it from
/// closing would crash it there, and ours are closed by then.
void prepare()
{
  static const herr_t once = H5dont_atexit();
  (void)once;
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

/// Objects as of HDF5 1.8: their headers have checksums and room for what is to come.
Properties access_without_lock()
{
  Properties access(H5Pcreate(H5P_FILE_ACCESS));
  H5Pset_file_locking(access.id(), false, true);
  H5Pset_libver_bounds(access.id(), H5F_LIBVER_V18, H5F_LIBVER_V18);
  return access;
}

/// Without the time of creation: the same run writes the same bytes.
Properties timeless(hid_t kind)
{
  Properties creation(H5Pcreate(kind));
  H5Pset_obj_track_times(creation.id(), false);
  return creation;
}

/// All attributes in the root's header, where they are replaced in place.
Properties creation_of_file(hsize_t user_block)
{
  constexpr unsigned attributes_in_header = 64;
  Properties creation(H5Pcreate(H5P_FILE_CREATE));
  H5Pset_userblock(creation.id(), user_block);
  H5Pset_attr_phase_change(creation.id(), attributes_in_header, 0);
  H5Pset_obj_track_times(creation.id(), false);
  return creation;
}

/// Text of any length, UTF-8; what h5py gives back as str.
Type text_type()
{
  Type type(H5Tcopy(H5T_C_S1));
  H5Tset_size(type.id(), H5T_VARIABLE);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  return type;
}

void write_scalar(hid_t object, const std::string& name, hid_t type, const void* value)
{
  const std::string what = fmt::format("cannot write attribute {}", name);
  const bool there = check(H5Aexists(object, name.c_str()), object, what) > 0;
  const Space scalar(H5Screate(H5S_SCALAR));
  const Attribute attribute(
      check(there ? H5Aopen(object, name.c_str(), H5P_DEFAULT)
                  : H5Acreate2(object, name.c_str(), type, scalar.id(), H5P_DEFAULT, H5P_DEFAULT),
            object, what));
  check(H5Awrite(attribute.id(), type, value), object, what);
}

Attribute open_attribute(hid_t object, const std::string& name)
{
  return Attribute(
      check(H5Aopen(object, name.c_str(), H5P_DEFAULT), object, fmt::format("no attribute {}", name)));
}

} // namespace

hid_t check(hid_t result, hid_t where, const std::string& what)
{
  if (result >= 0) return result;
  const std::string reason = innermost_reason(); // before the next call clears it
  throw FileError(fmt::format("{}: {}: {}", file_name(where), what, reason));
}

File File::create(const std::filesystem::path& path, hsize_t user_block)
{
  prepare();
  const Properties access =
      access_without_lock(); // lives until the reason is read: closing it would clear that
  const Properties creation = creation_of_file(user_block);
  const hid_t id = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.id(), access.id());
  if (id < 0) throw FileError(fmt::format("{}: cannot be created: {}", path.string(), innermost_reason()));
  return {path, id};
}

File File::open(const std::filesystem::path& path, Mode mode)
{
  prepare();
  const Properties access = access_without_lock();
  const unsigned flags = mode == Mode::read ? H5F_ACC_RDONLY : H5F_ACC_RDWR;
  const hid_t id = H5Fopen(path.c_str(), flags, access.id());
  if (id < 0) throw FileError(fmt::format("{}: cannot be opened: {}", path.string(), innermost_reason()));
  return {path, id};
}

void File::flush()
{
  if (H5Fflush(handle_.id(), H5F_SCOPE_GLOBAL) < 0)
    throw FileError(fmt::format("{}: cannot be written: {}", path_.string(), innermost_reason()));
}

void File::close()
{
  if (H5Fclose(handle_.release()) < 0)
    throw FileError(fmt::format("{}: cannot be written: {}", path_.string(), innermost_reason()));
}

Group create_group(hid_t parent, const std::string& name) { return create_group(parent, name, 0, 0); }

Group create_group(hid_t parent, const std::string& name, unsigned links, unsigned characters)
{
  const Properties creation = timeless(H5P_GROUP_CREATE);
  constexpr unsigned most = 65535; // beyond, links move to a heap of their own
  if (links > 0) {
    H5Pset_link_phase_change(creation.id(), most, 0);
    H5Pset_est_link_info(creation.id(), std::min(links, most), characters);
  }
  return Group(check(H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, creation.id(), H5P_DEFAULT), parent,
                     fmt::format("cannot create group {}", name)));
}

Group create_unnamed_group(hid_t parent)
{
  const Properties creation = timeless(H5P_GROUP_CREATE);
  return Group(check(H5Gcreate_anon(parent, creation.id(), H5P_DEFAULT), parent, "cannot create a group"));
}

void name_object(hid_t object, hid_t parent, const std::string& name)
{
  check(H5Olink(object, parent, name.c_str(), H5P_DEFAULT, H5P_DEFAULT), parent,
        fmt::format("cannot name {}", name));
}

Group open_group(hid_t parent, const std::string& name)
{
  return Group(check(H5Gopen2(parent, name.c_str(), H5P_DEFAULT), parent, fmt::format("no group {}", name)));
}

Dataset open_dataset(hid_t parent, const std::string& name)
{
  return Dataset(
      check(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), parent, fmt::format("no dataset {}", name)));
}

bool has_link(hid_t parent, const std::string& name)
{
  return check(H5Lexists(parent, name.c_str(), H5P_DEFAULT), parent, "cannot look for " + name) > 0;
}

void remove_link(hid_t parent, const std::string& name)
{
  check(H5Ldelete(parent, name.c_str(), H5P_DEFAULT), parent, "cannot remove " + name);
}

std::vector<std::string> link_names(hid_t group)
{
  std::vector<std::string> names;
  const auto add = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  check(H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names), group, "cannot list a group");
  return names;
}

Dataset write_dataset(hid_t parent, const std::string& name, const Shape& shape, hid_t memory, hid_t stored,
                      const void* data)
{
  const UntrappedFloats converting; // doubles to floats, by HDF5
  const std::string what = fmt::format("cannot write dataset {}", name);
  const Space space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr));
  const Properties creation = timeless(H5P_DATASET_CREATE);
  Dataset dataset(
      check(H5Dcreate2(parent, name.c_str(), stored, space.id(), H5P_DEFAULT, creation.id(), H5P_DEFAULT),
            parent, what));
  check(H5Dwrite(dataset.id(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), parent, what);
  return dataset;
}

Shape shape_of(const Dataset& dataset)
{
  const Space space(check(H5Dget_space(dataset.id()), dataset.id(), "cannot read a dataset's shape"));
  Shape shape(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space.id())));
  H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr);
  return shape;
}

std::vector<double> read_numbers(const Dataset& dataset)
{
  const Shape shape = shape_of(dataset);
  std::vector<double> values(std::accumulate(shape.begin(), shape.end(), hsize_t{1}, std::multiplies<>()));
  check(H5Dread(dataset.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), dataset.id(),
        "cannot read a dataset");
  return values;
}

void write_attribute(hid_t object, const std::string& name, const std::string& text)
{
  const char* characters = text.c_str();
  write_scalar(object, name, text_type().id(), static_cast<const void*>(&characters));
}

void write_attribute(hid_t object, const std::string& name, double value)
{
  write_scalar(object, name, H5T_NATIVE_DOUBLE, &value);
}

void write_attribute(hid_t object, const std::string& name, int value)
{
  write_scalar(object, name, H5T_NATIVE_INT, &value);
}

void rename_attribute(hid_t object, const std::string& from, const std::string& to)
{
  const std::string what = fmt::format("cannot write attribute {}", to);
  if (check(H5Aexists(object, to.c_str()), object, what) > 0)
    check(H5Adelete(object, to.c_str()), object, what);
  check(H5Arename(object, from.c_str(), to.c_str()), object, what);
}

std::string text_attribute(hid_t object, const std::string& name)
{
  const Attribute attribute = open_attribute(object, name);
  char* characters = nullptr;
  check(H5Aread(attribute.id(), text_type().id(), static_cast<void*>(&characters)), object,
        fmt::format("attribute {} is not a text", name));
  std::string text = characters == nullptr ? "" : characters;
  H5free_memory(characters);
  return text;
}

double number_attribute(hid_t object, const std::string& name)
{
  const Attribute attribute = open_attribute(object, name);
  double value = 0.0;
  check(H5Aread(attribute.id(), H5T_NATIVE_DOUBLE, &value), object,
        fmt::format("attribute {} is not a number", name));
  return value;
}

} // namespace towform::hdf5
