// SPDX-License-Identifier: MIT
// pabd validate: published numbers against what this program gives.
#include <fmt/format.h>

#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>

#include "app/cli/common.h"
#include "app/cli/help_text.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/cli/streams.h"
#include "app/plots/figure.h"
#include "app/validate/validate.h"
#include "sim/base/error.h"

namespace pabd::cli {
namespace {

struct ValidateOptions {
  CommonOptions common;
  std::vector<std::string> only;
  std::string json, figures;
  bool list = false, markdown = false, force = false;
};

int list_cases(const std::vector<const validate::Case*>& cases) {
  std::size_t width = 3;
  for (const validate::Case* one : cases) width = std::max(width, one->key.size());
  std::string text = fmt::format("{:<{}}  what\n", "key", width);
  for (const validate::Case* one : cases) text += fmt::format("{:<{}}  {}\n", one->key, width, one->what);
  write_stdout(text);
  return 0;
}

// Where its figure goes.
std::filesystem::path figure_file(const ValidateOptions& options, const validate::Case& of) {
  return std::filesystem::path(options.figures) / (of.key + ".svg");
}

void check_figures(const ValidateOptions& options, const std::vector<const validate::Case*>& cases) {
  if (options.figures.empty() || options.force) return;
  for (const validate::Case* one : cases) {
    if (std::filesystem::exists(figure_file(options, *one)))
      throw Error(ErrorKind::exists, fmt::format("--figures {}: '{}.svg' exists; --force replaces it",
                                                 options.figures, one->key));
  }
}

void write_figures(const ValidateOptions& options, const std::vector<const validate::Case*>& cases,
                   const std::vector<validate::Row>& rows) {
  for (const validate::Case* one : cases) {
    const Figure figure = validate::figure_of(*one, rows);
    if (figure.plots.empty()) continue;
    AtomicFile file(figure_file(options, *one));
    file.write(figure_to_svg(figure, 900, 560));
    file.commit();
  }
}

std::vector<validate::Row> run(const ValidateOptions& options,
                               const std::vector<const validate::Case*>& cases,
                               const InterruptGuard& interrupt) {
  std::int64_t total = 0, done = 0;
  for (const validate::Case* one : cases) total += static_cast<std::int64_t>(one->steps.size());
  Progress progress("row", total, !options.common.quiet);
  std::mutex mutex;
  return validate::run_cases(
      cases, options.common.thread_count(), [&] { return interrupt.requested(); },
      [&](const validate::Row& row) {
        const std::lock_guard lock(mutex);
        progress.update(++done, row.of->key);
      });
}

int validate_all(const ValidateOptions& options) {
  const auto cases = validate::chosen_cases(options.only);
  if (options.list) return list_cases(cases);
  check_figures(options, cases);
  std::optional<TextOutput> json;
  if (!options.json.empty()) json.emplace("--json", options.json, options.force);
  const InterruptGuard interrupt;
  const std::vector<validate::Row> rows = run(options, cases, interrupt);
  if (interrupt.requested()) return interrupt.exit_code();
  if (options.json != "-")
    write_stdout(options.markdown ? validate::markdown_of(rows) : validate::table_of(rows));
  if (json) {
    json->write(json_text(validate::json_of(rows)));
    json->finish();
  }
  if (!options.figures.empty()) write_figures(options, cases, rows);
  std::string failed;
  const validate::Case* last = nullptr;
  for (const validate::Row& row : rows) {
    if (row.passes() || row.of == last) continue;
    failed += (failed.empty() ? "" : ", ") + row.of->key;
    last = row.of;
  }
  if (!failed.empty())
    throw Error(ErrorKind::images_differ,
                "validate: these are farther from what is published than they may be: " + failed);
  return 0;
}

}  // namespace

void add_validate_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<ValidateOptions>();
  const Command command(
      app, "validate",
      "compare this program with published numbers: pendulums, tops, mechanisms, friction, impacts",
      {"pabd validate", "pabd validate --list", "pabd validate --only pendulum roll --figures figures",
       "pabd validate --json - > validate.json"},
      options->common);
  using namespace group;
  command.option(kSimulation, "--only", options->only,
                 "cases whose key has one of these words in it (default: all)", "WORD");
  auto* list = command.flag(kOwn, "--list", options->list, "name the cases, and run none");
  command.flag(kOutput, "--markdown", options->markdown, "the table as Markdown, for a report")
      ->excludes(list);
  command
      .option(kOutput, "--json", options->json,
              "write the rows as JSON; -: to standard output in place of the table", "JSON")
      ->excludes(list);
  command
      .option(kOutput, "--figures", options->figures,
              "write a figure a case into this folder: ours over what is published", "DIR")
      ->excludes(list);
  command.force(options->force);
  command.threads(options->common.threads, "for cases side by side (default: all CPUs)");
  command.carry_out(action, options, validate_all);
}

}  // namespace pabd::cli
