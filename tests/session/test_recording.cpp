// SPDX-License-Identifier: MIT
// A recording is the run again, bit by bit, and nothing that is wrong with the file gets past the reader.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include "app/session/record_parts.h"
#include "app/session/recording.h"
#include "sim/base/error.h"
#include "sim/base/hash.h"
#include "sim/scene/tuning.h"
#include "sim/solver/step_numbers.h"
#include "tests/support/places.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_recording {

namespace {

constexpr std::size_t kPlenty = std::size_t{64} << 20;

std::shared_ptr<const Scene> two_boxes(const std::vector<std::string>& sets = {}) {
  return std::make_shared<const Scene>(load_scene(places::scenes() + "/two_boxes.json", sets));
}

// Steps, parameters, hands, and bodies and joints that come and go.
void play(Run& run, int steps) {
  const auto go = [&](int n) {
    for (int i = 0; i < n; ++i) REQUIRE(run.advance());
  };
  go(steps);
  run.set_params(tuned(run.params(), {"contact.kappa=123.456789012345678", "solver.method=sissm"}));
  run.set_pulls({{2, {0.1, 0.2, 0.3}, {1.0 / 3, 2, 0.1}, 4321.1}});
  go(steps);
  run.set_pulls({});
  AddBody ball;
  ball.shape = Sphere{0.17};
  ball.position = {0.1, 3, 0.3};
  ball.orientation = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  ball.omega = {1, 2, 3};
  run.edit(ball);
  go(steps);
  AddJoint joint;
  joint.type = JointType::hinge;
  joint.i = 3;
  joint.anchor = {0.2, 2.5, 0.4};
  joint.axis = {1, 1, 0};
  run.edit(joint);
  go(steps);
  run.edit(RemoveBody{1});
  go(steps);
}

std::string refusal(const std::string& bytes, const std::shared_ptr<const Scene>& scene) {
  try {
    decode_recording(bytes, "r.rec", scene, kPlenty);
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::bad_input);
    return error.what();
  }
  return "";
}

// The file with a checksum that fits, as somebody makes it who means harm.
std::string resealed(std::string bytes) {
  Hash64 hash;
  hash.add_text(std::string_view(bytes).substr(0, bytes.size() - 16));
  return bytes.replace(bytes.size() - 16, 16, hash.hex());
}

}  // namespace

TEST_CASE("a recording gives the run back, to the last bit, and it goes on as it would have") {
  const auto scene = two_boxes();
  Run run(scene, 1, kPlenty);
  play(run, 70);
  const std::string bytes = encode_recording(run);
  // Exact states are rare: the file is much smaller than they are.
  CHECK(bytes.size() < run.timeline().bytes());
  Run again(two_boxes(), 2, decode_recording(bytes, "r.rec", scene, kPlenty));
  REQUIRE(again.timeline().size() == run.timeline().size());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < run.timeline().size(); ++i) {
    INFO("moment " << i);
    const Moment &a = run.timeline()[i], &b = again.timeline()[i];
    kept += b.state ? 1 : 0;
    CHECK(same_bits(*again.timeline().state(i), *a.state));
    CHECK(differences(*a.params, *b.params).empty());
    CHECK(a.report.residual == b.report.residual);
    CHECK(a.report.min_gap == b.report.min_gap);
    CHECK(a.start == b.start);
    CHECK(a.model->size() == b.model->size());
    CHECK(a.model->joints.size() == b.model->joints.size());
  }
  CHECK(kept < 25);
  CHECK(same_edits(again.timeline().edits().get(), run.timeline().edits().get()));
  CHECK_FALSE(first_difference(again.timeline(), 1));
  for (int i = 0; i < 20; ++i) {
    REQUIRE(run.advance());
    REQUIRE(again.advance());
  }
  CHECK(same_bits(run.state(), again.state()));
  // And a recording of the recording is the same file.
  Run third(scene, 1, decode_recording(bytes, "r.rec", scene, kPlenty));
  CHECK(Run(scene, 1, decode_recording(encode_recording(third), "r", scene, kPlenty)).timeline().size() ==
        third.timeline().size());
}

TEST_CASE("a recording takes along what steps of second order remember") {
  const auto scene = std::make_shared<const Scene>(
      load_scene(places::scenes() + "/double_pendulum.json", {"solver.integrator=bdf2"}));
  Run run(scene, 1, kPlenty);
  for (int i = 0; i < 70; ++i) REQUIRE(run.advance());
  Run again(scene, 1, decode_recording(encode_recording(run), "r.rec", scene, kPlenty));
  REQUIRE(again.state().change.size() == static_cast<std::size_t>(scene->model.size()));
  for (int i = 0; i < 20; ++i) {
    REQUIRE(run.advance());
    REQUIRE(again.advance());
  }
  CHECK(same_bits(run.state(), again.state()));
}

TEST_CASE("a run that forgot its beginning can be recorded") {
  const auto scene = two_boxes();
  Run run(scene, 1, 20000);
  play(run, 30);
  for (int i = 0; i < 500; ++i) REQUIRE(run.advance());
  REQUIRE(run.timeline().forgotten() > 0);
  std::size_t edits = 0;
  for (auto edit = run.timeline().forgotten_edits(); edit; edit = edit->before) ++edits;
  REQUIRE(edits == 3);
  Run again(scene, 1, decode_recording(encode_recording(run), "r.rec", scene, kPlenty));
  CHECK(same_bits(run.state(), again.state()));
  CHECK(again.timeline().forgotten() == run.timeline().forgotten());
  for (int i = 0; i < 5; ++i) {
    REQUIRE(run.advance());
    REQUIRE(again.advance());
  }
  CHECK(same_bits(run.state(), again.state()));
}

TEST_CASE("other scenes, versions and files are refused with what to do") {
  const auto scene = two_boxes();
  Run run(scene, 1, kPlenty);
  for (int i = 0; i < 5; ++i) REQUIRE(run.advance());
  const std::string good = encode_recording(run);
  CHECK(refusal(good, scene).empty());
  CHECK_THAT(refusal(good, two_boxes({"contact.N=9"})), Catch::Contains("it has changed since"));
  const auto other = std::make_shared<const Scene>(load_scene(places::scenes() + "/pyramid.json"));
  CHECK_THAT(refusal(good, other), Catch::StartsWith("r.rec: ") && Catch::Contains("open that scene first"));
  std::string version = good;
  version[8] = kRecordVersion + 1;
  CHECK_THAT(refusal(version, scene), Catch::Contains("version " + std::to_string(kRecordVersion + 1)));
  CHECK_THAT(refusal("{\"actions\": []}", scene), Catch::Contains("no recording"));
  CHECK_THAT(refusal("", scene), Catch::Contains("no recording"));
  CHECK_THAT(refusal(good + "x", scene), Catch::Contains("cut off, or too long"));
}

TEST_CASE("a file that is cut off or damaged anywhere is refused") {
  const auto scene = two_boxes();
  Run run(scene, 1, kPlenty);
  play(run, 3);
  const std::string good = encode_recording(run);
  for (std::size_t n = 0; n < good.size(); ++n) {
    if (refusal(good.substr(0, n), scene).empty()) FAIL("accepted with " << n << " bytes");
  }
  for (std::size_t i = 0; i < good.size(); i += 3) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 1 << i % 8);
    if (refusal(bad, scene).empty()) FAIL("accepted with another bit at " << i);
  }
}

TEST_CASE("damage that the checksum does not show is refused or harmless") {
  const auto scene = two_boxes();
  Run run(scene, 1, kPlenty);
  play(run, 2);
  const std::string good = encode_recording(run);
  int refused = 0, accepted = 0;
  for (std::size_t i = 20; i + 16 < good.size(); ++i) {
    for (const unsigned char value : {0x00, 0xff, 0x80}) {
      std::string bad = good;
      bad[i] = static_cast<char>(value);
      if (bad == good) continue;
      if (refusal(resealed(bad), scene).empty()) {
        ++accepted;  // another number that may be
      } else {
        ++refused;
      }
    }
  }
  CHECK(refused > 1000);
  CHECK(accepted > 0);
}

TEST_CASE("a recording keeps every number of a step, so that nothing that is plotted is 0 after loading") {
  std::set<std::string> other_than_zero;
  for (const auto& [name, sets] : {std::pair<const char*, std::vector<std::string>>{"four_bar", {}},
                                   {"two_boxes", {"solver.iterations=3"}},
                                   {"bridge", {"solver.method=sissm", "solver.halvings=0"}}}) {
    const auto scene =
        std::make_shared<const Scene>(load_scene(places::scenes() + "/" + name + ".json", sets));
    Run run(scene, 1, kPlenty);
    for (int i = 0; i < 40; ++i) REQUIRE(run.advance());
    const Timeline read = decode_recording(encode_recording(run), "r.rec", scene, kPlenty);
    REQUIRE(read.size() == run.timeline().size());
    for (std::size_t i = 0; i < read.size(); ++i) {
      for (const StepNumber& number : step_numbers()) {
        INFO(name << " " << number.name << " of moment " << i);
        const double there = number.value(read[i].report), here = number.value(run.timeline()[i].report);
        CHECK((there == here || (std::isnan(there) && std::isnan(here))));
        if (here != 0) other_than_zero.emplace(number.name);
      }
    }
  }
  for (const char* number : {"drive_work", "friction_excess", "capped_bonds", "halved_bodies", "halvings"})
    CHECK(other_than_zero.contains(number));
}

TEST_CASE("states that come out otherwise are found") {
  const auto scene = two_boxes();
  Run run(scene, 1, kPlenty);
  for (int i = 0; i < 50; ++i) REQUIRE(run.advance());
  const Timeline recorded = decode_recording(encode_recording(run), "r.rec", scene, kPlenty);
  Timeline other(kPlenty);
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    Moment m = recorded[i];
    if (i == 45) m.hash = "0123456789abcdef";  // as another machine would have it
    other.add(std::move(m));
  }
  CHECK_FALSE(first_difference(recorded, 1));
  REQUIRE(first_difference(other, 1));
  CHECK(*first_difference(other, 1) == 45);
}

TEST_CASE("a recording of any length is written and read in parts") {
  // Every edit keeps a state; enough of them for a file that no text of a scene may be as long as.
  const auto scene = std::make_shared<const Scene>(parse_scene(
      R"({ "format": "pabd-scene", "version": 1, "name": "cloud", "gravity": [0, 0, 0],
           "generate": [ { "type": "pile", "count": 20000, "shape": "sphere", "size": [0.2, 0.2, 0.2],
                           "position": [0, 0, 0] } ] })",
      "cloud", "."));
  constexpr std::size_t budget = std::size_t{400} << 20;
  Run run(scene, 2, budget);
  for (int i = 0; i < 25; ++i) {
    AddBody ball;
    ball.shape = Sphere{0.1};
    ball.position = {1000.0 + i, 0, 0};
    run.edit(ball);
  }
  REQUIRE(run.advance());
  const TempFolder folder;
  const std::string path = folder / "long.rec";
  std::ofstream file(path, std::ios::binary);
  std::size_t largest = 0;
  write_recording(run, [&](std::string_view part) {
    largest = std::max(largest, part.size());
    file.write(part.data(), static_cast<std::streamsize>(part.size()));
  });
  file.close();
  CHECK(std::filesystem::file_size(path) > std::size_t{68} << 20);
  CHECK(largest < std::size_t{1} << 20);
  const Timeline again = read_recording(path, scene, budget);
  REQUIRE(again.size() == run.timeline().size());
  CHECK(same_bits(*again.back().state, run.state()));
  CHECK(again.back().model->size() == 20025);

  // Damage at its far end is seen, and that it is cut off.
  std::fstream damaged(path, std::ios::binary | std::ios::in | std::ios::out);
  damaged.seekp(-1000, std::ios::end);
  damaged.put('\x55').put('\x2a');
  damaged.close();
  CHECK_THROWS_WITH(read_recording(path, scene, budget), Catch::Contains("checksum"));
  std::filesystem::resize_file(path, std::size_t{67} << 20);
  CHECK_THROWS_WITH(read_recording(path, scene, budget), Catch::Contains("cut off"));
}

}  // namespace pabd::test_recording
