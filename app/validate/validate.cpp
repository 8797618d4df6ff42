// SPDX-License-Identifier: MIT
#include "app/validate/validate.h"

#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "sim/base/error.h"
#include "sim/math/team.h"

namespace pabd::validate {

extern const char kCasesText[];  // cases.md, made part of the program by CMakeLists.txt

namespace {

std::string step_text(double h) {
  const double rate = 1 / h;
  return rate < 10000 ? fmt::format("1/{:.0f}", rate) : fmt::format("{:.3g}", h);
}

std::string unit_text(const std::string& unit) { return unit == "1" ? "" : " " + unit; }

std::string value_text(const Row& row) {
  return row.failure.empty() ? fmt::format("{:.7g}", row.outcome.value) : "none: " + row.failure;
}

std::string error_text(const Row& row) {
  return row.failure.empty() ? fmt::format("{:.1e}", row.error()) : "";
}

// "a", "b" of "a | b |".
std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  std::istringstream in(row);
  for (std::string cell; std::getline(in, cell, '|');) {
    const auto first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
    cells.push_back(first == cell.npos ? "" : cell.substr(first, last + 1 - first));
  }
  return cells;
}

// "1/60: 0.003, 1/240: 5e-4".
std::vector<Tolerance> tolerances_of(const std::string& text) {
  std::vector<Tolerance> out;
  std::istringstream in(text);
  for (std::string one; std::getline(in, one, ',');) {
    const std::size_t colon = one.find(':'), slash = one.find('/');
    const double h = slash == one.npos ? std::stod(one) : 1 / std::stod(one.substr(slash + 1));
    out.push_back({h, std::stod(one.substr(colon + 1))});
  }
  return out;
}

// What cases.md says of a case.
void describe(Case& one) {
  const std::string_view table = kCasesText;
  const auto at = table.find("\n| " + one.key + " |");
  if (at == table.npos) throw std::logic_error("cases.md has no row " + one.key);
  const auto cells = cells_of(std::string(table.substr(at + 3, table.find('\n', at + 1) - at - 3)));
  one.what = cells.at(1);
  one.unit = cells.at(2);
  one.source = cells.at(3);
  one.steps = tolerances_of(cells.at(4));
  one.x_label = cells.at(5);
  one.y_label = cells.at(6);
}

}  // namespace

const std::vector<Case>& all_cases() {
  static const std::vector<Case> cases = [] {
    std::vector<Case> all;
    for (const auto add : {add_pendulums, add_spins, add_linkages, add_rolling, add_contacts, add_structures})
      add(all);
    for (Case& one : all) describe(one);
    return all;
  }();
  return cases;
}

std::vector<const Case*> chosen_cases(const std::vector<std::string>& words) {
  std::vector<const Case*> chosen;
  const auto has = [](const Case& one, const std::string& word) {
    return one.key.find(word) != std::string::npos;
  };
  for (const std::string& word : words) {
    if (std::none_of(all_cases().begin(), all_cases().end(), [&](const Case& one) { return has(one, word); }))
      throw Error(
          ErrorKind::bad_input,
          fmt::format("--only {}: no case has that in its key; 'pabd validate --list' names them", word));
  }
  for (const Case& one : all_cases()) {
    if (words.empty() ||
        std::any_of(words.begin(), words.end(), [&](const std::string& word) { return has(one, word); }))
      chosen.push_back(&one);
  }
  return chosen;
}

bool Row::passes() const { return failure.empty() && std::abs(error()) <= margin; }

std::vector<Row> run_cases(const std::vector<const Case*>& cases, int threads,
                           const std::function<bool()>& stop, const std::function<void(const Row&)>& done) {
  std::vector<Row> rows;
  for (const Case* one : cases)
    for (const Tolerance& step : one->steps) rows.push_back({one, step.h, step.margin, {}, {}});
  std::atomic<bool> stopped = false;
  Team team;
  team.for_each_large(threads, rows.size(), true, [&](std::size_t k) {
    if (stopped) return;
    Row& row = rows[k];
    try {
      Bench bench(row.h, stop);
      row.outcome = row.of->measure(bench);
      if (done) done(row);
    } catch (const Stopped&) {
      stopped = true;
    } catch (const Error& error) {
      row.failure = error.what();
    }
  });
  if (stopped) rows.clear();
  return rows;
}

std::string table_of(const std::vector<Row>& rows) {
  std::string text;
  const Case* last = nullptr;
  for (const Row& row : rows) {
    if (row.of != last)
      text += fmt::format("{}: {}\n  {}{}  ({})\n", row.of->key, row.of->what,
                          fmt::format("{:.7g}", row.of->published), unit_text(row.of->unit), row.of->source);
    last = row.of;
    text += fmt::format("    h = {:<8} {:>14}  off by {:>8}, may be {:.1e}  {}\n", step_text(row.h) + " s",
                        value_text(row), error_text(row), row.margin, row.passes() ? "passes" : "FAILS");
  }
  const auto failed = std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.passes(); });
  text += fmt::format("{} of {} rows pass\n", rows.size() - static_cast<std::size_t>(failed), rows.size());
  return text;
}

std::string markdown_of(const std::vector<Row>& rows) {
  std::string text =
      "| what | published | h, s | here | off by | may be | |\n|---|--:|--:|--:|--:|--:|---|\n";
  const Case* last = nullptr;
  for (const Row& row : rows) {
    if (row.of != last)
      text += fmt::format("| {} ({}) | {:.7g}{} |", row.of->what, row.of->source, row.of->published,
                          unit_text(row.of->unit));
    else
      text += "| | |";
    last = row.of;
    text += fmt::format(" {} | {} | {} | {:.1e} | {} |\n", step_text(row.h), value_text(row), error_text(row),
                        row.margin, row.passes() ? "" : "**fails**");
  }
  return text;
}

nlohmann::ordered_json json_of(const std::vector<Row>& rows) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Row& row : rows) {
    nlohmann::ordered_json one{
        {"key", row.of->key},      {"what", row.of->what},           {"source", row.of->source},
        {"unit", row.of->unit},    {"published", row.of->published}, {"time_step", row.h},
        {"tolerance", row.margin}, {"passes", row.passes()}};
    if (row.failure.empty()) {
      one["value"] = row.outcome.value;
      one["error"] = row.error();
    } else {
      one["failure"] = row.failure;
    }
    list.push_back(std::move(one));
  }
  return list;
}

Figure figure_of(const Case& of, const std::vector<Row>& rows) {
  Plot plot;
  plot.x.label = of.x_label;
  plot.y.label = of.y_label;
  const auto add = [&](const std::string& name, const std::vector<double>& x, const std::vector<double>& y) {
    Series& curve = plot.series.emplace_back();
    curve.name = name;
    curve.x = x;
    curve.y = y;
  };
  const Outcome* finest = nullptr;
  for (const Row& row : rows) {
    if (row.of != &of || row.outcome.ours.empty()) continue;
    add("h = " + step_text(row.h) + " s", row.outcome.x, row.outcome.ours);
    finest = &row.outcome;
  }
  if (!finest) return {};
  if (!finest->published.empty()) {
    add("published", finest->x, finest->published);
    plot.series.back().style = SeriesStyle::dashed;
  }
  return {of.what, of.source, {plot}, 1};
}

}  // namespace pabd::validate
