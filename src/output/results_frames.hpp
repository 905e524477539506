#pragma once
#include "output/hdf5.hpp"
#include <string>
#include <vector>

namespace towform {

/// What a results file says of one of its fields.
struct FrameField {
  std::string name, units;
  std::size_t rows = 0, components = 1; ///< of its array
};

/// The frames of a results file, read field by field and frame by frame, so that a long run need not fit into
/// memory. Throws FileError naming the file: not there, not results, arrays of other sizes than the first
/// frame's.
class ResultsFrames {
public:
  explicit ResultsFrames(const std::filesystem::path& path);

  [[nodiscard]] std::size_t size() const { return names_.size(); }
  [[nodiscard]] const std::vector<double>& times() const { return times_; }       ///< [s]
  [[nodiscard]] const std::vector<FrameField>& fields() const { return fields_; } ///< of the first frame
  [[nodiscard]] const FrameField* find(const std::string& field) const;           ///< null when not there
  [[nodiscard]] std::vector<double> values(std::size_t frame, const FrameField& field) const; ///< row by row
  [[nodiscard]] std::string text(const std::string& attribute) const; ///< of the file; empty when not there

private:
  std::filesystem::path path_;
  hdf5::File file_;
  std::vector<std::string> names_;
  std::vector<double> times_;
  std::vector<FrameField> fields_;
};

} // namespace towform
