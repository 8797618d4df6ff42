// SPDX-License-Identifier: MIT
// See collect_report.h.
#include "app/sweep/collect_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/plots/axis_ticks.h"
#include "app/plots/markup.h"
#include "app/plots/rich_text.h"

namespace pabd {
namespace {

constexpr std::size_t kMostRows = 2000;  // of the table; table.csv has all

constexpr std::string_view kHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'">
<meta name="generator" content="pabd">
)";

constexpr std::string_view kStyle = R"(<style>
:root { --text: #1f2933; --muted: #5f6b78; --line: #d9dfe5; --paper: #fff; --band: #f5f7f9; }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 24px; max-width: 1240px; color: var(--text); background: var(--paper);
  font: 15px/1.5 "DejaVu Sans", "Segoe UI", "Helvetica Neue", Arial, sans-serif; overflow-wrap: anywhere; }
h1 { font-size: 24px; margin: 0 0 4px; } h2 { font-size: 18px; margin: 36px 0 10px; }
p { margin: 6px 0; } .muted { color: var(--muted); }
ul { margin: 6px 0; padding-left: 22px; } li { margin: 5px 0; }
.best { border-left: 4px solid #1e9373; padding: 8px 14px; background: var(--band); margin: 10px 0; }
.notes { border-left: 4px solid #cc5533; padding: 4px 14px; background: var(--band); margin: 12px 0; }
figure { margin: 14px 0 22px; } figcaption { color: var(--muted); margin-bottom: 4px; }
img { max-width: 100%; height: auto; display: block; border: 1px solid var(--line); }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 540px), 1fr)); gap: 0 20px; }
.wide { overflow-x: auto; } table { border-collapse: collapse; font-size: 13px; overflow-wrap: normal; }
th, td { padding: 4px 10px; border-bottom: 1px solid var(--line); text-align: right; white-space: nowrap; }
th { position: sticky; top: 0; background: var(--band); } td.word, th.word { text-align: left; }
td.why { white-space: normal; min-width: 16em; text-align: left; }
tr.front td { background: #eaf5f0; } tr.bad td { color: #8c3216; }
.unit { color: var(--muted); font-weight: normal; } code { font-size: 12px; }
@media print { body { max-width: none; padding: 0; } .wide { overflow: visible; } }
</style>
)";

// Rich text of the program or of a file, as plain text in HTML.
std::string plain(const std::string& rich) { return escape_markup(plain_text(rich)); }

std::string figure(const ReportPicture& picture) {
  const std::string title = escape_markup(picture.title);
  return fmt::format(
      "<figure><figcaption>{0}</figcaption><img alt=\"{0}\" width=\"{1}\" "
      "src=\"data:{2};base64,{3}\"></figure>\n",
      title, picture.width, picture.type, base64(picture.bytes));
}

std::string section(const char* title, const std::vector<ReportPicture>& pictures, const char* words) {
  if (pictures.empty()) return {};
  std::string out = fmt::format("<h2>{}</h2>\n<p class=\"muted\">{}</p>\n", title, words);
  if (pictures.size() > 1 && pictures.front().width <= 1100) out += "<div class=\"pictures\">\n";
  const bool grid = out.ends_with("\"pictures\">\n");
  for (const ReportPicture& picture : pictures) out += figure(picture);
  return out + (grid ? "</div>\n" : "");
}

std::string heading(const std::string& words, const std::string& unit, bool word) {
  return fmt::format("<th{}>{}{}</th>", word ? " class=\"word\"" : "", plain(words),
                     unit.empty() ? "" : fmt::format(" <span class=\"unit\">{}</span>", escape_markup(unit)));
}

std::string number(const std::optional<double>& value) { return value ? format_value(*value, 4) : ""; }

std::string row(const CollectedSweep& sweep, const SweptTask& task, bool front, bool timed, bool whys) {
  const bool bad = task.status != SweptStatus::done;
  std::string out = fmt::format("<tr{} title=\"{}\">",
                                bad     ? " class=\"bad\""
                                : front ? " class=\"front\""
                                        : "",
                                escape_markup(view_command(sweep, task)));
  out += fmt::format("<td>{}</td>", task.index < 0 ? "" : std::to_string(task.index));
  for (const SweptValue& value : task.parameters) {
    out += fmt::format("<td>{}</td>", value.number ? number(value.number) : escape_markup(value.text));
  }
  out += fmt::format("<td class=\"word\">{}</td>", status_word(task.status));
  for (const auto& metric : task.metrics) out += fmt::format("<td>{}</td>", number(metric));
  if (timed) {
    out += fmt::format("<td>{}</td><td>{}</td>", number(task.timing ? task.timing->step_time : std::nullopt),
                       number(task.timing ? std::optional(task.timing->seconds) : std::nullopt));
  }
  out += fmt::format("<td class=\"word\"><code>{}</code></td>", escape_markup(task.hash));
  if (whys)
    out += fmt::format("<td class=\"why\">{}</td>", escape_markup(task.why.empty() ? task.faults : task.why));
  return out + "</tr>\n";
}

std::string table(const CollectedSweep& sweep, const Ranking& ranking) {
  const auto any = [&](auto&& has) { return std::any_of(sweep.tasks.begin(), sweep.tasks.end(), has); };
  const bool timed = any([](const SweptTask& t) { return t.timing.has_value(); });
  const bool whys = any([](const SweptTask& t) { return !t.why.empty() || !t.faults.empty(); });
  std::vector<bool> front(sweep.tasks.size());
  for (const Ranked& one : ranking.front) front[one.task] = true;
  std::string out = "<div class=\"wide\"><table>\n<thead><tr><th>task</th>";
  for (const SweptQuantity& p : sweep.parameters) out += heading(p.words, p.unit, false);
  out += heading("status", "", true);
  for (const SweptQuantity& m : sweep.metrics) out += heading(m.words, m.unit, false);
  if (timed) out += heading("time a step", "ms", false) + heading("wall clock", "s", false);
  out += heading("folder", "", true);
  if (whys) out += heading("why", "", true);
  out += "</tr></thead>\n<tbody>\n";
  const std::size_t rows = std::min(kMostRows, sweep.tasks.size());
  for (std::size_t i = 0; i < rows; ++i) out += row(sweep, sweep.tasks[i], front[i], timed, whys);
  out += "</tbody>\n</table></div>\n";
  if (rows < sweep.tasks.size())
    out += fmt::format("<p class=\"muted\">{} more rows are in table.csv.</p>\n", sweep.tasks.size() - rows);
  return out;
}

std::string ranking_part(const CollectedSweep& sweep, const Ranking& ranking) {
  const bool none = ranking.compared == 0 && ranking.unacceptable > 0;
  std::string out = none ? "<h2>None is acceptable</h2>\n" : "<h2>Which is best</h2>\n";
  const std::string command =
      ranking.front.empty() ? "" : view_command(sweep, sweep.tasks[ranking.front.front().task]);
  out += fmt::format("<p class=\"{}\">{}{}</p>\n<p class=\"muted\">{}</p>\n<ul>\n", none ? "notes" : "best",
                     plain(ranking.sentences.back()),
                     command.empty() ? "" : "<br><code>" + escape_markup(command) + "</code>",
                     escape_markup(sweep.accept));
  for (std::size_t i = 0; i + 1 < ranking.sentences.size(); ++i)
    out += fmt::format("<li>{}</li>\n", plain(ranking.sentences[i]));
  return out + "</ul>\n";
}

}  // namespace

std::string report_html(const CollectedSweep& sweep, const Ranking& ranking, const Report& report) {
  const std::string title = escape_markup(sweep.title);
  std::string out(kHead);
  out += fmt::format("<title>{}: sweep</title>\n", title);
  out += kStyle;
  out += fmt::format("</head>\n<body>\n<h1>{}</h1>\n<p class=\"muted\">{}{}</p>\n", title,
                     sweep.scene.empty() ? "" : fmt::format("Scene {}. ", escape_markup(sweep.scene)),
                     plain(counts_words(sweep)));
  if (!sweep.notes.empty() || !report.notes.empty()) {
    out += "<div class=\"notes\"><ul>\n";
    for (const auto* notes : {&sweep.notes, &report.notes}) {
      for (const std::string& note : *notes) out += fmt::format("<li>{}</li>\n", escape_markup(note));
    }
    out += "</ul></div>\n";
  }
  out += ranking_part(sweep, ranking);
  out += section("How they end", report.sheets,
                 "The last state of every task; the number in the corner is its index.");
  out += section("Error against time", report.plots, "Less is better in both directions.");
  out += section("Over the parameters", report.maps, "Light is much, dark is little.");
  out +=
      "<h2>All tasks</h2>\n<p class=\"muted\">Green: no other task is at most as much in every metric and "
      "less in one.</p>\n";
  out += table(sweep, ranking);
  return out + "</body>\n</html>\n";
}

}  // namespace pabd
