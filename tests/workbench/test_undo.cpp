// SPDX-License-Identifier: MIT
// What a person made does not go without being asked for: it comes back with undo, or a command that would
// end it says so and does nothing.
#include <catch2/catch.hpp>
#include <filesystem>

#include "sim/scene/tuning.h"
#include "tests/support/places.h"
#include "tests/support/temp_folder.h"
#include "tests/workbench/workbench_helpers.h"

namespace pabd::test_undo {

using test::open;
using test::refusal;
namespace fs = std::filesystem;

namespace {

constexpr const char* kBall =
    R"({"do": "add_body", "shape": {"type": "sphere", "radius": 0.2}, "position": [3, 1, 0]})";

// 60 steps, with a ball from step 40 on.
Workbench with_ball() {
  Workbench bench = open();
  bench.apply(command::Step{40});
  bench.apply(command::Edit{kBall});
  bench.apply(command::Step{20});
  return bench;
}

}  // namespace

TEST_CASE("a change in the past is undone with the future that it cut off") {
  Workbench bench = with_ball();
  const State end = bench.run().state();
  bench.apply(command::Seek{0.2});
  const std::size_t moments = bench.run().timeline().size();
  bench.apply(command::Set{"contact.N", "5"});
  CHECK(bench.run().timeline().size() == 13);
  bench.apply(command::Undo{});
  CHECK(bench.run().params().contact.N == 3);
  CHECK(bench.run().timeline().size() == moments);
  CHECK(bench.run().state().step == 12);
  bench.apply(command::Redo{});
  CHECK(bench.run().params().contact.N == 5);
  CHECK(bench.run().timeline().size() == 13);
  bench.apply(command::Undo{});
  bench.apply(command::Seek{1e9});
  CHECK(same_bits(bench.run().state(), end));
  bench.apply(command::Undo{});  // the ball can still be undone, and comes back with what it did
  CHECK(bench.run().model().size() == 3);
  bench.apply(command::Redo{});
  CHECK(same_bits(bench.run().state(), end));
}

TEST_CASE(
    "when the run has gone on, a parameter is undone in place, and the future is one more step of undo") {
  Workbench bench = with_ball();
  bench.apply(command::Seek{0.3});
  bench.apply(command::Set{"contact.N", "5"});
  bench.apply(command::Step{30});
  bench.apply(command::Undo{});
  CHECK(bench.run().params().contact.N == 3);
  CHECK(bench.run().state().step == 48);
  CHECK(bench.run().model().size() == 3);
  REQUIRE(bench.snapshot().can_undo);
  CHECK(bench.snapshot().undo_text == "the run before contact.N");
  bench.apply(command::Undo{});
  CHECK(bench.run().state().step == 18);
  bench.apply(command::Seek{1e9});
  CHECK(bench.run().model().size() == 4);
  bench.apply(command::Redo{});
  CHECK(bench.run().state().step == 48);
  CHECK(bench.run().model().size() == 3);
}

TEST_CASE("a future that nobody laid hands on is no step of undo: it can be computed again") {
  Workbench bench = open();
  bench.apply(command::Step{40});
  bench.apply(command::Seek{0.3});
  bench.apply(command::Set{"contact.N", "5"});
  bench.apply(command::Step{30});
  bench.apply(command::Undo{});
  CHECK(bench.run().params().contact.N == 3);
  CHECK_FALSE(bench.snapshot().can_undo);
}

TEST_CASE("edits, hands and undo itself in the past give nothing up for good") {
  Workbench bench = with_ball();
  const std::size_t moments = bench.run().timeline().size();
  bench.apply(command::Seek{0.2});
  bench.apply(command::Edit{R"({"do": "remove_body", "body": 1})"});
  CHECK(bench.run().model().size() == 2);
  bench.apply(command::Undo{});
  CHECK(bench.run().timeline().size() == moments);
  bench.apply(command::Pull{2, {0, 0, 0}, {1, 3, 0}});
  CHECK(bench.run().timeline().size() == 13);
  bench.apply(command::Step{3});
  bench.apply(command::Undo{});
  CHECK(bench.run().timeline().size() == moments);
  CHECK(bench.run().timeline().pulled() == 0);

  bench.apply(command::Seek{1e9});
  bench.apply(command::Set{"contact.N", "6"});
  bench.apply(command::Step{5});
  bench.apply(command::Seek{0.2});
  bench.apply(command::Set{"contact.kappa", "70"});
  bench.apply(command::Seek{0.1});
  bench.apply(command::Undo{});  // in the past of a past
  bench.apply(command::Undo{});
  while (bench.snapshot().can_redo) bench.apply(command::Redo{});
  while (bench.snapshot().can_undo && !bench.run().timeline().edits()) bench.apply(command::Undo{});
  bench.apply(command::Seek{1e9});
  CHECK(bench.run().model().size() == 4);
}

TEST_CASE("the end of a comparison, held curves and a restart come back with undo") {
  Workbench bench = open();
  bench.apply(command::Step{10});
  bench.apply(command::Compare{{"contact.N=6"}});
  bench.apply(command::Set{"contact.kappa", "33", Side::b});
  bench.apply(command::Step{20});
  const State b = bench.run(Side::b).state();
  bench.apply(command::EndCompare{});
  bench.apply(command::Step{5});
  bench.apply(command::Undo{});
  REQUIRE(bench.comparing());
  CHECK(same_bits(bench.run(Side::b).state(), b));
  CHECK(bench.run(Side::b).params().contact.kappa == 33);
  CHECK(bench.run().state().time == Approx(b.time));
  bench.apply(command::Compare{{"contact.N=7"}});  // again: what B was is undone
  CHECK(bench.run(Side::b).params().contact.N == 7);
  bench.apply(command::Undo{});
  CHECK(bench.run(Side::b).params().contact.N == 6);
  bench.apply(command::Undo{});
  CHECK(bench.run(Side::b).params().contact.kappa != 33);

  bench.apply(command::Hold{});
  for (const char* method : {"sissm", "descent", "newton", "sissm", "descent"})
    bench.apply(command::Hold{method});
  const std::string first = bench.snapshot().held[0].name;
  bench.apply(command::Hold{"newton"});
  CHECK(bench.snapshot().held.size() == 6);
  bench.apply(command::Undo{});
  CHECK(bench.snapshot().held[0].name == first);
  bench.apply(command::DropHeld{});
  CHECK(bench.snapshot().held.empty());
  bench.apply(command::Undo{});
  CHECK(bench.snapshot().held.size() == 6);

  Workbench pulled = open();
  pulled.apply(command::Pull{2, {0, 0, 0}, {1, 3, 0}});
  pulled.apply(command::Step{20});
  pulled.apply(command::Release{});
  const State end = pulled.run().state();
  pulled.apply(command::Restart{});
  CHECK(pulled.run().timeline().size() == 1);
  pulled.apply(command::Undo{});
  CHECK(same_bits(pulled.run().state(), end));
}

TEST_CASE("another scene or recording says what would be gone, until it is saved or forced") {
  const TempFolder folder;
  const std::string stack = places::scenes() + "/stack.json";
  const auto stakes = [&](Workbench& bench, const char* word) {
    CHECK_THAT(refusal(bench, command::Load{stack, {}, false}),
               Catch::Contains("not saved") && Catch::Contains(word));
    CHECK(bench.snapshot().scene->name == "two boxes");
  };
  Workbench bench = open();
  bench.apply(command::Step{25});
  CHECK(bench.snapshot().at_stake.empty());  // can be computed again
  bench.apply(command::Hold{});
  stakes(bench, "1 held curve");
  bench.apply(command::DropHeld{});
  bench.apply(command::Pull{2, {0, 0, 0}, {1, 3, 0}});
  bench.apply(command::Step{5});
  bench.apply(command::Release{});
  stakes(bench, "pulled by hand");
  bench.apply(command::SaveRecording{(folder / "run.pabdrec").string()});
  CHECK(bench.snapshot().at_stake.empty());
  bench.apply(command::Compare{});
  CHECK(bench.snapshot().at_stake.empty());
  bench.apply(command::Set{"contact.N", "6", Side::b});
  bench.apply(command::Set{"contact.N", "5"});
  stakes(bench, "parameters of A and parameters of B");
  bench.apply(command::SavePatch{(folder / "a.json").string()});
  stakes(bench, "parameters of B");  // A's patch does not hold them
  CHECK_THAT(refusal(bench, command::LoadRecording{(folder / "run.pabdrec").string()}),
             Catch::Contains("parameters of B"));
  bench.apply(command::SavePatch{(folder / "b.json").string(), false, Side::b});
  bench.apply(command::Load{stack, {}, false});
  CHECK(bench.snapshot().scene->name == "stack");
}

TEST_CASE("a scene that changes on disk is told of; what this program saved there is no change") {
  const TempFolder folder;
  const std::string path = (folder / "scene.json").string();
  fs::copy_file(places::scenes() + "/two_boxes.json", path);
  const auto later = [&](int seconds) {
    fs::last_write_time(path, fs::file_time_type::clock::now() + std::chrono::seconds(seconds));
  };
  Workbench bench = open(path);
  bench.apply(command::Set{"contact.N", "7"});
  bench.apply(command::Step{4});
  CHECK_FALSE(bench.look_at_file());
  later(10);  // touched only
  CHECK_FALSE(bench.look_at_file());
  bench.apply(command::SaveScene{path, false, true});
  later(20);
  CHECK_FALSE(bench.look_at_file());
  CHECK_FALSE(bench.snapshot().file_changed);
  CHECK(bench.run().state().step == 4);

  std::string text = read_scene_text(path);
  const std::string other = std::string(text).replace(text.find("two boxes"), 9, "new boxes");
  write_bytes(path, other);
  later(30);
  CHECK(bench.look_at_file());
  CHECK(bench.snapshot().file_changed);
  CHECK(bench.snapshot().scene->name == "two boxes");
  bench.apply(command::IgnoreFile{});
  later(40);
  CHECK_FALSE(bench.look_at_file());
  CHECK_FALSE(bench.snapshot().file_changed);
  write_bytes(path, other + " ");
  later(50);
  CHECK(bench.look_at_file());
  write_bytes(path, text);  // as it was after all
  later(60);
  CHECK(bench.look_at_file());
  CHECK_FALSE(bench.snapshot().file_changed);
}

TEST_CASE("loading a scene's file again keeps parameters, how they were changed, B and held curves") {
  const TempFolder folder;
  const std::string path = (folder / "scene.json").string();
  fs::copy_file(places::scenes() + "/two_boxes.json", path);
  Workbench bench = open(path);
  bench.apply(command::Set{"contact.N", "7"});
  bench.apply(command::Compare{{"contact.kappa=44"}});
  bench.apply(command::Step{20});
  bench.apply(command::Hold{});
  bench.apply(command::Edit{kBall});
  const std::string why = refusal(bench, command::Reload{});
  CHECK_THAT(why,
             Catch::Contains("the timeline (22 moments), bodies and joints that were added or removed and 1 "
                             "step of undo"));
  CHECK(bench.run().model().size() == 4);

  const std::string text = read_scene_text(path);
  write_bytes(path, tuned_scene_text(text, path, {},
                                     tuned(bench.snapshot().scene->params, {"contact.friction.static=0.9"})));
  bench.apply(command::Reload{true});
  CHECK(bench.run().state().step == 0);
  CHECK(bench.run().model().size() == 3);
  CHECK(bench.run().params().contact.N == 7);
  CHECK(bench.run().params().contact.mu_static == 0.9);
  REQUIRE(bench.comparing());
  CHECK(bench.run(Side::b).params().contact.kappa == 44);
  CHECK(bench.run(Side::b).params().contact.mu_static == 0.9);
  CHECK(bench.snapshot().held.size() == 1);
  bench.apply(command::Undo{});
  CHECK(bench.run().params().contact.N == 3);
  CHECK(bench.run().params().contact.mu_static == 0.9);  // what the file says now
  write_bytes(path, "{ broken");
  CHECK_THAT(refusal(bench, command::Reload{true}), Catch::Contains("line 1"));
  CHECK(bench.comparing());
}

TEST_CASE("nothing but a scene is written over the scene that is open") {
  const TempFolder folder;
  const std::string path = (folder / "scene.json").string();
  fs::copy_file(places::scenes() + "/two_boxes.json", path);
  Workbench bench = open(path);
  const std::string text = read_scene_text(path);
  CHECK_THAT(refusal(bench, command::SavePatch{path, true}), Catch::Contains("choose another name"));
  CHECK_THAT(refusal(bench, command::SaveRecording{path, true}), Catch::Contains("choose another name"));
  CHECK(read_scene_text(path) == text);
}

}  // namespace pabd::test_undo
