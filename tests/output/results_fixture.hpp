#pragma once
#include "dome.hpp"
#include "output/hdf5.hpp"
#include "temporary_directory.hpp"

namespace towform {

/// Results in a directory of their own, read back.
class Results : public TemporaryDirectory {
protected:
  hdf5::File open(hdf5::File::Mode mode = hdf5::File::Mode::read) const
  {
    return hdf5::File::open(directory / "results.h5", mode);
  }
  std::vector<std::string> frames() const
  {
    const hdf5::File file = open();
    return hdf5::link_names(hdf5::open_group(file.id(), "frames").id());
  }
  std::vector<double> values(const std::string& path) const
  {
    const hdf5::File file = open();
    return hdf5::read_numbers(hdf5::open_dataset(file.id(), path));
  }

  SurfaceMesh mesh = dome::sheet(4); ///< 25 nodes, 32 elements
};

inline bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

} // namespace towform
