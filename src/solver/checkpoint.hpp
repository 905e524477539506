#pragma once
#include "output/checkpoint_file.hpp"
#include "towform/case.hpp"
#include <functional>
#include <string>
#include <vector>

namespace towform {

/// What a checkpoint of this case says about itself.
CheckpointOrigin origin_of(const Case& c);

/// Writes results.h5 and history.csv through to the disk, then `state` into a new checkpoint. Throws
/// FileError.
void write_checkpoint(const std::filesystem::path& directory, const CheckpointOrigin& origin,
                      const std::function<void(FieldVisitor&)>& state);

/// What the run in a directory was started with.
struct StartedRun {
  Case c;
  CheckpointOrigin origin;
};

/// Throws CheckpointError when there is no checkpoint that is whole, or the case, its card, curves or a mesh
/// has changed since.
StartedRun started_run(const std::filesystem::path& directory);

/// Reads a directory's newest checkpoint that is whole through `state`, which is called again for the
/// one before it when the newest is damaged. Returns what the user should be told, a line each; the first is
/// where the run goes on from. Throws CheckpointError when none can be read.
std::vector<std::string> read_checkpoint(const std::filesystem::path& directory,
                                         const CheckpointOrigin& origin,
                                         const std::function<void(FieldVisitor&)>& state);

} // namespace towform
