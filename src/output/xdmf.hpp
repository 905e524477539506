#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace towform {

/// The XDMF text that lets ParaView 5.11 read results.h5 (beside it) as a time series of `frames`, one after the other.
std::string xdmf_text(std::string_view frames);

/// A frame at `time` [s] there, `with_optional` fields or without.
std::string xdmf_frame(std::size_t frame, double time, std::size_t nodes, std::size_t elements, bool with_optional);

} // namespace towform
