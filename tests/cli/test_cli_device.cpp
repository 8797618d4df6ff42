// SPDX-License-Identifier: MIT
// --device: the same run on the GPU, who is chosen, and what is refused. Here a GPU may be software: what is tested of
// it is what it says and whether it agrees, not how fast it is.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/cli/device_option.h"
#include "tests/cli/program.h"

using namespace pabd::test;
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
  const TempFolder folder;
  const Outcome gpu = run_pabd({"run", "pyramid", "--steps", "8", "--device", "gpu", "--quiet", "--json",
                                "--trace", folder / "gpu.csv", "--state", folder / "end.json"});
  CAPTURE(gpu.err);
  REQUIRE(gpu.exit_code == 0);
  const Outcome cpu =
      run_pabd({"run", "pyramid", "--steps", "8", "--quiet", "--json", "--trace", folder / "cpu.csv"});
  REQUIRE(cpu.exit_code == 0);
  // Neither has the solver's end in the steps of the first shock. Where it comes to rest is the same: to a
  // thousandth of the energy that was exchanged on the way.
  const auto a = energies(folder / "gpu.csv"), b = energies(folder / "cpu.csv");
  REQUIRE(a.size() == 8);
  REQUIRE(b.size() == 8);
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
  const json end = json::parse(read_text(folder / "end.json"));
  CHECK(summary.at("state") == end.at("hash"));
  CHECK_FALSE(end.at("anchors").empty());
  const Outcome on = run_pabd({"run", "pyramid", "--from", folder / "end.json", "--steps", "4", "--quiet",
                               "--json", "--trace", folder / "on.csv"});
  CAPTURE(on.err);
  REQUIRE(on.exit_code == 0);
  CHECK(json::parse(on.out)["time"].get<double>() == Approx(1.5 * summary["time"].get<double>()));
  for (const auto& row : energies(folder / "on.csv"))
    CHECK(row[0] + row[1] + row[2] == Approx(a[7][0] + a[7][1] + a[7][2]).epsilon(1e-3));
}

TEST_CASE("solved to the end, every step on the GPU has the energies of the processor") {
  const TempFolder folder;
  const auto run = [&](const char* device) {
    const std::string trace = folder / (std::string(device) + ".csv");
    REQUIRE(run_pabd({"run", "stack", "--steps", "20", "--set", "solver.iterations=400", "--device", device,
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
  const TempFolder folder;
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
  refused({"run", "bridge", "--trace", trace}, {"bridge: ", "joints", "--device cpu"});
  refused({"run", "stack", "--set", "contact.barrier=log"}, {"stack: ", "log barrier", "--device cpu"});
  refused({"run", "stack", "--set", "solver.method=sissm"}, {"not by sissm", "--set solver.method=auto"});
  refused({"run", "stack", "--iterations", trace}, {"iterations", "--device cpu"});
  refused({"run", "stack", "--joints", trace}, {"joints", "--device cpu"});
  refused({"bench", "stack", "bridge"}, {"bridge: ", "joints", "--device cpu"});
  refused({"bench", "stack", "--solvers"}, {"--solvers"});
  refused({"render", "bridge", "-o", folder / "a.png"}, {"bridge: ", "joints", "--device cpu"});
  refused({"render", "stack", "-o", folder / "a.png", "--overlay", "convergence"},
          {"iterations", "--device cpu"});
  refused({"run", "stack", "--trace", trace}, {"--device gpu: ", "OpenGL 4.1", "--device cpu"}, 4,
          old_driver());
  refused({"render", "stack", "-o", folder / "a.png", "--backend", "egl"},
          {"--device gpu: --device cpu, or: ", "EGL"}, 4, software());
  const Outcome word = run_pabd({"run", "stack", "--device", "tpu"});
  CHECK(word.exit_code == 2);
  CHECK(is_error_line(word.err, {"--device", "tpu", "cpu", "gpu", "auto"}));
  // What can be wound back is the processor's.
  CHECK(run_pabd({"view", "stack", "--device", "gpu"}).exit_code == 2);
  CHECK(run_pabd({"plot", "convergence", "stack", "-o", folder / "a.svg", "--device", "gpu"}).exit_code == 2);
}

TEST_CASE("auto takes the processor for few bodies, for what only it can do, and in place of software") {
  const TempFolder folder;
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
  const TempFolder folder;
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
  const TempFolder folder;
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
  const TempFolder folder;
  write_text(folder / "ball.json", kBall);
  for (const auto& [first, second] : {std::pair("gpu", "cpu"), std::pair("cpu", "gpu")}) {
    const auto render = [&](const char* device) {
      return run_pabd({"render", folder / "ball.json", "-o", folder / (std::string(first) + "{frame}.png"),
                       "--frames", "2", "--size", "64x36", "--resume", "--device", device});
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
  const TempFolder folder;
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

TEST_CASE("the doctor tells whether there is a GPU for the steps, and for how many bodies") {
  const Outcome yes = run_pabd({"doctor"}, software());
  CHECK(yes.out.find("\nGPU solver  yes: ") != std::string::npos);
  CHECK(yes.out.find("; software: for tests only\n") != std::string::npos);
  const json here = json::parse(run_pabd({"doctor", "--json"}, software()).out)["gpu_solver"];
  CHECK(here["available"] == true);
  CHECK(here["hardware"] == false);
  CHECK(here["bodies"].get<std::int64_t>() == here["largest_buffer_bytes"].get<std::int64_t>() / 1024);
  const Outcome no = run_pabd({"doctor"}, old_driver());
  CHECK(no.out.find("\nGPU solver  no: ") != std::string::npos);
  CHECK(no.out.find("needs 4.3") != std::string::npos);
  CHECK(json::parse(run_pabd({"doctor", "--json"}, old_driver()).out)["gpu_solver"]["available"] == false);
}
