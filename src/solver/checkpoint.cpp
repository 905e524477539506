#include "solver/checkpoint.hpp"
#include "output/text_file.hpp"
#include "solver/provenance.hpp"
#include "towform/error.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sstream>

namespace towform {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> candidates(const fs::path& directory)
{
  std::vector<fs::path> paths{checkpoint_path(directory), previous_checkpoint_path(directory)};
  std::error_code ignored;
  std::erase_if(paths, [&](const fs::path& path) { return !fs::exists(path, ignored); });
  if (paths.empty())
    throw CheckpointError(
        fmt::format("{}: there is no checkpoint to go on from", checkpoint_path(directory).string()));
  return paths;
}

/// `use` of the first checkpoint that is whole; the others' problems are lines.
template <class Use>
std::vector<std::string> with_newest(const fs::path& directory, const Use& use)
{
  std::vector<std::string> problems;
  for (const fs::path& path : candidates(directory)) {
    try {
      CheckpointReader reader(path);
      use(reader);
      if (!problems.empty()) problems.push_back(fmt::format("{}: going on from this one", path.string()));
      return problems;
    } catch (const CheckpointError& e) {
      problems.emplace_back(e.what());
    }
  }
  throw CheckpointError(fmt::format("{}", fmt::join(problems, "\n")));
}

/// A problem with the case, which no other checkpoint helps.
[[noreturn]] void refuse(const fs::path& directory, const std::string& what)
{
  throw CheckpointError(
      fmt::format("{}: {}; put it back as it was, or start anew with 'towform run' and --force",
                  directory.string(), what));
}

/// Every file that the run was started with must be as it was: `lines` are digest, two blanks, path.
std::string changed_input(const std::string& lines)
{
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);) {
    constexpr std::size_t digest = 64, path_at = digest + 2;
    if (line.size() <= path_at) continue;
    const fs::path path = line.substr(path_at);
    std::error_code ignored;
    if (!fs::exists(path, ignored)) return fmt::format("{} is not there any more", path.string());
    if (sha256_of_file(path) != line.substr(0, digest))
      return fmt::format("{} has changed since the run was started", path.string());
  }
  return "";
}

} // namespace

CheckpointOrigin origin_of(const Case& c)
{
  const Provenance p = provenance_of(c);
  std::string inputs; // found again from another folder
  for (const auto& [path, digest] : p.input_sha256)
    inputs += fmt::format("{}  {}\n", digest, fs::absolute(path).string());
  return {p.version, p.git_hash, c.solver == SolverKind::implicit ? "implicit" : "explicit", p.resolved_case,
          inputs};
}

void write_checkpoint(const fs::path& directory, const CheckpointOrigin& origin,
                      const std::function<void(FieldVisitor&)>& state)
{
  for (const char* file : {"results.h5", "history.csv"}) sync_file(directory / file);
  FieldBytes size;
  state(size);
  CheckpointWriter writer(directory, origin, size.bytes);
  state(writer);
  writer.commit();
}

StartedRun started_run(const fs::path& directory)
{
  CheckpointOrigin origin;
  with_newest(directory, [&](const CheckpointReader& reader) { origin = reader.origin(); });
  if (const std::string changed = changed_input(origin.inputs); !changed.empty()) refuse(directory, changed);
  const fs::path resolved = directory / "case.resolved.toml";
  try {
    Case c = read_case(resolved);
    if (resolved_case(c) != origin.resolved_case)
      refuse(directory, resolved.string() + " is not the case that the checkpoint belongs to");
    return {std::move(c), std::move(origin)};
  } catch (const InputError& e) {
    refuse(directory, fmt::format("the run's own case cannot be read: {}", e.what()));
  }
}

std::vector<std::string> read_checkpoint(const fs::path& directory, const CheckpointOrigin& origin,
                                         const std::function<void(FieldVisitor&)>& state)
{
  CheckpointOrigin found;
  std::vector<std::string> lines = with_newest(directory, [&](CheckpointReader& reader) {
    found = reader.origin();
    state(reader);
  });
  if (found.version != origin.version || found.git_hash != origin.git_hash)
    lines.push_back(fmt::format("the checkpoint was written by towform {} ({}), this is {} ({}): the last "
                                "digits may differ from an uninterrupted run",
                                found.version, found.git_hash, origin.version, origin.git_hash));
  return lines;
}

} // namespace towform
