#include "solver/session.hpp"
#include "towform/shear_law.hpp"
#include <fmt/format.h>

namespace towform {

namespace {

std::unique_ptr<OutputDirectory> hold(const std::filesystem::path& directory)
{
  std::error_code ignored;
  if (!std::filesystem::is_directory(directory, ignored))
    throw FileError(fmt::format("{}: there is no such directory", directory.string()));
  return std::make_unique<OutputDirectory>(directory);
}

/// The law of the program that goes on with a run.
void bring_law(Case& c, const std::shared_ptr<const ShearLaw>& law, const std::filesystem::path& directory)
{
  const std::string words = c.material.own_law_words;
  if (law->description() != words)
    throw CheckpointError(
        fmt::format("{}: the run has {}, not the law that was brought: {}", directory.string(),
                    words.empty() ? "no law of a program" : "the law " + words, law->description()));
  use_law(c, law);
}

} // namespace

Session::Session(const Case& c, const RunOptions& options)
    : c_(c), options_(options), resumes_(false), start_(std::chrono::steady_clock::now())
{
  if (!options.force) refuse_earlier_results(options.directory);
  origin_ = origin_of(c);
}

Session::Session(const RunOptions& options)
    : options_(options), resumes_(true), held_(hold(options.directory)),
      start_(std::chrono::steady_clock::now())
{
  StartedRun started = started_run(options.directory);
  c_ = std::move(started.c);
  origin_ = std::move(started.origin);
  if (options.law) bring_law(c_, options.law, options.directory);
}

void Session::begin(Record& record, std::function<void(FieldVisitor&)> state)
{
  state_ = std::move(state);
  record_ = &record;
  std::vector<std::string> lines;
  if (resumes_) {
    lines = read_checkpoint(options_.directory, origin_, state_);
    const CheckpointOrigin here = origin_of(c_);
    origin_.version = here.version;
    origin_.git_hash = here.git_hash;
  } else {
    held_ = std::make_unique<OutputDirectory>(options_.directory);
    if (!options_.force) refuse_earlier_results(options_.directory);
    remove_checkpoints(options_.directory);
  }
  wall_before_ = record.summary.wall_time_s;
  const ProgressStyle style = options_.json_progress ? ProgressStyle::json
                              : options_.quiet       ? ProgressStyle::quiet
                                                     : ProgressStyle::words;
  progress_ = std::make_unique<Progress>(options_.directory, style, resumes_);
  for (const std::string& line : lines) progress_->line(line);
  interruption_ =
      std::make_unique<Interruption>(options_.controls, c_.output.checkpoint, record.summary.steps);
}

void Session::save()
{
  account(0.0);
  write_checkpoint(options_.directory, origin_, state_);
}

bool Session::stops_after(std::int64_t step, double time)
{
  record_->summary.steps = step;
  const Due due = interruption_->look(step);
  if (due == Due::nothing) return false;
  save();
  progress_->line(fmt::format("checkpoint at t = {:.6g} ms, step {}", 1e3 * time, step));
  return due == Due::stop;
}

std::string Session::stop_message(std::int64_t step, double time) const
{
  return fmt::format("stopped by {} at t = {:.6g} ms, step {}; 'towform resume {}' goes on",
                     interruption_->reason(), 1e3 * time, step, options_.directory.string());
}

void Session::output(const std::function<void()>& write)
{
  const Record before = *record_;
  try {
    write();
  } catch (const FileError& e) {
    *record_ = before; // what was written of this output is cut back
    std::string way_out;
    try {
      if (before.frames > 0) {
        save();
        way_out = fmt::format("\nonce it can, 'towform resume {}' goes on", options_.directory.string());
      }
    } catch (const FileError&) {
      // No room for that either: the checkpoints from before are still there.
    }
    throw FileError(e.what() + way_out);
  }
}

void Session::account(double stepping)
{
  Summary& summary = record_->summary;
  summary.wall_time_s =
      wall_before_ + std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const double element_steps = static_cast<double>(summary.elements) * static_cast<double>(summary.steps);
  summary.ns_per_element_step = element_steps > 0.0 ? 1e9 * stepping / element_steps : 0.0;
}

} // namespace towform
