#include "data_files.hpp"
#include "suggestion.hpp"
#include "version.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace towform {

namespace fs = std::filesystem;

namespace {

fs::path from_root(const fs::path& path)
{
  std::error_code ignored;
  const fs::path here = "."; // the folder of a case that was named without one
  return fs::absolute(path.empty() ? here / "" : path, ignored).lexically_normal();
}

bool is_file(const fs::path& path)
{
  std::error_code ignored;
  return fs::exists(path, ignored) && !fs::is_directory(path, ignored);
}

/// Folders in order, each once, absolute.
std::vector<fs::path> once(const std::vector<fs::path>& folders)
{
  std::vector<fs::path> result;
  for (const fs::path& folder : folders) {
    fs::path path = from_root(folder / "");
    if (std::find(result.begin(), result.end(), path) == result.end()) result.push_back(std::move(path));
  }
  return result;
}

FoundFile look_for(const fs::path& name, const std::vector<fs::path>& folders)
{
  if (name.is_absolute()) {
    if (is_file(name)) return {name.lexically_normal(), ""};
    return {{}, "is not there"};
  }
  std::vector<std::string> places;
  for (const fs::path& folder : once(folders)) {
    if (is_file(folder / name)) return {(folder / name).lexically_normal(), ""};
    places.push_back(folder.parent_path().string());
  }
  return {{}, "is not there; looked in " + listed(places, "and")};
}

std::vector<fs::path> card_folders(const fs::path& case_file)
{
  const fs::path cards = fs::path("cases") / "cards";
  return {case_file.parent_path() / "cards", cards, version::source_data / cards,
          version::installed_data / cards};
}

} // namespace

FoundFile find_mesh(const std::string& name, const fs::path& case_file)
{
  return look_for(name, {case_file.parent_path(), ".", version::source_data, version::installed_data});
}

FoundFile find_card(const std::string& name, const fs::path& case_file)
{
  if (name.ends_with(".toml")) return look_for(name, {case_file.parent_path(), "."});
  // A name, not a path: it must not lead out of the folders of cards.
  const bool plain = !name.empty() && name.find('/') == std::string::npos;
  if (plain) {
    FoundFile found = look_for(name + ".toml", card_folders(case_file));
    if (found.problem.empty()) return found;
  }
  std::vector<std::string> names;
  for (const fs::path& folder : card_folders(case_file)) {
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
      if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  if (names.empty()) return {{}, "is not a card; there are none"};
  const std::string near = nearest(name, names);
  if (names.size() == 1 && !near.empty()) return {{}, "is not a card" + did_you_mean(near)};
  return {{},
          fmt::format("is not a card; there {} {}{}", names.size() == 1 ? "is" : "are", listed(names, "and"),
                      did_you_mean(near))};
}

bool is_own_card(const fs::path& card)
{
  const std::vector<fs::path> folders = card_folders({});
  std::error_code ignored;
  return std::any_of(folders.begin() + 2, folders.end(), [&](const fs::path& folder) {
    return fs::equivalent(folder / card.filename(), card, ignored);
  });
}

} // namespace towform
