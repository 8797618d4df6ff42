// States and reports as bytes: parts of a recording. Reading checks everything.
#pragma once

#include "app/session/byte_stream.h"
#include "sim/body/state.h"
#include "sim/solver/report.h"

namespace pabd {

void write_state(const State& state, ByteWriter& out);
// Throws Error(bad_input) when it is no state of so many bodies.
State read_state(ByteReader& in, Index bodies);

// Without its vectors.
void write_report(const StepReport& report, ByteWriter& out);
StepReport read_report(ByteReader& in);

}  // namespace pabd
