// SPDX-License-Identifier: MIT
// pabd render --ab: two parameter sets of one scene in step.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "app/frames/frame_source.h"
#include "render/output/png.h"
#include "sim/scene/tuning.h"
#include "tests/cli/program.h"
#include "tests/support/places.h"

namespace pabd::test_cli_ab {

using namespace test;
using pabd::Image;
using pabd::read_png;
using pabd::read_png_text;

namespace {

constexpr int kWidth = 322, kHeight = 180, kHalf = 160;  // 2 px between

Outcome render(const CommandFolder& folder, const std::string& out, const std::string& patch,
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
  const CommandFolder folder;
  REQUIRE(render(folder, "same.png", "{}").exit_code == 0);
  const Image image = read_png(folder / "same.png");
  CHECK(image.width == kWidth);
  CHECK(image.height == kHeight);
  CHECK(half_a(image) == half_b(image));
}

TEST_CASE("B is the run that the patched scene makes, A the one that the scene makes") {
  const CommandFolder folder;
  // A scene with other parameters may be seen from elsewhere.
  const std::vector<std::string> from_here{"--camera", "eye=3,2,4,target=0,0.5,0"};
  REQUIRE(render(folder, "ab.png", R"({"contact": {"kappa": 20}})", from_here).exit_code == 0);
  const Image ab = read_png(folder / "ab.png");
  CHECK(half_a(ab) != half_b(ab));
  // The caption takes the place of two lines in one and of one in the other: the same camera with one line.
  REQUIRE(render(folder, "a.png", R"({"solver": {"tolerance": 1e-7}})", from_here).exit_code == 0);
  CHECK(half_a(read_png(folder / "a.png")) == half_a(ab));
  REQUIRE(render(folder, "b.png", R"({"solver": {"tolerance": 1e-7}})",
                 {"--set", "contact.kappa=20", "--camera", from_here[1]})
              .exit_code == 0);
  CHECK(half_a(read_png(folder / "b.png")) == half_b(ab));
}

TEST_CASE("a ghost is drawn over A and nowhere else") {
  const CommandFolder folder;
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
  const CommandFolder folder;
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
  const CommandFolder folder;
  const std::string patch = R"({"contact": {"kappa": 20}})";
  for (const char* overlay : {"series", "difference", "params,series,difference,contacts"}) {
    CAPTURE(overlay);
    REQUIRE(render(folder, "o.png", patch, {"--overlay", overlay}).exit_code == 0);
    REQUIRE(render(folder, "p.png", patch).exit_code == 0);
    CHECK(read_png(folder / "o.png").rgb != read_png(folder / "p.png").rgb);
  }
}

TEST_CASE("what cannot be compared is refused in one line") {
  const CommandFolder folder;
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

// Times as fractions of a second, so that what is expected is exact.
struct Fraction {
  int over, under;
  double value() const { return static_cast<double>(over) / under; }
};

// With a time step of h s.
pabd::Run two_boxes(double h) {
  const auto scene =
      std::make_shared<const pabd::Scene>(pabd::load_scene(places::scenes() + "/two_boxes.json"));
  pabd::Run run(scene, 1, pabd::kNoPast);
  pabd::Params params = run.params();
  params.h = h;
  run.set_params(params);
  return run;
}

TEST_CASE("B is at its last step that is not after A's time, with whatever time steps") {
  const Fraction pairs[][2] = {
      {{1, 60}, {1, 60}},  {{1, 60}, {1, 240}}, {{1, 60}, {1, 100}}, {{1, 60}, {1, 20}},  {{1, 60}, {1, 7}},
      {{1, 100}, {1, 60}}, {{1, 240}, {1, 90}}, {{1, 50}, {3, 200}}, {{1, 30}, {2, 125}}, {{1, 7}, {1, 11}}};
  for (const auto& [step_a, step_b] : pairs) {
    CAPTURE(step_a.under, step_b.over, step_b.under);
    constexpr int kFrames = 40;
    pabd::LiveSource source(pabd::runs_of(two_boxes(step_a.value()), two_boxes(step_b.value())),
                            {0, kFrames, 1 / step_a.value()});
    std::vector<int> common, measured;
    std::size_t known = 0;
    while (const auto frame = source.next([] { return false; })) {
      REQUIRE(frame->b());
      const int k = frame->number;
      CHECK(frame->a().state->step == k);
      // ⌊k h_A / h_B⌋
      const int over = k * step_a.over * step_b.under, under = step_a.under * step_b.over;
      CHECK(frame->b()->state->step == over / under);
      if (k > 0 && over % under == 0) common.push_back(k);
      for (; known < frame->apart.size(); ++known) {
        const pabd::DistancePoint& point = frame->apart[known];
        CHECK(point.time == frame->a().state->time);
        measured.push_back(k);
        CHECK((step_a.value() == step_b.value() ? point.position == 0 : point.position >= 0));
      }
    }
    CHECK(measured == common);
  }
}

TEST_CASE("steps that were rounded where they were written are in step") {
  for (const double h : {0.0166667, 0.01666666}) {
    CAPTURE(h);
    pabd::LiveSource source(pabd::runs_of(two_boxes(1.0 / 60), two_boxes(h)), {0, 200, 60});
    while (const auto frame = source.next([] { return false; })) {
      CHECK(frame->b()->state->step == frame->number);
      CHECK(frame->apart.size() == static_cast<std::size_t>(frame->number));
    }
  }
}

TEST_CASE("both halves are seen from the same place, where B is behind as well") {
  const CommandFolder folder;
  write_text(folder / "still.json", R"({ "format": "pabd-scene", "version": 1, "name": "still",
    "bodies": [ { "name": "box", "shape": { "type": "box", "size": [1, 2, 3] }, "fixed": true } ] })");
  write_text(folder / "patch.json", R"({"time_step": 0.3})");
  REQUIRE(run_pabd({"render", folder / "still.json", "--size", "322x180", "--time", "0.2", "-o",
                    folder / "s.png", "--ab", folder / "patch.json", "--camera", "orbit:300", "--quiet"})
              .exit_code == 0);
  const Image image = read_png(folder / "s.png");
  CHECK(half_a(image) == half_b(image));
}

TEST_CASE("the window, its videos and render show the same step of B, whatever the two time steps") {
  struct Case {
    const char *a, *b, *fps, *view;
  };
  constexpr int kSteps = 10;
  const Case cases[] = {{"0.016666666666666666", "0.01", "60", "ghost"},
                        {"0.016666666666666666", "0.004166666666666667", "60", "side"},
                        {"0.01", "0.016666666666666666", "100", "side"}};
  const std::string size = R"("width":160,"height":90)";
  const std::string camera = R"("eye":[3,2,4],"target":[0,0.5,0],"fov":40)";
  for (const Case& c : cases) {
    CAPTURE(c.a, c.b);
    const CommandFolder folder;
    const auto frame = [&](const std::string& letter, int i) {
      return folder / (letter + (i < 10 ? "0" : "") + std::to_string(i) + ".png");
    };
    std::vector<std::pair<std::string, int>> shots;
    const auto go = [&](const std::string& letter, int steps, int to) {
      shots.emplace_back(letter, to);
      return R"(,{"do":"step","steps":)" + std::to_string(steps) + R"(},{"do":"screenshot","ui":false,)" +
             size + R"(,"path":")" + frame(letter, to) + R"("})";
    };
    std::string script = R"([{"do":"compare","values":["contact.kappa=20","time_step=)" + std::string(c.b) +
                         R"("]},{"do":"compare_view","how":")" + c.view + R"("},{"do":"look",)" + camera +
                         "}";
    script +=
        go("live", 2, 2) + go("live", 5, 7) + go("live", 3, kSteps) + go("back", -7, 3) + go("again", 5, 8);
    const std::string record = R"(,{"do":"record",)" + size + R"(,"fps":)" + c.fps;
    script += record + R"(,"path":")" + (folder / "v{frame:02}.png") + R"("})";
    script += record + R"(,"overlay":"params,series,difference","path":")" + (folder / "o{frame:02}.png") +
              R"("}])";
    write_text(folder / "script.json", script);
    const std::string set = std::string("time_step=") + c.a;
    const Outcome view = run_pabd({"view", "two_boxes", "--set", set, "--headless", "--script",
                                   folder / "script.json", "--threads", "1"});
    CAPTURE(view.err);
    REQUIRE(view.exit_code == 0);

    const std::string patch = R"({"contact": {"kappa": 20}, "time_step": )" + std::string(c.b) + "}";
    write_text(folder / "patch.json", patch);
    const auto render_ab = [&](const char* out, const char* overlay) {
      const Outcome outcome = run_pabd({"render",    "two_boxes",
                                        "--set",     set,
                                        "--ab",      folder / "patch.json",
                                        "--ab-view", c.view,
                                        "--size",    "160x90",
                                        "--fps",     c.fps,
                                        "--frames",  std::to_string(kSteps + 1),
                                        "--overlay", overlay,
                                        "--camera",  "eye=3,2,4,target=0,0.5,0,fov=40",
                                        "-o",        folder / out,
                                        "--quiet",   "--threads",
                                        "1"});
      CAPTURE(outcome.err);
      REQUIRE(outcome.exit_code == 0);
    };
    render_ab("r{frame:02}.png", "contacts,bonds");
    render_ab("p{frame:02}.png", "params,series,difference");
    for (int i = 0; i < kSteps; ++i) {
      CAPTURE(i);
      const bool plain = read_text(frame("v", i)) == read_text(frame("r", i));
      CHECK(plain);
      const bool overlays = read_text(frame("o", i)) == read_text(frame("p", i));
      CHECK(overlays);
    }
    for (const auto& [letter, i] : shots) {
      CAPTURE(letter, i);
      const bool same = read_png(frame(letter, i)).rgb == read_png(frame("r", i)).rgb;
      CHECK(same);
    }
  }
}

TEST_CASE("B may have other laws of joints: it is the run of a scene that has them") {
  const CommandFolder folder;
  const auto picture = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> command = {"render",
                                        "slider_crank",
                                        "--size",
                                        "322x180",
                                        "--quiet",
                                        "--time",
                                        "0.5",
                                        "-o",
                                        folder / name,
                                        "--camera",
                                        "eye=2,2,6,target=0,1,0"};
    command.insert(command.end(), more.begin(), more.end());
    const Outcome outcome = run_pabd(command);
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return read_png(folder / name);
  };
  write_text(folder / "joints.json", R"({"joints_default": {"potential": "soft", "kappa": 30}})");
  write_text(folder / "none.json", "{}");
  const std::vector<std::string> soft = {"--set", "joints_default.potential=soft", "--set",
                                         "joints_default.kappa=30"};
  const Image ab = picture("ab.png", {"--ab", folder / "joints.json"});
  CHECK(half_a(ab) == half_a(picture("a.png", {"--ab", folder / "none.json"})));
  // The scene with that law in both halves: the same bodies at the same places, the same height of caption.
  auto both = soft;
  both.insert(both.end(), {"--ab", folder / "none.json"});
  CHECK(half_b(ab) == half_b(picture("b.png", both)));
  CHECK(half_a(ab) != half_b(ab));
  const auto text = read_png_text(folder / "ab.png");
  CHECK(nlohmann::json::parse(text.at("B patch"))["joints_default"]["kappa"] == 30);
  CHECK(nlohmann::json::parse(text.at("B parameters"))["joints_default"]["potential"] == "soft");
  CHECK(nlohmann::json::parse(text.at("Parameters"))["joints_default"] !=
        nlohmann::json::parse(text.at("B parameters"))["joints_default"]);
}

TEST_CASE("a patch of joints that is wrong is refused as --set refuses it") {
  const CommandFolder folder;
  for (const char* patch : {R"({"joints_default": 3})", R"({"joints_default": {"kappa": -1}})",
                            R"({"joints_default": {"stiff": 1}})"}) {
    CAPTURE(patch);
    const Outcome outcome = render(folder, "a.png", patch);
    CHECK(outcome.exit_code == 2);
    CHECK(is_error_line(outcome.err, {"joints_default"}));
  }
}

}  // namespace pabd::test_cli_ab
