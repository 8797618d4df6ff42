// SPDX-License-Identifier: MIT
// The CSV files of a run. Numbers have as many digits as it takes to read back the same bits. See
// trace.h.
#include <fmt/format.h>

#include <iterator>
#include <limits>
#include <string>

#include "sim/trace/trace.h"

namespace pabd {

namespace {

void put(std::ostream& out, const fmt::memory_buffer& line) {
  out.write(line.data(), static_cast<std::streamsize>(line.size()));
}

// A name as a field: in quotes where it needs them (RFC 4180).
std::string field(const std::string& name) {
  if (name.find_first_of(",\"\n\r") == name.npos) return name;
  std::string out = "\"";
  for (const char c : name) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

}  // namespace

void write_steps_header(std::ostream& out) {
  out << "step,time,method,status,iterations,kinetic,potential,elastic,contacts,max_penetration,min_gap,max_"
         "joint_error,"
         "residual,step_ms,drive_work,capped_bonds,held_bodies,halved_bodies,halvings,friction_excess\n";
}

// A step that failed ends in no state: what a state has is not known of it, and not zero.
void write_steps_row(std::ostream& out, const StepSummary& r) {
  const bool failed = r.status == StepStatus::non_finite;
  const auto known = [failed](double x) { return failed ? std::numeric_limits<double>::quiet_NaN() : x; };
  fmt::memory_buffer line;
  fmt::format_to(std::back_inserter(line), "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                 r.step, r.time, to_string(r.method), to_string(r.status), r.iterations, known(r.kinetic),
                 known(r.potential), known(r.elastic), failed ? "nan" : std::to_string(r.contacts),
                 known(r.max_penetration), known(r.min_gap), known(r.max_joint_error),
                 r.iterations == 0 ? known(r.residual) : r.residual, r.times.total, known(r.drive_work),
                 r.capped_bonds, r.held_bodies, r.halved_bodies, r.halvings, known(r.friction_excess));
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

void write_joints_header(std::ostream& out) {
  out << "step,time,joint,name,force_x,force_y,force_z,moment_x,moment_y,moment_z,axial_force,axial_moment\n";
}

void write_joints_rows(std::ostream& out, const Model& model, const StepReport& report) {
  fmt::memory_buffer line;
  for (std::size_t k = 0; k < report.joint_reports.size(); ++k) {
    const JointReport& r = report.joint_reports[k];
    fmt::format_to(std::back_inserter(line), "{},{},{},{},{},{},{},{},{},{},{},{}\n", report.step,
                   report.time, k, field(model.joints[k].name), r.force.x(), r.force.y(), r.force.z(),
                   r.moment.x(), r.moment.y(), r.moment.z(), r.force.dot(r.axis), r.moment.dot(r.axis));
  }
  put(out, line);
}

}  // namespace pabd
