// SPDX-License-Identifier: MIT
// The same pixels from every processor: software GL is made to believe in others. Without fused multiply-add
// (before AVX2) a few pixels may be off by a level, as within a class of renderers.
#include <catch2/catch.hpp>

#include "render/output/compare_images.h"
#include "render/output/png.h"
#include "tests/cli/program.h"

namespace pabd::test_cli_pixels {

using namespace test;

namespace {

using Environment = std::map<std::string, std::string>;

std::string name_of(const Environment& environment) {
  std::string name;
  for (const auto& [key, value] : environment) name += (name.empty() ? "" : " ") + key + "=" + value;
  return name.empty() ? "as it comes" : name;
}

struct Drawn {
  Image image;
  PngText text;
};

// Every kind of body with contacts, joints of a mechanism left out: shading, shadows, lines, panels with
// curves.
Drawn draw(const CommandFolder& folder, const Environment& environment) {
  const std::string file = folder / "frame.png";
  const Outcome outcome = run_pabd({"render", "shapes", "--time", "0", "--size", "480x270", "--overlay",
                                    "contacts,params,barrier", "--quiet", "--force", "-o", file},
                                   {environment, {}, {}, -1});
  INFO(name_of(environment) << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return {read_png(file), read_png_text(file)};
}

}  // namespace

TEST_CASE("vector widths and instruction sets of software GL draw the same pixels") {
  const CommandFolder folder;
  const Drawn usual = draw(folder, {});
  REQUIRE(usual.text.at("GL_RENDERER").starts_with("llvmpipe"));
  // One width on every machine, unless the user asks for another.
  CHECK(usual.text.at("GL_RENDERER").find("128 bits") != std::string::npos);

  std::string report;
  for (const char* width : {"128", "256"}) {
    for (const char* instructions : {"", "sse4.1", "avx", "avx2"}) {
      Environment environment = {{"LP_NATIVE_VECTOR_WIDTH", width}};
      if (*instructions) environment["GALLIUM_OVERRIDE_CPU_CAPS"] = instructions;
      const Drawn other = draw(folder, environment);
      CHECK(other.text.at("GL_RENDERER").find(width) != std::string::npos);
      const CompareResult result = compare_images(other.image, usual.image, CompareTier::same_class);
      report += name_of(environment) +
                (other.image.rgb == usual.image.rgb ? ": the same pixels\n" : ": within a level\n");
      INFO(report << result.reason);
      CHECK(result.equal);
    }
  }
  WARN(report);
}

TEST_CASE("without SSE 4.1 software GL rounds in another way, by no more than one sees") {
  const CommandFolder folder;
  const Drawn usual = draw(folder, {});
  const Drawn old = draw(folder, {{"GALLIUM_OVERRIDE_CPU_CAPS", "sse2"}});
  const CompareResult result = compare_images(old.image, usual.image, CompareTier::cross_class);
  INFO(result.reason);
  CHECK(result.equal);
}

}  // namespace pabd::test_cli_pixels
