// SPDX-License-Identifier: MIT
// pabd compare: are two pictures the same, up to what renderers may differ in?
#include <fmt/format.h>

#include <memory>

#include "app/cli/common.h"
#include "app/cli/exit_code.h"
#include "app/cli/streams.h"
#include "render/output/compare_images.h"
#include "render/output/compare_report.h"
#include "render/output/png.h"
#include "sim/base/error.h"

namespace pabd::cli {
namespace {

struct CompareOptions {
  CommonOptions common;
  std::string actual;
  std::string expected;
  std::string diff;
  bool json = false;
  bool force = false;
};

// GL_RENDERER of a picture, empty when it does not say.
std::string renderer_of(const std::string& path) {
  const PngText text = read_png_text(path);
  const auto entry = text.find("GL_RENDERER");
  return entry == text.end() ? "" : entry->second;
}

// Pictures of two known, different renderer classes may differ more; all others are held to the strict tier.
CompareTier tier_of(const std::string& a, const std::string& b) {
  const bool known = !a.empty() && !b.empty();
  return known && renderer_class(a) != renderer_class(b) ? CompareTier::cross_class : CompareTier::same_class;
}

int compare(const CompareOptions& options) {
  InputFiles inputs;
  inputs.add(options.actual);
  inputs.add(options.expected);
  if (!options.diff.empty())
    check_overwrite("--diff " + options.diff, options.diff, {options.force, &inputs});
  const Image actual = read_png(options.actual);
  const Image expected = read_png(options.expected);
  const CompareTier tier = tier_of(renderer_of(options.actual), renderer_of(options.expected));
  const std::string tier_name = tier == CompareTier::same_class ? "same" : "cross";
  const CompareResult result = compare_images(actual, expected, tier);
  if (!options.diff.empty()) write_png(options.diff, difference_image(actual, expected));

  if (options.json) {
    write_stdout(compare_json(result, tier, options.actual, options.expected, options.diff));
  } else if (!options.common.quiet) {
    write_stdout(result.equal ? fmt::format("equal (tier {}; largest difference {} levels)\n", tier_name,
                                            result.max_difference)
                              : fmt::format("different (tier {}): {}\n", tier_name, result.reason));
  }
  return result.equal ? kDone : exit_code(ErrorKind::images_differ);
}

}  // namespace

void add_compare_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<CompareOptions>();
  const Command command(app, "compare", "compare two PNG files; exit code 7 when they differ",
                        {"pabd compare actual.png expected.png --diff difference.png",
                         "pabd compare actual.png expected.png --json"},
                        options->common);
  command.argument("ACTUAL", options->actual, "the picture that was made, a PNG file")->required();
  command.argument("EXPECTED", options->expected, "the picture that it should be, a PNG file")->required();
  command.option(group::kOutput, "--diff", options->diff, "write a picture of the differences", "OUT.png");
  command.flag(group::kOutput, "--json", options->json, "print the measures as JSON");
  command.force(options->force);
  command.carry_out(action, options, compare);
}

}  // namespace pabd::cli
