// SPDX-License-Identifier: MIT
// --device: the same run on the GPU, who is chosen, and what is refused. Here a GPU may be software: what is tested of
// it is what it says and whether it agrees, not how fast it is.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/cli/device_option.h"
#include "tests/cli/program.h"

namespace pabd::test_cli_device {

using namespace test;
using nlohmann::json;

namespace {

constexpr const char* kBall = R"({"format": "pabd-scene", "version": 1, "bodies": [
  {"shape": {"type": "plane", "normal": [0, 1, 0], "offset": 0}, "fixed": true},
  {"name": "ball", "shape": {"type": "sphere", "radius": 0.5}, "position": [0, 0.52, 0], "velocity": [1, 0, 0]}]})";

// kinetic, potential and elastic energy of every step of a trace.
std::vector<std::vector<double>> energies(const std::string& trace) {
  std::vector<std::vector<double>> out;
  for (const std::string& row : lines_of(read_text(trace))) {
    if (row.starts_with("step,")) continue;
    std::istringstream in(row);
    std::vector<std::string> fields;
    for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
    out.push_back({std::stod(fields.at(5)), std::stod(fields.at(6)), std::stod(fields.at(7))});
  }
  return out;
}

// Nothing but Mesa's OSMesa, which is software.
Setting software() {
  Setting setting;
  setting.environment = {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent"}};
  return setting;
}
// A driver without compute shaders.
Setting old_driver() {
  Setting setting = software();
  setting.environment["MESA_GL_VERSION_OVERRIDE"] = "4.1";
  return setting;
}

std::string balls_on_a_grid(int side) {
  std::string bodies;
  for (int i = 0; i < side * side; ++i)
    bodies += std::string(i == 0 ? "" : ",") +
              R"({"shape": {"type": "sphere", "radius": 0.1}, "position": [)" + std::to_string(i % side) +
              ", 1, " + std::to_string(i / side) + "]}";
  return R"({"format": "pabd-scene", "version": 1, "bodies": [)" + bodies + "]}";
}

}  // namespace

TEST_CASE("a run on the GPU agrees with one on the processor, and the processor goes on from its end") {
  const CommandFolder folder;
  const auto run = [&](const std::string& device) {  // sweeps through twenty levels of bricks
    return run_pabd({"run", "pyramid", "--steps", "8", "--set", "solver.iterations=200", "--set",
                     "solver.integrator=euler", "--device", device, "--quiet", "--json", "--trace",
                     folder / (device + ".csv"), "--state", folder / (device + ".json")});
  };
  const Outcome gpu = run("gpu"), cpu = run("cpu");
  CAPTURE(gpu.err);
  REQUIRE((gpu.exit_code == 0 && cpu.exit_code == 0));
  // Neither has the solver's end in the steps of the first shock. Where it comes to rest is the same: to a
  // thousandth of the energy that was exchanged on the way.
  const auto a = energies(folder / "gpu.csv"), b = energies(folder / "cpu.csv");
  REQUIRE((a.size() == 8 && b.size() == 8));
  double exchanged = 0;
  for (const auto& row : b) exchanged = std::max(exchanged, row[0]);
  REQUIRE(exchanged < 1e-3 * b[7][1]);
  for (std::size_t e = 0; e < 3; ++e) {
    CAPTURE(e, exchanged);
    CHECK(a[7][e] == Approx(b[7][e]).margin(1e-3 * exchanged).epsilon(0));
  }
  const json summary = json::parse(gpu.out);
  CHECK(summary["device"] == json::parse(run_pabd({"doctor", "--json"}).out)["gl"]["renderer"]);
  CHECK(json::parse(cpu.out)["device"] == "cpu");
  const json end = json::parse(read_text(folder / "gpu.json"));
  CHECK(summary.at("state") == end.at("hash"));
  CHECK_FALSE(end.at("anchors").empty());
  const Outcome on = run_pabd({"run", "pyramid", "--from", folder / "gpu.json", "--steps", "4", "--quiet",
                               "--json", "--trace", folder / "on.csv"});
  CAPTURE(on.err);
  REQUIRE(on.exit_code == 0);
  CHECK(json::parse(on.out)["time"].get<double>() == Approx(1.5 * summary["time"].get<double>()));
  for (const auto& row : energies(folder / "on.csv"))
    CHECK(row[0] + row[1] + row[2] == Approx(a[7][0] + a[7][1] + a[7][2]).epsilon(1e-3));
}

TEST_CASE("solved to the end, every step on the GPU has the energies of the processor") {
  const CommandFolder folder;
  const auto run = [&](const char* device) {
    const std::string trace = folder / (std::string(device) + ".csv");
    REQUIRE(run_pabd({"run", "stack", "--steps", "20", "--set", "solver.method=descent", "--set",
                      "solver.iterations=400", "--set", "solver.tolerance=1e-9", "--device", device,
                      "--quiet", "--trace", trace})
                .exit_code == 0);
    return energies(trace);
  };
  const auto gpu = run("gpu"), cpu = run("cpu");
  REQUIRE(gpu.size() == 20);
  REQUIRE(cpu.size() == 20);
  for (std::size_t k = 0; k < 20; ++k) {
    CAPTURE(k);
    for (std::size_t e = 0; e < 3; ++e) CHECK(gpu[k][e] == Approx(cpu[k][e]).epsilon(1e-3));
  }
}

TEST_CASE("the GPU refuses what it does not take, with the remedy and before the first step") {
  const CommandFolder folder;
  const std::string trace = folder / "t.csv";
  const auto refused = [&](std::vector<std::string> command, const std::vector<std::string>& words,
                           int code = 2, const Setting& setting = {}) {
    for (const char* word : {"--device", "gpu"}) command.emplace_back(word);
    const Outcome outcome = run_pabd(command, setting);
    CAPTURE(command, outcome.err);
    CHECK(outcome.exit_code == code);
    CHECK(is_error_line(outcome.err, words));
    CHECK(folder.names().empty());
  };
  refused({"run", "pendulum", "--trace", trace}, {"pendulum: ", "joints", "--device cpu"});
  refused({"run", "stack", "--set", "contact.barrier=log"}, {"stack: ", "log barrier", "--device cpu"});
  refused({"run", "stack", "--set", "solver.method=sissm"}, {"not by sissm", "--set solver.method=auto"});
  refused({"run", "stack", "--iterations", trace}, {"iterations", "--device cpu"});
  refused({"bench", "stack", "pendulum"}, {"pendulum: ", "joints", "--device cpu"});
  refused({"bench", "stack", "--solvers"}, {"--solvers"});
  refused({"render", "pendulum", "-o", folder / "a.png"}, {"pendulum: ", "joints", "--device cpu"});
  refused({"render", "stack", "-o", folder / "a.png", "--overlay", "convergence"},
          {"iterations", "--device cpu"});
  refused({"run", "stack", "--trace", trace}, {"--device gpu: ", "OpenGL 4.1", "--device cpu"}, 4,
          old_driver());
  refused({"render", "stack", "-o", folder / "a.png", "--backend", "egl"},
          {"--device gpu: --device cpu, or: ", "EGL"}, 4, software());
  const Outcome word = run_pabd({"run", "stack", "--device", "tpu"});
  CHECK(word.exit_code == 2);
  CHECK(is_error_line(word.err, {"--device", "tpu", "cpu", "gpu", "auto"}));
  write_text(folder / "window.json", "[]");
  const std::vector<std::string> script = {"--headless", "--script", folder / "window.json", "-o",
                                           folder / "out"};
  const auto window = [&](const char* scene, int code, const std::vector<std::string>& words,
                          const Setting& setting) {
    std::vector<std::string> command = {"view", scene, "--device", "gpu"};
    command.insert(command.end(), script.begin(), script.end());
    const Outcome outcome = run_pabd(command, setting);
    CAPTURE(scene, outcome.err);
    CHECK(outcome.exit_code == code);
    CHECK(is_error_line(outcome.err, words));
  };
  window("pendulum", 2, {"pendulum.json: all bodies of the scene hang on joints", "solver.device=cpu"}, {});
  window("stack", 4, {"OpenGL 4.1", "solver.device=cpu"}, old_driver());
  // What compares solvers is the processor's.
  CHECK(run_pabd({"plot", "convergence", "stack", "-o", folder / "a.svg", "--device", "gpu"}).exit_code == 2);
}

TEST_CASE("a scene says who makes its steps, and --device goes before it") {
  const CommandFolder folder;
  const std::string name = json::parse(run_pabd({"doctor", "--json"}).out)["gl"]["renderer"];
  std::string text = kBall;
  text.insert(text.find("\"bodies\""), R"("solver": {"device": "gpu"}, )");
  write_text(folder / "ball.json", kBall);
  write_text(folder / "gpu.json", text);
  const auto device = [&](const std::string& scene, std::vector<std::string> more) {
    std::vector<std::string> command = {"run", folder / scene, "--steps", "3", "--quiet", "--json"};
    command.insert(command.end(), more.begin(), more.end());
    const Outcome outcome = run_pabd(command);
    CAPTURE(scene, more, outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return json::parse(outcome.out);
  };
  CHECK(device("ball.json", {})["device"] == "cpu");
  CHECK(device("gpu.json", {})["device"] == name);
  CHECK(device("ball.json", {"--set", "solver.device=gpu"})["device"] == name);
  CHECK(device("gpu.json", {"--set", "solver.device=auto"})["device"] == "cpu");
  const json on_cpu = device("gpu.json", {"--device", "cpu"});
  CHECK(on_cpu["device"] == "cpu");
  CHECK(on_cpu["scene_hash"] == device("ball.json", {})["scene_hash"]);
  CHECK(on_cpu["state"] == device("ball.json", {})["state"]);
  // Refused in the words of who asked.
  const Outcome joints = run_pabd({"run", "pendulum", "--steps", "1", "--set", "solver.device=gpu"});
  CHECK(joints.exit_code == 2);
  CHECK(is_error_line(joints.err, {"pendulum: ", "joints", "--device cpu"}));
  const Outcome old = run_pabd({"run", folder / "gpu.json", "--steps", "1"}, old_driver());
  CHECK(old.exit_code == 4);
  CHECK(is_error_line(old.err, {"solver.device gpu: ", "OpenGL 4.1", "--device cpu"}));
  const Outcome word = run_pabd({"run", folder / "ball.json", "--set", "solver.device=tpu"});
  CHECK(word.exit_code == 2);
  CHECK(is_error_line(word.err, {"/solver/device", "cpu", "gpu", "auto"}));
  // A on the processor, B on the GPU: frames of both.
  write_text(folder / "b.json", R"({"solver": {"device": "gpu"}})");
  const Outcome ab = run_pabd({"render", folder / "ball.json", "-o", folder / "ab.png", "--time", "0.1",
                               "--size", "320x180", "--ab", folder / "b.json"});
  CAPTURE(ab.err);
  CHECK(ab.exit_code == 0);
  CHECK(ab.err.find("steps of A by the processor, of B by " + name) != std::string::npos);
  CHECK(read_text(folder / "ab.png").find("Device of B") != std::string::npos);
}

TEST_CASE("joints are the processor's beside the GPU's contacts, until something couples the two") {
  const CommandFolder folder;
  const Outcome apart = run_pabd(
      {"run", "bridge", "--steps", "20", "--device", "gpu", "--joints", folder / "gpu.csv", "--quiet"});
  CAPTURE(apart.err);
  REQUIRE(apart.exit_code == 0);
  const Outcome cpu = run_pabd({"run", "bridge", "--steps", "20", "--joints", folder / "cpu.csv", "--quiet"});
  REQUIRE(cpu.exit_code == 0);
  CHECK(read_text(folder / "gpu.csv") == read_text(folder / "cpu.csv"));
  const Outcome meets = run_pabd({"run", "bridge", "--time", "3", "--device", "gpu", "--quiet"});
  CHECK(meets.exit_code == 2);
  CHECK(is_error_line(meets.err, {"at t = ", "comes near", "--device cpu, or --device auto"}));
}

TEST_CASE("auto takes the processor for few bodies, for what only it can do, and in place of software") {
  const CommandFolder folder;
  const Outcome few = run_pabd({"run", "stack", "--steps", "1", "--device", "auto"});
  CHECK(few.exit_code == 0);
  CHECK(few.err.find("by the processor: 10 bodies move, fewer than 10000") != std::string::npos);
  write_text(folder / "many.json", balls_on_a_grid(142));
  const Outcome many =
      run_pabd({"run", folder / "many.json", "--steps", "1", "--device", "auto"}, software());
  CAPTURE(many.err);
  CHECK(many.exit_code == 0);
  CHECK(many.err.find("by the processor: ") != std::string::npos);
  CHECK(many.err.find("is no GPU") != std::string::npos);
  const Outcome other = run_pabd(
      {"run", folder / "many.json", "--steps", "1", "--device", "auto", "--set", "solver.method=sissm"});
  CHECK(other.err.find("by the processor: the GPU solves by descent, not by sissm · ") != std::string::npos);
  const Outcome said = run_pabd({"run", "stack", "--steps", "1", "--device", "auto", "--quiet", "--json"});
  CHECK(json::parse(said.out)["device"] == "cpu");
}

TEST_CASE("auto takes a GPU that is one, and has room, for enough bodies") {
  using pabd::cli::kFewestOnGpu;
  using pabd::cli::why_processor;
  pabd::DeviceCapacity gpu;
  gpu.renderer = "GPU";
  gpu.hardware = true;
  gpu.bodies = 1000000;
  CHECK(why_processor(kFewestOnGpu, gpu).empty());
  CHECK_FALSE(why_processor(kFewestOnGpu - 1, gpu).empty());
  CHECK(why_processor(1000000, gpu).empty());
  CHECK(why_processor(1000001, gpu).find("room for about 1000000 bodies") != std::string::npos);
  pabd::DeviceCapacity slow = gpu, old = gpu;
  slow.hardware = false;
  CHECK(why_processor(kFewestOnGpu, slow) == "GPU is no GPU");
  old.why_not = "OpenGL 4.1";
  CHECK(why_processor(kFewestOnGpu, old).find("cannot take it") != std::string::npos);
}

TEST_CASE("the table of a bench names the GPU and the scenes that it took") {
  const CommandFolder folder;
  write_text(folder / "ball.json", kBall);
  const Outcome outcome = run_pabd({"bench", folder / "ball.json", "--steps", "5", "--repeat", "2",
                                    "--device", "gpu", "--json", folder / "bench.json"});
  CAPTURE(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const std::string name = json::parse(run_pabd({"doctor", "--json"}).out)["gl"]["renderer"];
  CHECK(outcome.out.find("\nsteps by " + name + "  \n") != std::string::npos);
  const json row = json::parse(read_text(folder / "bench.json"))["scenes"][0];
  CHECK(row["device"] == name);
  CHECK(row["steps"] == 5);
  CHECK(run_pabd({"bench", "stack", "--steps", "1"}).out.find("steps by") == std::string::npos);
}

TEST_CASE("a picture of a run on the GPU is that of the processor, and says where it comes from") {
  const CommandFolder folder;
  write_text(folder / "ball.json", kBall);
  const auto render = [&](const char* device, const std::string& out, std::vector<std::string> more) {
    std::vector<std::string> command = {
        "render", folder / "ball.json", "-o", out, "--time", "0.3", "--size", "320x180", "--device", device};
    command.insert(command.end(), more.begin(), more.end());
    const Outcome outcome = run_pabd(command);
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return outcome.err;
  };
  const std::string words = render("gpu", folder / "gpu.png", {});
  render("cpu", folder / "cpu.png", {});
  CHECK(words.find("steps by ") != std::string::npos);
  const Outcome compared = run_pabd({"compare", folder / "gpu.png", folder / "cpu.png"});
  CAPTURE(compared.out, compared.err);
  CHECK(compared.exit_code == 0);
  CHECK(read_text(folder / "gpu.png").find("Device") != std::string::npos);
  CHECK(read_text(folder / "cpu.png").find("Device") == std::string::npos);
  // Two runs side by side have an engine each.
  write_text(folder / "b.json", R"({"gravity": [0, 0, 0]})");
  render("gpu", folder / "ab_gpu.png", {"--ab", folder / "b.json"});
  render("cpu", folder / "ab_cpu.png", {"--ab", folder / "b.json"});
  CHECK(run_pabd({"compare", folder / "ab_gpu.png", folder / "ab_cpu.png"}).exit_code == 0);
}

TEST_CASE("frames of the GPU are not continued by the processor, nor the other way round") {
  const CommandFolder folder;
  write_text(folder / "ball.json", kBall);
  for (const auto& [first, second] : {std::pair("gpu", "cpu"), std::pair("cpu", "gpu")}) {
    const auto render = [&folder, named = std::string(first)](const char* device) {
      return run_pabd({"render", folder / "ball.json", "-o", folder / (named + "{frame}.png"), "--frames",
                       "2", "--size", "64x36", "--resume", "--device", device});
    };
    REQUIRE(render(first).exit_code == 0);
    CHECK(render(first).exit_code == 0);
    const Outcome other = render(second);
    CAPTURE(first, other.err);
    CHECK(other.exit_code == 2);
    CHECK(is_error_line(other.err, {"--resume", "another run", "'Device'"}));
  }
}

TEST_CASE("the plots of a run on the GPU are of its own steps") {
  const CommandFolder folder;
  const auto render = [&](const char* device, const char* name) {
    REQUIRE(run_pabd({"render", "stack", "-o", folder / name, "--time", "0.3", "--size", "640x360",
                      "--overlay", "series,contacts", "--set", "solver.iterations=5", "--device", device})
                .exit_code == 0);
  };
  render("gpu", "gpu.png");
  render("cpu", "cpu.png");
  render("cpu", "again.png");
  CHECK(run_pabd({"compare", folder / "again.png", folder / "cpu.png"}).exit_code == 0);
  CHECK(run_pabd({"compare", folder / "gpu.png", folder / "cpu.png"}).exit_code == 7);
}

TEST_CASE(
    "the window's simulation runs on the GPU, is wound back, tuned, edited and taken over by the processor") {
  const CommandFolder folder;
  write_text(folder / "ball.json", kBall);
  write_text(folder / "script.json", R"([
    {"do": "expect", "at": "/a/params/solver/device", "is": "gpu"},
    {"do": "expect", "at": "/a/device/name", "is_not": ""},
    {"do": "step", "steps": 20},
    {"do": "expect", "at": "/a/report/status", "is": "converged"},
    {"do": "expect", "at": "/a/device/why", "is": ""},
    {"do": "print", "at": "/a/bodies/1/position/0"},
    {"do": "step", "steps": -10},
    {"do": "expect", "at": "/a/step", "is": 10},
    {"do": "set", "key": "gravity.0", "value": 3},
    {"do": "step", "steps": 10},
    {"do": "expect", "at": "/a/step", "is": 20},
    {"do": "print", "at": "/a/bodies/1/position/0"},
    {"do": "edit", "edit": {"do": "add_body", "shape": {"type": "sphere", "radius": 0.2}, "position": [0, 3, 0]}},
    {"do": "step", "steps": 5},
    {"do": "expect", "at": "/a/device/name", "is_not": ""},
    {"do": "expect", "at": "/a/bodies/2/position/1", "below": 2.99},
    {"do": "set", "key": "solver.device", "value": "cpu"},
    {"do": "step", "steps": 5},
    {"do": "expect", "at": "/a/device/name", "is": ""},
    {"do": "set", "key": "solver.device", "value": "gpu"},
    {"do": "step", "steps": 5},
    {"do": "expect", "at": "/a/device/name", "is_not": ""},
    {"do": "expect", "at": "/a/gone", "is": 0},
    {"do": "set", "key": "contact.barrier", "value": "log"},
    {"do": "step", "steps": 1},
    {"do": "expect", "at": "/a/device/why", "contains": "log barrier"},
    {"do": "expect", "at": "/message", "contains": "the processor makes the steps: "} ])");
  const auto window = [&](const char* device) {
    return run_pabd({"view", folder / "ball.json", "--device", device, "--headless", "--script",
                     folder / "script.json", "-o", folder / "out"});
  };
  const Outcome gpu = window("gpu");
  CAPTURE(gpu.err);
  REQUIRE(gpu.exit_code == 0);
  // The ball goes as on the processor, before and after the change.
  write_text(folder / "cpu.json", R"([
    {"do": "step", "steps": 20}, {"do": "print", "at": "/a/bodies/1/position/0"},
    {"do": "step", "steps": -10}, {"do": "set", "key": "gravity.0", "value": 3},
    {"do": "step", "steps": 10}, {"do": "print", "at": "/a/bodies/1/position/0"} ])");
  const Outcome cpu = run_pabd(
      {"view", folder / "ball.json", "--headless", "--script", folder / "cpu.json", "-o", folder / "out"});
  REQUIRE(cpu.exit_code == 0);
  const auto places = [](const std::string& out) {
    std::vector<double> at;
    for (const std::string& line : lines_of(out)) at.push_back(std::stod(line.substr(line.rfind(' '))));
    return at;
  };
  const auto a = places(gpu.out), b = places(cpu.out);
  REQUIRE(a.size() == 2);
  REQUIRE(b.size() == 2);
  for (std::size_t k = 0; k < 2; ++k) CHECK(a[k] == Approx(b[k]).epsilon(1e-4));
  CHECK(a[1] > a[0] + 0.01);
}

TEST_CASE("the doctor tells whether there is a GPU for the steps, and for how many bodies") {
  const Outcome yes = run_pabd({"doctor"}, software());
  CHECK(yes.out.find("\nGPU solver  not tried: ") != std::string::npos);
  CHECK(yes.out.find("; software: for tests only; 'pabd run drop --dev") != std::string::npos);
  const json here = json::parse(run_pabd({"doctor", "--json"}, software()).out)["gpu_solver"];
  CHECK(here["available"] == true);
  CHECK(here["hardware"] == false);
  CHECK(here["bodies"].get<std::int64_t>() == here["largest_buffer_bytes"].get<std::int64_t>() / 1024);
  const Outcome no = run_pabd({"doctor"}, old_driver());
  CHECK(no.out.find("\nGPU solver  no: ") != std::string::npos);
  CHECK(no.out.find("needs 4.3") != std::string::npos);
  CHECK(json::parse(run_pabd({"doctor", "--json"}, old_driver()).out)["gpu_solver"]["available"] == false);
}

}  // namespace pabd::test_cli_device
