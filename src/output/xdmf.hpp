#pragma once
#include <cstddef>
#include <span>
#include <string>

namespace towform {

/// The XDMF text that lets ParaView 5.11 read results.h5 (beside it) as a time series of the frames at
/// `times` [s], `with_optional` fields or without.
std::string xdmf_text(std::span<const double> times, std::size_t nodes, std::size_t elements,
                      bool with_optional);

} // namespace towform
