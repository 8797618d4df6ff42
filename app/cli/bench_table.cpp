// SPDX-License-Identifier: MIT
// See bench_table.h.
#include "app/cli/bench_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "sim/base/counted.h"
#include "sim/scene/text.h"

namespace pabd::cli {
namespace {

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) /
         static_cast<double>(std::max<std::size_t>(values.size(), 1));
}

// A name as a cell: nothing in it ends the cell or the line.
std::string cell(const std::string& name) {
  std::string out;
  for (const char c : printable(name)) out += c == '|' ? std::string("\\|") : std::string(1, c);
  return out;
}

// The name alone where all steps have the same.
std::string solver_text(const StepCounts& counts) {
  return counts.size() == 1 ? counts.front().first : to_text(counts);
}

// "on a GPU: NVIDIA H200", with the scenes where not all are; a line of the head.
std::string device_line(const std::vector<BenchRow>& rows) {
  std::string device, scenes;
  bool all = true;
  for (const BenchRow& row : rows) {
    if (row.device == "cpu") {
      all = false;
      continue;
    }
    device = row.device;
    scenes += (scenes.empty() ? "" : ", ") + printable(row.scene);
  }
  if (device.empty()) return "";
  return fmt::format("  \nsteps by {}{}", printable(device), all ? "" : ": " + scenes);
}

std::string name_of(const BenchRow& row) {
  return row.asked.empty() ? cell(row.scene) : fmt::format("{}, {}", cell(row.scene), row.asked);
}

std::string table_row(const BenchRow& row) {
  const StepStatistics& s = row.statistics;
  return fmt::format(
      "| {} | {} | {} | {} | {} | {:.4g} | {:.4g} | {:.1f} | {:.0f} | {:.3g} | {} | {:.3g} | {} |\n",
      name_of(row), row.bodies, row.joints, solver_text(s.solvers()), s.steps, median(row.wall_ms),
      median(row.cpu_ms), s.iterations_a_step(), s.contacts_a_step(), 1e3 * s.max_penetration,
      row.joints > 0 ? fmt::format("{:.2g}", s.max_joint_error) : "–", row.kinetic, to_text(s.outcomes()));
}

}  // namespace

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return values.size() % 2 == 1 ? *middle : (*middle + *std::max_element(values.begin(), middle)) / 2;
}

std::string bench_markdown(const BenchHead& head, const std::vector<BenchRow>& rows) {
  // Two blanks at the end of a line break it.
  std::string text = fmt::format(
      "pabd {}, {}, {}, {}  \n{}, load {}{}  \n{}\n\n", PABD_VERSION, head.date,
      counted(head.threads, "thread"), counted(head.repeat, "repetition"), describe(head.cpu),
      head.load < 0 ? "unknown" : fmt::format("{:.1f}", head.load), device_line(rows), build_text());
  text +=
      "| scene | bodies | joints | solver | steps | ms/step | CPU ms/step | iterations a step | contacts | "
      "largest overlap, mm | largest joint error, m | kinetic energy at the end, J | status |\n"
      "|---|--:|--:|---|--:|--:|--:|--:|--:|--:|--:|--:|---|\n";
  for (const BenchRow& row : rows) text += table_row(row);
  return text;
}

std::string choice_markdown(const std::vector<BenchRow>& rows) {
  std::string text =
      "\n| scene | auto, mean CPU ms/step | descent | newton | auto / the cheaper |\n|---|--:|--:|--:|--:|\n";
  const auto cost = [&](const BenchRow& of, std::string_view solver) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const BenchRow& other) {
      return other.scene == of.scene && other.asked == solver;
    });
    return row == rows.end() ? std::numeric_limits<double>::quiet_NaN() : mean(row->cpu_ms);
  };
  for (const BenchRow& row : rows) {
    if (row.asked != "auto") continue;
    const double own = cost(row, "auto"), descent = cost(row, "descent"), newton = cost(row, "newton");
    text += fmt::format("| {} | {:.4g} | {:.4g} | {:.4g} | {:.2f} |\n", cell(row.scene), own, descent, newton,
                        own / std::fmin(descent, newton));
  }
  return text;
}

nlohmann::ordered_json bench_json(const BenchHead& head, const std::vector<BenchRow>& rows) {
  auto scenes = nlohmann::ordered_json::array();
  for (const BenchRow& row : rows) {
    const StepStatistics& s = row.statistics;
    scenes.push_back({{"scene", row.scene},
                      {"bodies", row.bodies},
                      {"joints", row.joints},
                      {"device", row.device},
                      {"steps", s.steps},
                      {"solver", to_json(s.solvers())},
                      {"status", to_json(s.outcomes())},
                      {"median_ms", median(row.wall_ms)},
                      {"mean_ms", mean(row.wall_ms)},
                      {"median_cpu_ms", median(row.cpu_ms)},
                      {"mean_cpu_ms", mean(row.cpu_ms)},
                      {"iterations_a_step", s.iterations_a_step()},
                      {"contacts_a_step", s.contacts_a_step()},
                      {"max_penetration", s.max_penetration},
                      {"max_joint_error", s.max_joint_error},
                      {"kinetic", row.kinetic},
                      {"state", row.hash}});
    if (!row.asked.empty()) scenes.back()["asked"] = row.asked;
  }
  return {{"version", PABD_VERSION},
          {"date", head.date},
          {"build", build_text()},
          {"cpu", to_json(head.cpu)},
          {"load", head.load < 0 ? nlohmann::ordered_json() : nlohmann::ordered_json(head.load)},
          {"threads", head.threads},
          {"repeat", head.repeat},
          {"scenes", scenes}};
}

}  // namespace pabd::cli
