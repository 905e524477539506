#pragma once
#include "towform/case.hpp"
#include "towform/results.hpp"

namespace towform {

/// Version, case and digests of the inputs of a run. Throws FileError.
Provenance provenance_of(const Case& c);

/// Writes DIR/case.resolved.toml. Throws FileError.
void write_resolved_case(const Case& c, const std::filesystem::path& directory);

} // namespace towform
