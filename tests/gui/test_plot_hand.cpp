// SPDX-License-Identifier: MIT
// The mouse on the plots of panels: the wheel, drags and a double-click choose what is seen, and take nothing away from
// what the left button does.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/gui/script_runner.h"

namespace pabd::test_plot_hand {

namespace {

using Json = nlohmann::json;

constexpr const char* kBarrier = "[1100, 190]";  // in the plot, off both grips
constexpr const char* kConvergence = "[1100, 560]";

// What a script prints, line by line.
std::vector<Json> printed_by(const std::string& actions) {
  const TempFolder folder;
  std::string renderer, printed;
  carry_out(Script(R"([{"do": "load", "scene": "two_boxes", "force": true}, {"do": "step", "steps": 40},)" +
                       actions + "]",
                   "s"),
            folder, renderer, nullptr, &printed);
  std::vector<Json> out;
  std::string::size_type at = 0;
  for (auto end = printed.find("/ui/", 1); at < printed.size(); end = printed.find("/ui/", at + 1)) {
    const std::string part = printed.substr(at, end == printed.npos ? end : end - at);
    out.push_back(Json::parse(part.substr(part.find(' '))));
    at = end == printed.npos ? printed.size() : end;
  }
  return out;
}

std::string print(const std::string& panel) {
  return R"({"do": "wait", "frames": 2}, {"do": "print", "at": "/ui/plots/)" + panel + R"("},)";
}
std::string wheel(const std::string& at, double notches) {
  return R"({"do": "mouse", "at": )" + at + R"(, "wheel": )" + std::to_string(notches) + "},";
}
std::string drag(const std::string& from, const std::string& to, const std::string& how) {
  return R"({"do": "mouse", "at": )" + from + R"(, "to": )" + to + ", " + how + "},";
}
constexpr const char* kEnd = R"({"do": "wait"})";

double span(const Json& range) { return range[1].get<double>() - range[0].get<double>(); }

}  // namespace

TEST_CASE("the wheel zooms about the pointer, and a double-click gives the axes back") {
  for (const auto& [panel, at] : {std::pair{"barrier", kBarrier}, {"convergence", kConvergence}}) {
    CAPTURE(panel);
    const auto seen =
        printed_by(wheel(at, 1) + print(panel) + wheel(at, 1) + print(panel) + wheel(at, 2) + print(panel) +
                   R"({"do": "mouse", "at": )" + at + R"(, "how": "double_click"},)" + print(panel) + kEnd);
    REQUIRE(seen.size() == 4);
    const Json &first = seen[0]["x"], &second = seen[1]["x"], &third = seen[2]["x"];
    CHECK(span(first) / span(second) == Approx(1.15));
    CHECK(span(second) / span(third) == Approx(1.15 * 1.15));
    // The place of the pointer, in parts of the axis, is the same each time: labels may move it by some pixels.
    const auto place = [](const Json& before, const Json& after) {
      return (after[0].get<double>() - before[0].get<double>()) / (span(before) - span(after));
    };
    CHECK(place(first, second) == Approx(place(second, third)).margin(0.03));
    CHECK(place(first, second) > 0.4);
    CHECK(place(first, second) < 0.6);
    CHECK(seen[3]["x"].empty());
    CHECK(seen[3]["y"].empty());
  }
}

TEST_CASE("a drag with the right button, the middle one or shift moves what is seen, as far as the mouse") {
  std::vector<double> shifts;
  for (const char* how : {R"("button": "right")", R"("button": "middle")", R"("with": "shift")"}) {
    const auto seen =
        printed_by(wheel(kBarrier, 2) + print("barrier") + drag("[1100, 190]", "[1130, 190]", how) +
                   print("barrier") + drag("[1130, 190]", "[1100, 190]", how) + print("barrier") + kEnd);
    REQUIRE(seen.size() == 3);
    CAPTURE(how);
    CHECK(span(seen[1]["x"]) == Approx(span(seen[0]["x"])));
    shifts.push_back((seen[0]["x"][0].get<double>() - seen[1]["x"][0].get<double>()) / span(seen[0]["x"]));
    // 30 of about 330 pixels.
    CHECK(shifts.back() == Approx(30.0 / 330).margin(0.005));
    CHECK(shifts.back() == Approx(shifts.front()).margin(1e-6));
    CHECK(seen[2]["x"][0].get<double>() ==
          Approx(seen[0]["x"][0].get<double>()).margin(1e-3 * span(seen[0]["x"])));
    CHECK(span(seen[1]["y"]) == Approx(span(seen[0]["y"])));
  }
}

TEST_CASE("κ and d̂ are dragged as before, also on a part of the plot, also with shift") {
  for (const char* how : {R"("button": "left")", R"("with": "shift")"}) {
    const auto seen =
        printed_by(wheel(kBarrier, 3) + print("barrier") + drag("[1012, 179]", "[1012, 160]", how) +
                   print("barrier") + kEnd + std::string(R"(,
        {"do": "expect", "at": "/a/changed", "is_not": {}}, {"do": "expect", "at": "/a/kappa", "above": 310})"));
    REQUIRE(seen.size() == 2);
    CHECK(seen[0] == seen[1]);
  }
}

TEST_CASE("the left button on a curve over time goes to a step, the right one does not") {
  const std::string series = R"({"do": "panel", "panel": "series"}, {"do": "wait", "frames": 2},)";
  const auto seen =
      printed_by(series + drag("[1100, 560]", "[1050, 560]", R"("button": "right")") +
                 R"({"do": "expect", "at": "/a/step", "is": 40},)" + print("series") +
                 R"({"do": "mouse", "at": [1100, 560], "how": "click"}, {"do": "wait", "frames": 3},
                                  {"do": "expect", "at": "/a/step", "below": 40},)" +
                 // Another quantity has its own axes.
                 R"({"do": "series_view", "quantity": "energies"},)" + print("series") + kEnd);
  REQUIRE(seen.size() == 2);
  CHECK(seen[0]["x"].size() == 2);
  CHECK(seen[1]["x"].empty());
}

TEST_CASE("a script chooses the part, and what is no range is refused") {
  const auto seen =
      printed_by(R"({"do": "plot_view", "panel": "series", "x": [0.1, 0.2]},)" + print("series") + kEnd);
  CHECK(seen[0]["x"] == Json({0.1, 0.2}));
  for (const char* wrong : {"[1]", "[2, 1]", "[1, 1]", "[1, 2, 3]"}) {
    CAPTURE(wrong);
    CHECK_THROWS(printed_by(R"({"do": "plot_view", "panel": "series", "x": )" + std::string(wrong) + "}"));
  }
}

}  // namespace pabd::test_plot_hand
