// SPDX-License-Identifier: MIT
// The CSV files of a run. Numbers have as many digits as it takes to read back the same bits. See
// trace.h.
#include <fmt/format.h>

#include <iterator>
#include <string>

#include "sim/solver/step_numbers.h"
#include "sim/trace/trace.h"

namespace pabd {

namespace {

constexpr std::size_t kBeforeWords = 2;  // step and time; then come the solver and the outcome

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
  out << "step,time,method,status";
  for (const StepNumber& number : step_numbers().subspan(kBeforeWords)) out << ',' << number.name;
  out << ',' << kStepTime << '\n';
}

// A step that failed ends in no state: what a state has is not known of it, and not zero.
void write_steps_row(std::ostream& out, const StepSummary& r) {
  const bool failed = r.status == StepStatus::non_finite;
  fmt::memory_buffer line;
  const auto add = [&](const StepNumber& number) {
    const bool known = !failed || (!number.of_end && (number.name != "residual" || r.iterations > 0));
    if (!known) return fmt::format_to(std::back_inserter(line), ",nan");
    return std::visit([&](const auto of) { return fmt::format_to(std::back_inserter(line), ",{}", r.*of); },
                      number.member);
  };
  fmt::format_to(std::back_inserter(line), "{},{},{},{}", r.step, r.time, to_string(r.method),
                 to_string(r.status));
  for (const StepNumber& number : step_numbers().subspan(kBeforeWords)) add(number);
  fmt::format_to(std::back_inserter(line), ",{}\n", r.times.total);
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
  out << "step,time,joint,name,force_x,force_y,force_z,moment_x,moment_y,moment_z,axial_force,axial_moment,"
         "error\n";
}

void write_joints_rows(std::ostream& out, const Model& model, const StepReport& report) {
  fmt::memory_buffer line;
  for (std::size_t k = 0; k < report.joint_reports.size(); ++k) {
    const JointReport& r = report.joint_reports[k];
    fmt::format_to(std::back_inserter(line), "{},{},{},{},{},{},{},{},{},{},{},{},{}\n", report.step,
                   report.time, k, field(model.joints[k].name), r.force.x(), r.force.y(), r.force.z(),
                   r.moment.x(), r.moment.y(), r.moment.z(), r.force.dot(r.axis), r.moment.dot(r.axis),
                   r.error);
  }
  put(out, line);
}

}  // namespace pabd
