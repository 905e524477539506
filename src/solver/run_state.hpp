#pragma once
#include "output/field_visitor.hpp"
#include "solver/gates.hpp"
#include "solver/model.hpp"
#include "solver/phases.hpp"
#include "solver/statics.hpp"
#include "towform/results.hpp"

namespace towform {

/// What a recorder remembers from row to row and from frame to frame.
struct Record {
  Summary summary;
  std::int64_t frames = 0, rows = 0; ///< written so far
  DeepestContact deepest;            ///< since the last row
  int iterations = 0;                ///< of Newton's method since the last row
};

/// Equal steps towards the next output.
struct Stride {
  double dt = 0.0;             ///< [s]
  std::int64_t steps_left = 0; ///< before the next look or output
  bool arrives = false;        ///< the last of them is at the output's time
};

/// The stable step as last looked at, and when.
struct KnownStep {
  double step = 0.0;    ///< [s]
  std::int64_t at = -1; ///< after so many steps; -1: not yet
};

/// All that changes while an explicit run goes on, between two steps: the same state goes on to the same
/// bits.
struct RunState {
  System system;
  StepLook look; ///< when the stable step was last measured
  KnownStep known;
  Stride stride;
  std::int64_t event = 0;       ///< the next output of the case, from 0
  std::int64_t last_output = 0; ///< the step of the last
  Record record;
  Phases phases;
};

/// The same of a quasi-static run, between two increments.
struct StaticsRunState {
  StaticsState sheet;
  double next_increment = 0.0; ///< wanted length [s]
  std::int64_t event = 0;
  Record record;
  double output = 0.0, stepping = 0.0; ///< wall time [s]
};

/// Shows every member to the visitor. Each function takes its struct apart into as many names as it has
/// members: one that is added to the struct and not here does not compile.
void visit(FieldVisitor& v, State& s);
void visit(FieldVisitor& v, BendingState& s);
void visit(FieldVisitor& v, PressureState& s);
void visit(FieldVisitor& v, ToolState& s);
void visit(FieldVisitor& v, ContactState& s);
void visit(FieldVisitor& v, BoundaryState& s);
void visit(FieldVisitor& v, System& s);
void visit(FieldVisitor& v, StaticsState& s);
void visit(FieldVisitor& v, Summary& s);
void visit(FieldVisitor& v, Record& s);
void visit(FieldVisitor& v, RunState& s);
void visit(FieldVisitor& v, StaticsRunState& s);

} // namespace towform
