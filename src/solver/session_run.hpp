#pragma once
#include "solver/events.hpp"
#include "solver/session.hpp"

namespace towform {

/// The course of a run, explicit or quasi-static: outputs in their order, and how it may end.
class SessionRun {
public:
  explicit SessionRun(Session& session) : session_(session), case_(session.the_case()) {}
  SessionRun(const SessionRun&) = delete;
  SessionRun& operator=(const SessionRun&) = delete;
  virtual ~SessionRun() = default;

  RunOutcome go();

protected:
  /// Where the run is.
  struct Place {
    std::int64_t step;
    double time; ///< [s]
  };
  [[nodiscard]] virtual Place place() const = 0;
  [[nodiscard]] virtual ProgressState progress() const = 0;
  [[nodiscard]] virtual std::string headline() const = 0;
  [[nodiscard]] virtual std::string closing() const = 0;
  /// Steps up to the time of an output, or near it where that is before `aim`, to which steps are laid; false when the session is to
  /// stop.
  virtual bool advance_to(double time, double aim) = 0;
  virtual void write_history() = 0;
  virtual void write_frame() = 0;
  virtual void write_last_frame() = 0;
  virtual void written() {} ///< after each output
  /// Fills in the summary's phases; returns the wall time of the steps [s].
  virtual double phases(Summary& summary) const = 0;
  virtual void finish() = 0;

  Session& session_;
  const Case& case_;
  Record* record_ = nullptr;      ///< set by the constructors of the runs
  std::int64_t* event_ = nullptr; ///< likewise, the next output

private:
  bool all_events();
  void output(bool frame);
  void close();
};

} // namespace towform
