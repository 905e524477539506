#pragma once
#include "solver/model.hpp"
#include "towform/results.hpp"

namespace towform {

/// What a run is, in one line.
std::string headline(const Case& c, const Model& model);

/// How it went, what to look at, and where it is.
std::string closing(const Summary& s, const std::filesystem::path& directory);

} // namespace towform
