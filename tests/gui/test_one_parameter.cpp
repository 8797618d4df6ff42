// SPDX-License-Identifier: MIT
// A parameter is one row of a table: a made-up row is found wherever parameters are.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <random>

#include "app/gui/number_input.h"
#include "app/gui/parameters_panel.h"
#include "app/overlay/parameter_words.h"
#include "app/plots/rich_text.h"
#include "sim/base/error.h"
#include "sim/scene/parameter_docs.h"
#include "sim/scene/tuning.h"
#include "sim/scene/write_scene.h"

namespace pabd::test_one_parameter {

using Json = nlohmann::json;

namespace {

// The table with one more line, which takes the member of another.
std::vector<ParameterRow> with_row(ParameterRow row) {
  const ParameterTable all = parameter_table();
  std::vector<ParameterRow> rows(all.begin(), all.end());
  std::erase_if(rows, [&](const ParameterRow& r) { return r.member == row.member; });
  rows.push_back(row);
  return rows;
}

std::vector<ParameterRow> glued() {
  return with_row({.key = "contact.glue",
                   .label = "glue",
                   .symbol = "σ_max",
                   .unit = "N/m",
                   .noun = "pull",
                   .help = "How bodies stick",
                   .member = &ContactParams::recovery_speed,
                   .range = {0, 5},
                   .slider_hi = 2});
}

const char* const kScene = R"({"format": "pabd-scene", "version": 1, "contact": {"glue": 1.5},
                              "bodies": [{"shape": {"type": "sphere", "radius": 1}}]})";

std::string refusal(const auto& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("a row is a parameter of scenes, --set, patches and checks") {
  const std::vector<ParameterRow> table = glued();
  const Scene scene = parse_scene(kScene, "scene", {}, {}, table);
  CHECK(scene.params.contact.recovery_speed == 1.5);
  CHECK_THAT(refusal([] { parse_scene(kScene, "scene", {}); }), Catch::Contains("/contact/glue"));
  CHECK(parse_scene(kScene, "scene", {}, {"contact.glue=0.25"}, table).params.contact.recovery_speed == 0.25);
  CHECK(scene.hash != parse_scene(kScene, "scene", {}, {"contact.glue=2"}, table).hash);

  const std::string text = scene_to_json(scene.model, scene.initial, scene.params, {}, "s", {}, {}, table);
  CHECK(Json::parse(text)["contact"]["glue"] == 1.5);
  CHECK(parse_scene(text, "written", {}, {}, table).params == scene.params);
  const Params less = tuned(scene.params, {"contact.glue=0.5"}, table);
  CHECK(less.contact.recovery_speed == 0.5);
  CHECK(Json::parse(tuned_scene_text(kScene, "scene", {}, less, table))["contact"]["glue"] == 0.5);
  CHECK_THAT(refusal([&] { tuned(less, {"contact.glu=0.5"}, table); }), Catch::Contains("\"contact.glue\"?"));

  const std::string patch = patch_json(scene.params, less, table);
  CHECK(Json::parse(patch) == Json::parse(R"({"contact": {"glue": 0.5}})"));
  CHECK(patched(scene.params, patch, "patch", table) == less);
  using Changed = std::vector<std::pair<std::string, std::string>>;
  CHECK(differences(scene.params, less, table) == Changed{{"contact.glue", "0.5"}});
  CHECK(tuned_value(less, "contact.glue", table) == "0.5");

  const char* const expected = "/contact/glue: 7 is out of range: expected a pull from 0 to 5 (N/m)";
  CHECK_THAT(refusal([&] { tuned(less, {"contact.glue=7"}, table); }), Catch::Contains(expected));
  CHECK_THAT(refusal([&] { patched(less, R"({"contact": {"glue": 7}})", "p", table); }),
             Catch::Contains(expected));
  CHECK_THAT(refusal([&] { parse_scene(kScene, "scene", {}, {"contact.glue=7"}, table); }),
             Catch::Contains(expected));
  Params wrong = less;
  set_value(table.back(), wrong, 7.0);
  CHECK(check_params(wrong, table)->pointer == "/contact/glue");
}

TEST_CASE("a row is a slider, a caption, a definition of the schema and a line of the reference") {
  const std::vector<ParameterRow> table = glued();
  const std::vector<ParameterGroup> groups = parameter_groups(table);
  REQUIRE(groups[0].heading == "Contact");
  const ParameterRow& row = *groups[0].rows.back();
  CHECK(row_label(row) == "glue");
  CHECK(row.slider_hi == 2);
  Params a, b;
  set_value(row, b, as_value(row, 0.5));
  CHECK(b.contact.recovery_speed == 0.5);
  const auto words = difference_words(a, 1, b, 1, table);
  REQUIRE(words.size() == 1);
  CHECK(plain_text(words[0]) == "σ_max 3 → 0.5 N/m");

  const Json schema = Json::parse(parameter_schema(table))["$defs"]["contact"]["properties"]["glue"];
  CHECK(schema == Json::parse(R"({"type": "number", "minimum": 0, "maximum": 5, "default": 3,
                                  "description": "How bodies stick. Unit: N/m."})"));
  CHECK_THAT(parameter_reference(table),
             Catch::Contains("| `contact.glue` | σ_max | N/m | from 0 to 5 | 3.0 | How bodies stick |"));
}

TEST_CASE("a row may bring an object of its own") {
  const auto table =
      with_row({.key = "wind.speed", .label = "wind", .help = "Of the air", .member = &ContactParams::onset});
  const Params p = tuned(Params{}, {"wind.speed=0.5"}, table);
  CHECK(p.contact.onset == 0.5);
  CHECK(Json::parse(params_json(p, table))["wind"]["speed"] == 0.5);
  const std::string text = R"({"format": "pabd-scene", "version": 1,
                              "bodies": [{"shape": {"type": "sphere", "radius": 1}}]})";
  CHECK(parse_scene(text, "scene", {}, {"wind.speed=0.25"}, table).params.contact.onset == 0.25);
  const Json schema = Json::parse(parameter_schema(table));
  CHECK(schema["properties"]["wind"]["$ref"] == "#/$defs/wind");
  CHECK(schema["$defs"]["wind"]["properties"].contains("speed"));
  CHECK(parameter_groups(table)[0].heading == "Wind");
}

TEST_CASE("the rows of the table agree with themselves and with the parameters") {
  std::vector<std::string> keys;
  for (const ParameterRow& row : parameter_table()) {
    INFO(row.key);
    CHECK(std::count(keys.begin(), keys.end(), row.key) == 0);
    keys.emplace_back(row.key);
    CHECK(&parameter_of(row.member) == &row);
    CHECK(find_parameter(row.key) == &row);
    const ParameterKind kind = kind_of(row);
    CHECK((kind == ParameterKind::choice) == !choices_of(row).empty());
    CHECK(std::string(row.help).back() != '.');
    if (row.follows) CHECK(find_parameter(row.follows));
    if (kind != ParameterKind::real && kind != ParameterKind::whole) continue;
    CHECK(row.slider_lo < row.slider_hi);
    for (const double end : {row.slider_lo, row.slider_hi}) {  // no slider leads to a refusal
      Params p;
      p.contact.mu_static = 100;
      set_value(row, p, as_value(row, end));
      if (row.key != std::string_view("contact.friction.static")) CHECK_FALSE(check_params(p));
      CHECK(row.range.contains(end));
    }
  }
  // Groups hold every row once.
  std::size_t count = 0;
  for (const ParameterGroup& group : parameter_groups()) count += group.rows.size();
  CHECK(count == keys.size());
}

TEST_CASE("a slider's number is the decimal that would be written") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-12, 12), mantissa(-10, 10);
  const auto check = [](double x) {
    for (const int digits : {3, 4}) {
      char text[64];
      std::snprintf(text, sizeof text, "%.*g", digits, x);
      INFO(text);
      CHECK(significant(x, digits) == std::strtod(text, nullptr));
    }
  };
  for (int k = 0; k < 2000; ++k) {
    const double m = mantissa(random);
    check(m * std::pow(10, exponent(random)));
  }
  for (const double x : {0.0, 1.0, 999.6, 9.999e-5, 1e9, 123456789.0, 1.0 / 60}) check(x);
}

}  // namespace pabd::test_one_parameter
