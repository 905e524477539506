#include "solver/session_run.hpp"
#include <fmt/format.h>

namespace towform {

RunOutcome SessionRun::go()
{
  session_.progress().line(headline());
  if (session_.resumes())
    session_.progress().line(
        fmt::format("goes on at t = {:.6g} ms, step {}", 1e3 * place().time, place().step));
  RunOutcome outcome;
  Summary& summary = record_->summary;
  try {
    if (all_events()) {
      summary.status = "done";
    } else {
      outcome.code = ExitCode::interrupted;
      summary.status = "interrupted";
      summary.message = session_.stop_message(place().step, place().time);
      session_.progress().line(summary.message);
    }
  } catch (const RunStopped& stop) {
    outcome.code = stop.code();
    summary.status = "stopped";
    summary.message = stop.what();
    session_.progress().line(summary.message);
    write_last_frame();
  } catch (const FileError& e) {
    summary.status = "stopped";
    summary.message = e.what();
    try {
      close();
    } catch (const FileError&) {
      // What cannot be written can say nothing; the exception does.
    }
    throw;
  }
  close();
  if (outcome.code == ExitCode::done) session_.done();
  session_.progress().line(closing());
  session_.progress().end(progress(), summary.status, summary.message);
  outcome.summary = summary;
  return outcome;
}

void SessionRun::close()
{
  record_->summary.steps = place().step;
  record_->summary.simulated_time_s = place().time;
  session_.account(phases(record_->summary));
  finish();
}

bool SessionRun::all_events()
{
  if (record_->frames == 0) output(true);
  const std::vector<Event> events = events_of(case_);
  for (; *event_ < static_cast<std::int64_t>(events.size()); ++*event_) {
    const Event& event = events[static_cast<std::size_t>(*event_)];
    if (!advance_to(event.time, event.aim)) return false;
    output(event.frame);
  }
  return true;
}

void SessionRun::output(bool frame)
{
  session_.output([&] {
    write_history();
    if (frame) write_frame();
  });
  session_.progress().output(progress());
  written();
}

} // namespace towform
