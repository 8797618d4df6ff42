// SPDX-License-Identifier: MIT
// Commands on a workbench and on its thread, by what they leave behind.
#include <catch2/catch.hpp>

#include <filesystem>

#include "app/workbench/command_json.h"
#include "app/workbench/runner.h"
#include "sim/scene/tuning.h"
#include "tests/support/places.h"
#include "tests/support/temp_folder.h"
#include "tests/workbench/workbench_helpers.h"

namespace pabd::test_workbench {

using test::open;
using test::refusal;
namespace fs = std::filesystem;

TEST_CASE("parameters: set, undo, redo, reset, and what changed") {
  Workbench bench = open();
  const Params scene = bench.run().params();
  bench.apply(command::Set{"contact.N", "5"});
  bench.apply(command::Set{"contact.kappa", "10"});
  bench.apply(command::Set{"contact.kappa", "20", Side::a, true});  // a slider goes on
  Snapshot s = bench.snapshot();
  CHECK(s.a.changed ==
        std::vector<std::pair<std::string, std::string>>{{"contact.N", "5"}, {"contact.kappa", "20.0"}});
  CHECK(s.a.kappa == 20);
  CHECK(s.undo_text == "contact.kappa");
  CHECK(s.unsaved);
  bench.apply(command::Undo{});
  CHECK(bench.run().params().contact.kappa == scene.contact.kappa);
  CHECK(bench.run().params().contact.N == 5);
  bench.apply(command::Redo{});
  CHECK(bench.run().params().contact.kappa == 20.0);
  bench.apply(command::ResetParams{"contact.N"});
  CHECK(bench.run().params().contact.N == scene.contact.N);
  bench.apply(command::ResetParams{});
  CHECK(differences(scene, bench.run().params()).empty());
  CHECK_FALSE(bench.snapshot().unsaved);
  CHECK_FALSE(bench.snapshot().can_redo);
  bench.apply(command::Undo{});
  CHECK(bench.run().params().contact.kappa == 20.0);
  CHECK_THAT(refusal(bench, command::Set{"contact.N", "99"}), Catch::Contains("1 to 32"));
  CHECK_THAT(refusal(bench, command::ResetParams{"contact.M"}), Catch::Contains("contact.M"));
  CHECK(bench.run().params().contact.kappa == 20.0);
}

TEST_CASE("a value as a slider has it does what the same value does as text") {
  Workbench typed = open(), written = open();
  const Params p = typed.run().params();
  const auto check = [&](const char* key, const ParameterValue& value) {
    INFO(key);
    CHECK(refusal(typed, command::Set{key, value}).empty());
    CHECK(refusal(written, command::Set{key, value_text(value)}).empty());
    CHECK(typed.run().params() == written.run().params());
    // As a script it is one text.
    const CommandJson json = command_to_json(Command(command::Set{key, value}));
    CHECK(json == command_to_json(Command(command::Set{key, value_text(value)})));
  };
  check("contact.kappa", std::optional<double>(12.5));
  check("contact.kappa", std::optional<double>());
  check("contact.N", 7);
  check("time_step", 1.0 / 240);
  check("solver.method", SolverMethod::newton);
  check("gravity", Vec3(0, -1.62, 0.1));
  check("gravity", p.gravity);
  CHECK(typed.run().params().h == 1.0 / 240);
  CHECK(typed.run().params().contact.N == 7);
  CHECK_THAT(refusal(typed, command::Set{"contact.N", ParameterValue(99)}), Catch::Contains("1 to 32"));
  CHECK(typed.run().params().contact.N == 7);
}

TEST_CASE("time: steps forward and back, seek, restart") {
  Workbench bench = open();
  bench.apply(command::Step{30});
  CHECK(bench.run().state().step == 30);
  bench.apply(command::Step{-10});
  CHECK(bench.run().state().step == 20);
  bench.apply(command::Seek{0.1});
  CHECK(bench.run().state().step == 6);
  CHECK(bench.snapshot().a.history.size() == 31);
  bench.apply(command::Restart{});
  CHECK(bench.run().state().step == 0);
  CHECK(bench.snapshot().a.history.size() == 1);
  CHECK(bench.snapshot().a.left->size() == 30);
  bench.apply(command::Step{-1});
  CHECK(bench.run().state().step == 0);
  CHECK_THAT(refusal(bench, command::Speed{-1}), Catch::Contains("real time"));
}

TEST_CASE("a second simulation runs in step with the first") {
  Workbench bench = open();
  bench.apply(command::Step{5});
  bench.apply(command::Compare{{"time_step=0.00833333333333333333", "contact.N=6"}});
  bench.apply(command::Step{10});
  CHECK(bench.run(Side::a).state().step == 15);
  CHECK(bench.run(Side::b).state().step == 25);
  CHECK(bench.run(Side::b).state().time == Approx(bench.run(Side::a).state().time).epsilon(1e-12));
  const Snapshot s = bench.snapshot();
  REQUIRE(s.b);
  CHECK(s.b->changed.size() == 2);
  bench.apply(command::Set{"contact.N", "2", Side::b});
  CHECK(bench.run(Side::a).params().contact.N == 3);
  bench.apply(command::Seek{0.15});
  CHECK(bench.run(Side::b).state().time == Approx(0.15).epsilon(1e-9));
  bench.apply(command::EndCompare{});
  CHECK_FALSE(bench.snapshot().b);
  CHECK_THAT(refusal(bench, command::Set{"contact.N", "2", Side::b}), Catch::Contains("compare"));
}

TEST_CASE("equal parameters keep A and B equal to the last bit") {
  Workbench bench = open();
  bench.apply(command::Compare{});
  bench.apply(command::Step{50});
  CHECK(same_bits(bench.run(Side::a).state(), bench.run(Side::b).state()));
}

TEST_CASE("held curves, and methods compared on one step") {
  Workbench bench = open();
  CHECK_THAT(refusal(bench, command::Hold{}), Catch::Contains("nothing to hold"));
  bench.apply(command::Step{24});
  bench.apply(command::Hold{});
  bench.apply(command::Hold{"sissm"});
  const Snapshot s = bench.snapshot();
  REQUIRE(s.held.size() == 2);
  CHECK(s.held[1].name == "sissm, step 24");
  CHECK(s.held[1].records->front().energy != s.held[0].records->front().energy);
  CHECK_THAT(refusal(bench, command::Hold{"simplex"}), Catch::Contains("descent"));
  bench.apply(command::DropHeld{});
  CHECK(bench.snapshot().held.empty());
}

TEST_CASE("a simulation that diverges is told of and leaves the last good state") {
  Workbench bench = open();
  bench.apply(command::Step{20});
  // The log barrier has no force for bodies that overlap.
  bench.apply(command::Set{"contact.barrier", "log"});
  bench.apply(command::Edit{
      R"({"do": "add_body", "shape": {"type": "sphere", "radius": 0.5}, "position": [0, 0, 0]})"});
  bench.apply(command::Play{});
  const State before = bench.run().state();
  REQUIRE_FALSE(bench.advance());
  const Snapshot s = bench.snapshot();
  CHECK(s.diverged);
  CHECK_FALSE(s.playing);
  CHECK_THAT(s.messages.back().text, Catch::Contains("diverged at step 21"));
  CHECK_THAT(s.messages.back().text, Catch::EndsWith("or more solver.halvings"));
  CHECK(same_bits(*s.a.state, before));
  bench.apply(command::Step{-5});
  CHECK_FALSE(bench.snapshot().diverged);
  CHECK(bench.run().state().step == 16);
  bench.apply(command::Step{4});  // as far as it was good
  CHECK_FALSE(bench.snapshot().diverged);
  CHECK(bench.run().state().step == 20);
}

TEST_CASE(
    "a scene whose d̂ is too large for a body says so when it is loaded, one whose d̂ follows from it why") {
  const TempFolder folder;
  write_bytes(folder / "die.json", R"({ "format": "pabd-scene", "version": 1, "bodies": [
    { "name": "die", "shape": { "type": "box", "size": [0.001, 0.001, 0.001] } } ] })");
  Workbench bench({}, command::Load{folder / "die.json", {"contact.d_hat=0.01"}, false});
  REQUIRE(bench.snapshot().messages.size() == 1);
  CHECK(bench.snapshot().messages.back().severity == Severity::warning);
  CHECK_THAT(bench.snapshot().messages.back().text, Catch::Contains("\"die\" (0.001 m)"));
  bench.apply(command::Load{folder / "die.json", {}, true});
  REQUIRE(bench.snapshot().messages.size() == 2);
  CHECK(bench.snapshot().messages.back().severity == Severity::note);
  CHECK_THAT(bench.snapshot().messages.back().text, Catch::Contains("the scene states none"));
  // What is saved reads back as it is here, also where it is what larger bodies have.
  bench.apply(command::Set{"contact.d_hat", "0.01"});
  bench.apply(command::SaveScene{folder / "large.json"});
  bench.apply(command::Load{folder / "large.json", {}, true});
  CHECK(bench.run().params().contact.d_hat == 0.01);
}

TEST_CASE("files: save, refuse to replace, reload, keep what is not saved") {
  const TempFolder folder;
  fs::copy_file(places::scenes() + "/two_boxes.json", folder / "scene.json");
  Workbench bench = open(folder / "scene.json");
  bench.apply(command::Set{"contact.kappa", "42"});
  CHECK_THAT(refusal(bench, command::Load{folder / "scene.json", {}, false}), Catch::Contains("not saved"));
  bench.apply(command::SavePatch{folder / "patch.json"});
  CHECK_FALSE(bench.snapshot().unsaved);
  CHECK_THAT(refusal(bench, command::SavePatch{folder / "patch.json"}), Catch::Contains("exists already"));
  CHECK_THAT(refusal(bench, command::SaveScene{"/dev/null/scene.json"}),
             Catch::Contains("/dev/null is a file"));
  bench.apply(command::SaveScene{folder / "tuned.json"});
  CHECK(load_scene(folder / "tuned.json").params.contact.kappa == 42.0);
  bench.apply(command::ResetParams{});
  bench.apply(command::ApplyPatch{folder / "patch.json", Side::a});
  CHECK(bench.run().params().contact.kappa == 42.0);

  // The file changes on disk: what was tuned stays.
  CHECK_FALSE(bench.look_at_file());
  const std::string newer =
      tuned_scene_text(read_scene_text(folder / "scene.json"), "scene", {},
                       tuned(bench.run().params(), {"contact.N=7", "contact.kappa=auto"}));
  write_bytes(folder / "scene.json", newer);
  fs::last_write_time(folder / "scene.json", fs::file_time_type::clock::now() + std::chrono::seconds(5));
  CHECK(bench.look_at_file());
  bench.apply(command::Reload{});
  CHECK(bench.run().params().contact.N == 7);
  CHECK(bench.run().params().contact.kappa == 42.0);
  // Broken: the scene that is open stays.
  write_bytes(folder / "scene.json", "{ broken");
  CHECK_THAT(refusal(bench, command::Reload{}), Catch::Contains("line 1"));
  bench.apply(command::Step{1});
  CHECK(bench.run().state().step == 1);
}

TEST_CASE("commands read and write themselves as JSON") {
  Command c;
  const auto read = [&](const std::string& text) {
    const CommandJson json = CommandJson::parse(text);
    return command_from_json(json.at("do"), json, "action 1", c);
  };
  REQUIRE(read(R"({"do":"set","key":"contact.kappa","value":50})"));
  CHECK(std::get<command::Set>(c).value == command::SetValue("50"));
  REQUIRE(read(R"({"do":"compare","values":["contact.N=4"]})"));
  CHECK(command_to_json(c).dump() == R"({"do":"compare","values":["contact.N=4"]})");
  CHECK_FALSE(read(R"({"do":"fly"})"));
  CHECK_THROWS_WITH(read(R"({"do":"seek"})"), Catch::Contains("action 1") && Catch::Contains("time"));
  CHECK_THROWS_WITH(read(R"({"do":"seek","tme":1,"time":2})"),
                    Catch::Contains("tme") && Catch::Contains("\"time\"?"));
  CHECK_THROWS_WITH(read(R"({"do":"step","steps":1.5})"), Catch::Contains("whole number"));
  CHECK_THROWS_WITH(read(R"({"do":"set","key":"a","value":"1","side":"c"})"),
                    Catch::Contains("\"a\" or \"b\""));
}

TEST_CASE("the thread carries commands out in order, and what goes wrong is a message") {
  Runner runner(std::make_unique<Workbench>(open()));
  runner.send(command::Step{10});
  runner.send(command::Set{"contact.N", "99"});
  runner.send(command::Set{"contact.N", "9"});
  auto s = runner.settle();
  CHECK(s->a.state->step == 10);
  CHECK(s->a.params.contact.N == 9);
  REQUIRE(s->messages.size() == 1);
  CHECK(s->messages[0].severity == Severity::error);
  runner.send(command::Speed{0});
  runner.send(command::Play{});
  while (runner.latest()->a.state->step < 50) std::this_thread::yield();
  runner.send(command::Pause{});
  s = runner.settle();
  CHECK_FALSE(s->playing);
  Session plain(load_scene(places::scenes() + "/two_boxes.json"));
  for (int i = 0; i < 10; ++i) plain.step();
  plain.set_params(tuned(plain.params(), {"contact.N=9"}));
  while (plain.state().step < s->a.state->step) plain.step();
  CHECK(same_bits(plain.state(), *s->a.state));
}

}  // namespace pabd::test_workbench
