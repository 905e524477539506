#pragma once
#include "towform/surface_mesh.hpp"
#include "towform/vec3.hpp"
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace towform {

/// One output frame: the state of the sheet at a time. Sizes: n nodes, m elements.
struct Frame {
  double time = 0.0;                               ///< [s]
  std::vector<Vec3> position;                      ///< n [m]
  std::vector<Vec3> velocity;                      ///< n [m/s]
  std::vector<double> contact_pressure;            ///< n [Pa]
  std::vector<double> clearance;                   ///< n [m], to the nearest tool; empty without tools
  std::vector<double> shear_angle;                 ///< m [deg]
  std::vector<double> shear_rate;                  ///< m [rad/s]
  std::vector<std::int32_t> curve_index;           ///< m, 1-based number of the curve in use
  std::vector<double> curve_position;              ///< m, its continuous version
  std::vector<double> shear_force;                 ///< m [N/m]
  std::vector<Vec3> fibre_1, fibre_2;              ///< m, unit yarn directions
  std::vector<std::array<double, 2>> fibre_strain; ///< m [-]
  std::vector<std::array<double, 2>> curvature;    ///< m [1/m], along both yarns, since the flat blank
  std::vector<double> thickness;                   ///< m [m]
  std::vector<double> temperature;                 ///< m [K]
};

/// Makes a frame field by field: called with the name of one in the file, returns a frame of which that field alone need be
/// there. So a frame of a fine mesh never stands in memory as a whole.
using FieldSource = std::function<Frame(std::string_view field)>;

/// Where a result came from; becomes the root attributes of results.h5.
struct Provenance {
  std::string version, git_hash, flags;
  std::string title;
  std::string case_text;                                         ///< as the user wrote it
  std::string resolved_case;                                     ///< with every default
  std::vector<std::pair<std::string, std::string>> input_sha256; ///< (file, digest)
};

/// results.h5 and results.xdmf of a run. The HDF5 file is opened, extended and closed for every frame, so
/// that a reader can look during the run; a program that dies at any moment leaves a file that can be read.
/// Throws FileError naming the file, also while another program has it open for writing.
class ResultsWriter {
public:
  /// Creates DIR/results.h5 (replacing one that is there) with `/mesh` and the root attributes, status
  /// "running". More frames than expected can be appended, less safely.
  ResultsWriter(std::filesystem::path directory, const SurfaceMesh& blank, const Provenance& provenance,
                int expected_frames = 100);
  /// Goes on with DIR/results.h5 after its first `frames` frames; later ones are removed.
  ResultsWriter(std::filesystem::path directory, const SurfaceMesh& blank, int frames);
  void append(const Frame& frame);
  /// A frame at `time` [s]; `clearance` says whether it has that field.
  void append(double time, bool clearance, const FieldSource& source);
  /// Sets the root attribute `status`: "done" or why the run stopped.
  void finish(const std::string& status);
  [[nodiscard]] int frames() const { return frames_; }

private:
  template <class Each>
  void append_fields(double time, bool clearance, const Each& each);
  void count_frame(double time);
  void write_xdmf() const;

  std::filesystem::path directory_;
  std::size_t nodes_, elements_;
  int frames_ = 0;
  std::string xdmf_; ///< what results.xdmf says of the frames
  bool clearance_ = false; ///< has the first frame, and so has every one
};

/// history.csv: one row per output interval, flushed as it is written.
class HistoryWriter {
public:
  HistoryWriter(const std::filesystem::path& path, const std::vector<std::string>& columns);
  /// Goes on with a file after its first `rows` rows; what follows them is cut off. Throws FileError when it
  /// has fewer or other columns.
  HistoryWriter(const std::filesystem::path& path, const std::vector<std::string>& columns,
                std::int64_t rows);
  void append(const std::vector<double>& row); ///< as many values as columns; whole numbers print as such

private:
  std::filesystem::path path_;
  std::size_t columns_;
};

/// The figures of a whole run; summary.json, under these names.
struct Summary {
  std::string status = "running";
  std::string message; ///< why a run stopped; empty when done
  std::int64_t elements = 0, nodes = 0, steps = 0;
  double simulated_time_s = 0.0, wall_time_s = 0.0;
  int threads = 1;
  double ns_per_element_step = 0.0;
  double step_min_s = 0.0, step_max_s = 0.0;
  double energy_error = 0.0;
  double kinetic_to_internal_max = 0.0;
  double shear_angle_max_deg = 0.0, shear_angle_p99_deg = 0.0;
  double fibre_strain_max = 0.0; ///< largest |strain| of any yarn in any element
  double fibre_strain_p99 = 0.0;
  double fibre_strain_over_2_percent = 0.0; ///< fraction of the elements with |strain| > 2 %
  double fibre_compression_max = 0.0;       ///< largest shortening of any yarn, positive
  double fibre_compression_p99 = 0.0;
  double fibre_compression_over_half_percent = 0.0; ///< fraction of the elements with more than 0.5 %
  double draw_in_x_mid_mm = 0.0, draw_in_y_mid_mm = 0.0, draw_in_corner_mm = 0.0;
  double punch_force_max_N = 0.0;
  double penetration_max_mm = 0.0;
  double added_mass_fraction = 0.0;
  std::vector<std::pair<std::string, double>> energies_J;
  std::vector<std::pair<std::string, double>> phases_s;
};

/// Writes DIR/summary.json through a temporary name. Throws FileError.
void write_summary(const std::filesystem::path& directory, const Summary& summary);

/// SHA-256 of a file's bytes, 64 lower-case hexadecimal digits. Throws FileError.
std::string sha256_of_file(const std::filesystem::path& path);

/// What `towform info` prints about a results file. Throws FileError.
std::string describe_results(const std::filesystem::path& path);

} // namespace towform
