#pragma once
#include "towform/results.hpp"
#include <cstddef>
#include <span>

namespace towform {

/// A field of a frame as the files hold it. The table of fields is the one place that knows names, units and
/// stored types; results.h5 and results.xdmf are both written from it.
struct Field { // NOLINT(clang-analyzer-optin.performance.Padding): in the order of a reader
  enum class Centre { node, element };
  enum class Number { int32, float32, float64 };
  struct Values {
    const void* data;
    std::size_t rows;
  };

  const char* name;
  const char* units;
  Centre centre;
  int components;
  Number stored; ///< in the file; in memory it is double, or int32 when stored so
  Values (*values)(const Frame&);
  bool optional = false; ///< left out of frames that have no rows of it
};

/// Every field of a frame, `position` first.
std::span<const Field> fields();

/// Bytes of a number in the file.
constexpr std::size_t size_of(Field::Number number) { return number == Field::Number::float64 ? 8 : 4; }

} // namespace towform
