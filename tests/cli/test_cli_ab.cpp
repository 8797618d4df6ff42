// pabd render --ab: two parameter sets of one scene in step.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "app/frames/frame_producer.h"
#include "render/output/png.h"
#include "sim/scene/tuning.h"
#include "tests/cli/program.h"

using namespace pabd::test;
using pabd::Image;
using pabd::read_png;
using pabd::read_png_text;

namespace {

constexpr int kWidth = 322, kHeight = 180, kHalf = 160;  // 2 px between

Outcome render(const TempFolder& folder, const std::string& out, const std::string& patch,
               const std::vector<std::string>& more = {}) {
  write_text(folder / "patch.json", patch);
  std::vector<std::string> command = {"render",  "two_boxes",  "--size", "322x180",
                                      "--quiet", "--force",    "--time", "0.2",
                                      "-o",      folder / out, "--ab",   folder / "patch.json"};
  command.insert(command.end(), more.begin(), more.end());
  return run_pabd(command);
}

// The lower two thirds of a half: below the caption.
std::vector<std::uint8_t> half(const Image& image, int left) {
  std::vector<std::uint8_t> out;
  for (int y = image.height / 3; y < image.height; ++y) {
    const auto at = image.rgb.begin() + 3 * (y * image.width + left);
    out.insert(out.end(), at, at + 3 * kHalf);
  }
  return out;
}
std::vector<std::uint8_t> half_a(const Image& image) { return half(image, 0); }
std::vector<std::uint8_t> half_b(const Image& image) { return half(image, kWidth - kHalf); }

}  // namespace

TEST_CASE("with an empty patch both halves show the same run") {
  const TempFolder folder;
  REQUIRE(render(folder, "same.png", "{}").exit_code == 0);
  const Image image = read_png(folder / "same.png");
  CHECK(image.width == kWidth);
  CHECK(image.height == kHeight);
  CHECK(half_a(image) == half_b(image));
}

TEST_CASE("B is the run that the patched scene makes, A the one that the scene makes") {
  const TempFolder folder;
  REQUIRE(render(folder, "ab.png", R"({"contact": {"kappa": 20}})").exit_code == 0);
  const Image ab = read_png(folder / "ab.png");
  CHECK(half_a(ab) != half_b(ab));
  // The caption takes the place of two lines in one and of one in the other: the same camera with one line.
  REQUIRE(render(folder, "a.png", R"({"solver": {"tolerance": 1e-7}})").exit_code == 0);
  CHECK(half_a(read_png(folder / "a.png")) == half_a(ab));
  REQUIRE(render(folder, "b.png", R"({"solver": {"tolerance": 1e-7}})", {"--set", "contact.kappa=20"})
              .exit_code == 0);
  CHECK(half_a(read_png(folder / "b.png")) == half_b(ab));
}

TEST_CASE("a ghost is drawn over A and nowhere else") {
  const TempFolder folder;
  const std::vector<std::string> ghost{"--ab-view", "ghost"};
  REQUIRE(render(folder, "g.png", R"({"contact": {"kappa": 20}})", ghost).exit_code == 0);
  REQUIRE(render(folder, "h.png", R"({"contact": {"kappa": 21}})", ghost).exit_code == 0);
  const Image g = read_png(folder / "g.png"), h = read_png(folder / "h.png");
  REQUIRE(g.rgb.size() == h.rgb.size());
  int different = 0, outside = 0;
  for (int y = kHeight / 3; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const std::size_t k = static_cast<std::size_t>(3 * (y * kWidth + x));
      const bool same = std::memcmp(&g.rgb[k], &h.rgb[k], 3) == 0;
      different += same ? 0 : 1;
      outside += !same && (x < kWidth / 5 || x > 4 * kWidth / 5) ? 1 : 0;
    }
  }
  CHECK(different > 20);  // the other κ lets the boxes sink less
  CHECK(outside == 0);
}

TEST_CASE("every PNG tells the patch and how the two are shown; a sequence goes on only with the same") {
  const TempFolder folder;
  const std::string patch = R"({"contact": {"kappa": 20}, "time_step": 0.01})";
  REQUIRE(render(folder, "f{frame}.png", patch, {"--fps", "20"}).exit_code == 0);
  const auto text = read_png_text(folder / "f2.png");
  CHECK(nlohmann::json::parse(text.at("B patch")) == nlohmann::json::parse(patch));
  CHECK(nlohmann::json::parse(text.at("B parameters"))["contact"]["kappa"] == 20);
  CHECK(nlohmann::json::parse(text.at("Parameters"))["contact"]["kappa"] == 300);
  CHECK(nlohmann::json::parse(text.at("View"))["ab"] == "side");
  const std::string last = read_text(folder / "f3.png");
  std::filesystem::remove(folder / "f3.png");
  REQUIRE(render(folder, "f{frame}.png", patch, {"--fps", "20", "--resume"}).exit_code == 0);
  CHECK(read_text(folder / "f3.png") == last);
  const Outcome other = render(folder, "f{frame}.png", "{}", {"--fps", "20", "--resume"});
  CHECK(other.exit_code == 2);
  CHECK(is_error_line(other.err, {"--resume", "another run"}));
}

TEST_CASE("overlays show both runs and how far they are apart") {
  const TempFolder folder;
  const std::string patch = R"({"contact": {"kappa": 20}})";
  for (const char* overlay : {"series", "difference", "params,series,difference,contacts"}) {
    CAPTURE(overlay);
    REQUIRE(render(folder, "o.png", patch, {"--overlay", overlay}).exit_code == 0);
    REQUIRE(render(folder, "p.png", patch).exit_code == 0);
    CHECK(read_png(folder / "o.png").rgb != read_png(folder / "p.png").rgb);
  }
}

TEST_CASE("what cannot be compared is refused in one line") {
  const TempFolder folder;
  const auto refused = [&](const std::string& patch, const std::vector<std::string>& words,
                           const std::vector<std::string>& more = {}) {
    const Outcome outcome = render(folder, "x.png", patch, more);
    CAPTURE(patch, outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(is_error_line(outcome.err, words));
    CHECK_FALSE(std::filesystem::exists(folder / "x.png"));
  };
  refused(R"({"bodies": []})", {"patch.json", "/bodies", "solver"});
  refused(R"({"contact": {"kappa": -1}})", {"patch.json", "/contact/kappa"});
  refused(R"({"contact": {"kapa": 1}})", {"patch.json", "kapa"});
  refused("{", {"patch.json", "JSON"});
  refused("{}", {"--ab-view", "side"}, {"--ab-view", "over"});
  const Outcome narrow = run_pabd(
      {"render", "two_boxes", "-o", folder / "x.png", "--size", "20x20", "--ab", folder / "patch.json"});
  CHECK(narrow.exit_code == 2);
  CHECK(is_error_line(narrow.err, {"--size", "34"}));
  const Outcome alone = run_pabd({"render", "two_boxes", "-o", folder / "x.png", "--overlay", "difference"});
  CHECK(alone.exit_code == 2);
  CHECK(is_error_line(alone.err, {"difference", "--ab"}));
  const Outcome missing =
      run_pabd({"render", "two_boxes", "-o", folder / "x.png", "--ab", folder / "none.json"});
  CHECK(missing.exit_code == 3);
}

TEST_CASE("B steps until its time reaches A's, with whatever time step") {
  for (const double h : {1.0 / 60, 1.0 / 240, 0.01, 0.05, 1.0 / 7}) {
    CAPTURE(h);
    pabd::Session a(pabd::load_scene(PABD_SCENES "/two_boxes.json"));
    pabd::Session b(pabd::load_scene(PABD_SCENES "/two_boxes.json"));
    pabd::Params params = a.params();
    params.h = h;
    b.set_params(params);
    pabd::FrameProducer producer(
        a, {0, 30, 60}, [] { return false; }, [](int, const pabd::StepReport&) {}, &b);
    std::size_t points = 0;
    while (const auto packet = producer.next()) {
      REQUIRE(packet->b);
      const double behind = packet->state.time - packet->b->state.time;
      CHECK(behind <= 1e-6);
      CHECK(behind > -h * (1 + 1e-9));
      points += packet->apart.size();
      if (packet->frame > 0) {
        CHECK(packet->apart.back().time == packet->state.time);
        const double apart = packet->apart.back().position;
        CHECK((h == a.params().h ? apart == 0 : apart >= 0));
      }
    }
    CHECK(points == 29);
  }
}
