#include "targets.hpp"
#include "compare/point_columns.hpp"
#include "compare/point_table.hpp"
#include "material/curve_file.hpp"
#include "material/shear_test.hpp"
#include "output/checkpoint_file.hpp"
#include "towform/blank.hpp"
#include "towform/case.hpp"
#include "towform/surface_mesh.hpp"
#include <fmt/format.h>
#include <fstream>
#include <stdexcept>
#include <unistd.h>

namespace towform::fuzz {

namespace fs = std::filesystem;

namespace {

/// A folder of this process, removed at its end.
const fs::path& folder()
{
  struct Folder {
    fs::path path = (fs::is_directory("/dev/shm") ? fs::path("/dev/shm") : fs::temp_directory_path()) /
                    fmt::format("towform-fuzz-{}", ::getpid());
    Folder() { fs::create_directories(path); }
    ~Folder()
    {
      std::error_code ignored;
      fs::remove_all(path, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
  };
  static const Folder the_folder;
  return the_folder.path;
}

void read_as_case(const fs::path& file) { (void)resolved_case(read_case(file)); }

void read_as_card(const fs::path& file)
{
  const fs::path case_file = folder() / "with_card.toml";
  std::ofstream(case_file) << "[blank]\nsize = [1, 1]\nelements = 8\nthickness = 0.001\n[material]\ncard = \""
                           << file.string() << "\"\ntemperature = 463\n[time]\nend = 1\n";
  (void)resolved_case(read_case(case_file));
}

void read_as_mesh(const fs::path& file)
{
  BlankParameters blank;
  blank.mesh = file;
  blank.thickness = 1e-3;
  (void)make_blank(blank);
}

void read_as_points(const fs::path& file) { (void)read_columns(read_points(file), {}); }

void read_as_test(const fs::path& file)
{
  ShearTest test;
  test.side = 0.115;
  (void)read_test(file, test, std::nullopt, 1.0);
}

} // namespace

const std::vector<Target>& targets()
{
  static const std::vector<Target> all{
      {"case", read_as_case},
      {"card", read_as_card},
      {"curves", [](const fs::path& file) { (void)read_curves(file); }},
      {"stl", [](const fs::path& file) { (void)read_stl(file); }},
      {"msh", read_as_mesh},
      {"checkpoint", [](const fs::path& file) { (void)CheckpointReader(file).origin(); }},
      {"points", read_as_points},
      {"test", read_as_test},
  };
  return all;
}

void give(const Target& target, std::span<const unsigned char> bytes)
{
  const fs::path file = folder() / fmt::format("{}.toml", target.name); // a card's name has to end so
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  try {
    target.read(file);
  } catch (const InputError&) {
  } catch (const FileError&) {
  } catch (const CheckpointError&) {
  } catch (const std::invalid_argument&) { // what a blank or a test cannot be
  } catch (const std::domain_error&) {     // constituents out of range
  }
}

} // namespace towform::fuzz
