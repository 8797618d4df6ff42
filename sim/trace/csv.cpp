// The two CSV files of a run. Numbers have as many digits as it takes to read back the same bits. See
// trace.h.
#include <fmt/format.h>

#include <iterator>

#include "sim/trace/trace.h"

namespace pabd {

namespace {

void put(std::ostream& out, const fmt::memory_buffer& line) {
  out.write(line.data(), static_cast<std::streamsize>(line.size()));
}

}  // namespace

void write_steps_header(std::ostream& out) {
  out << "step,time,method,status,iterations,kinetic,potential,elastic,contacts,max_penetration,min_gap,max_"
         "joint_error,"
         "residual,step_ms\n";
}

void write_steps_row(std::ostream& out, const StepReport& r) {
  fmt::memory_buffer line;
  fmt::format_to(std::back_inserter(line), "{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", r.step, r.time,
                 to_string(r.method), to_string(r.status), r.iterations, r.kinetic, r.potential, r.elastic,
                 r.contacts, r.max_penetration, r.min_gap, r.max_joint_error, r.residual, r.times.total);
  put(out, line);
}

void write_iterations_header(std::ostream& out) {
  out << "step,iteration,energy,residual,max_penetration_before,max_penetration_after,max_joint_error,"
         "projection_change\n";
}

void write_iterations_rows(std::ostream& out, const StepReport& report) {
  fmt::memory_buffer line;
  int iteration = 0;
  for (const IterationRecord& i : report.records) {
    fmt::format_to(std::back_inserter(line), "{},{},{},{},{},{},{},{}\n", report.step, ++iteration, i.energy,
                   i.residual, i.max_penetration_before, i.max_penetration_after, i.max_joint_error,
                   i.projection_change);
  }
  put(out, line);
}

}  // namespace pabd
