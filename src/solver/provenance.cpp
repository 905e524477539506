#include "solver/provenance.hpp"
#include "output/text_file.hpp"
#include "version.hpp"

namespace towform {

Provenance provenance_of(const Case& c)
{
  Provenance p;
  p.version = version::number;
  p.git_hash = version::git_hash;
  p.flags = version::flags;
  p.title = c.title;
  p.case_text = c.text;
  p.resolved_case = resolved_case(c);
  std::vector<std::filesystem::path> inputs{c.path, c.blank.mesh, c.material.card_file, c.material.curves};
  for (const ToolParameters& tool : c.tools) inputs.push_back(tool.mesh);
  for (const std::filesystem::path& input : inputs)
    if (!input.empty()) p.input_sha256.emplace_back(input.string(), sha256_of_file(input));
  return p;
}

void write_resolved_case(const Case& c, const std::filesystem::path& directory)
{
  replace_file(directory / "case.resolved.toml", resolved_case(c));
}

} // namespace towform
