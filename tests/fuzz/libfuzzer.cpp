#include "targets.hpp"
#include <cstddef>
#include <cstdint>

/// The target is chosen where this file is compiled.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  towform::fuzz::give(towform::fuzz::targets().at(TOWFORM_FUZZ_TARGET), {data, size});
  return 0;
}
