#include "study_command.hpp"
#include "case/document_json.hpp"
#include "case/text_file.hpp"
#include "towform/error.hpp"
#include "version.hpp"
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <unistd.h>

namespace towform {

namespace fs = std::filesystem;

namespace {

struct StudyArguments {
  std::string study, directory, profile;
  int jobs = 0;
  bool force = false, retry = false, dry_run = false, quiet = false, places = false;

  /// What the package takes, after the paths of the program and of the study.
  [[nodiscard]] std::vector<std::string> given() const
  {
    std::vector<std::string> words;
    const auto add = [&](const char* name, const std::string& value) {
      if (!value.empty()) words.insert(words.end(), {name, value});
    };
    add("--output", directory);
    add("--profile", profile);
    add("--jobs", jobs > 0 ? std::to_string(jobs) : "");
    if (force) words.emplace_back("--force");
    if (retry) words.emplace_back("--retry-failed");
    if (dry_run) words.emplace_back("--dry-run");
    if (quiet) words.emplace_back("--quiet");
    return words;
  }
};

fs::path own_path()
{
  std::error_code error;
  fs::path path = fs::read_symlink("/proc/self/exe", error);
  if (error) throw FileError("cannot tell where this program is: " + error.message());
  return path;
}

/// The folder that holds the package: beside an installed program, else where this one was built from.
fs::path tools_folder(const fs::path& program)
{
  const std::vector<fs::path> folders = {program.parent_path() / ".." / "share" / "towform" / "tools",
                                         fs::path(version::source_data) / "tools",
                                         fs::path(version::installed_data) / "tools"};
  std::string places;
  for (const fs::path& folder : folders) {
    std::error_code ignored;
    if (fs::exists(folder / "study" / "__main__.py", ignored)) return folder.lexically_normal();
    places += "\n  " + folder.lexically_normal().string();
  }
  throw FileError("the Python package `study` of towform is not there; looked in" + places);
}

/// Replaces this process, so that signals reach the study itself.
void study(const StudyArguments& a)
{
  if (a.places) {
    fmt::print("{}\n", document_json(parse_document(read_text(a.study, "study file"), a.study)));
    return;
  }
  const fs::path program = own_path(), tools = tools_folder(program);
  const char* search = std::getenv("PYTHONPATH");
  const std::string path =
      search == nullptr || *search == '\0' ? tools.string() : tools.string() + ":" + search;
  ::setenv("PYTHONPATH", path.c_str(), 1);
  std::vector<std::string> words = {"/usr/bin/python3", "-B", "-m", "study", program.string(), a.study};
  for (std::string& word : a.given()) words.push_back(std::move(word));
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  ::execv(argv[0], argv.data());
  throw FileError(fmt::format("{}: cannot be started: {}; studies need the Debian package python3", argv[0],
                              std::strerror(errno)));
}

} // namespace

void add_study_command(CLI::App& app)
{
  CLI::App* command = app.add_subcommand(
      "study", "many runs of a case: parameters varied, responses gathered, sensitivities, the best of them");
  auto a = std::make_shared<StudyArguments>();
  command->footer(
      "The same command goes on with a study that was stopped; a run that has ended is not run again.\n"
      "docs/studies.md explains the study file; cases/studies/ has some to copy.");
  command->add_option("study", a->study, "study file (TOML)")->required()->type_name("STUDY.toml");
  command->add_option("-o,--output", a->directory, "directory of the study (default: out/<study name>)");
  command
      ->add_option("--profile", a->profile,
                   "where runs run, in place of this machine: slurm, or a folder with a profile of Snakemake")
      ->type_name("NAME");
  command
      ->add_option("--jobs", a->jobs,
                   "runs at the same time (default: cores over threads; 100 with a profile)")
      ->check(CLI::Range(1, 100000));
  command->add_flag("--force", a->force,
                    "let go of earlier runs of the directory that the study no longer has");
  command->add_flag("--retry-failed", a->retry, "run again what has failed");
  command->add_flag("--dry-run", a->dry_run, "check every case and say what there is to do, no more");
  command->add_flag("--quiet", a->quiet, "print nothing but errors");
  command->add_flag("--places", a->places, "print the file as JSON, with places")->group("");
  command->callback([a] { study(*a); });
}

} // namespace towform
