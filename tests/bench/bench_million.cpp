// SPDX-License-Identifier: MIT
// Bodies that are solved and drawn on the GPU, their state never on the processor: ms a frame of a step, of a picture,
// of both, and of both with the picture read back.
//
//   bench_million [towers|avalanche] N frames [--png|--jpg DIR every] [--size W H] [--close] [--shadow SIDE] [--steps K] [--sweeps K]
//                [--halvings K] [--kappa J] [--team K] [--color speed|energy] [--contacts]
//
// towers: columns of ten boxes and a ball of steel that rolls through them. avalanche: boxes, balls, capsules and hulls
// on a slope. --png and --jpg write every so many frames of the last run. --close looks at where things happen first. --shadow:
// texels of a side of the shadow map, 4096. --steps: of a frame of 1/60 s, 4 for towers, else 1. --sweeps: of a step,
// 10. --halvings: of a step that ends unsolved, 0. --kappa: stiffness of contacts. --team: threads that share a body in a sweep. --color: by a number that stays on
// the GPU; in each frame its largest comes back, for the range. --contacts: their glyphs. Every run starts anew.
// Also: indices that a picture draws, ms of a pick in the middle of it, and of the same after reading the state.
#include <fmt/format.h>
#include <stb_image_write.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/device/compute_functions.h"
#include "render/device/device_bodies.h"
#include "render/device/device_marks.h"
#include "render/device/device_pick.h"
#include "render/device/device_solver.h"
#include "render/gl/renderer.h"
#include "render/output/png.h"
#include "render/visual/body_parts.h"
#include "render/visual/framing.h"
#include "render/visual/palette.h"
#include "render/visual/value_map.h"
#include "sim/base/error.h"
#include "tests/bench/device_settings.h"
#include "tests/device/drawn_commands.h"

using namespace pabd;
using namespace pabd::bench;

namespace {

struct Options {
  bool avalanche = false, close = false;
  int bodies = 0, frames = 0, steps = 0, sweeps = 10, halvings = 0;
  int width = 1920, height = 1080, shadow = 4096;
  double kappa = 0;  // J; 0: as the setting has it
  DeviceOptions device;
  std::string folder;
  int every = 0;
  bool jpg = false;
  std::optional<BodyQuantity> color;
};

Options parse(int argc, char** argv) {
  Options out;
  std::vector<int> numbers;
  const auto next = [&](int& k) {
    if (k + 1 >= argc) throw Error(ErrorKind::bad_input, std::string(argv[k]) + " needs a value");
    return std::string(argv[++k]);
  };
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    if (word == "towers" || word == "avalanche") {
      out.avalanche = word == "avalanche";
    } else if (word == "--png" || word == "--jpg") {
      out.jpg = word == "--jpg";
      out.folder = next(k);
      out.every = std::max(1, std::atoi(next(k).c_str()));
    } else if (word == "--size") {
      out.width = std::atoi(next(k).c_str());
      out.height = std::atoi(next(k).c_str());
    } else if (word == "--close") {
      out.close = true;
    } else if (word == "--shadow") {
      out.shadow = std::atoi(next(k).c_str()) / 8 * 8;
    } else if (word == "--color") {
      out.color = next(k) == "energy" ? BodyQuantity::energy : BodyQuantity::speed;
    } else if (word == "--contacts") {
      out.device.report_contacts = true;
    } else if (word == "--kappa") {
      out.kappa = std::atof(next(k).c_str());
    } else if (word == "--team") {
      out.device.team = std::clamp(std::atoi(next(k).c_str()), 1, 32);
    } else if (word == "--sweeps") {
      out.sweeps = std::max(1, std::atoi(next(k).c_str()));
    } else if (word == "--halvings") {
      out.halvings = std::max(0, std::atoi(next(k).c_str()));
    } else if (word == "--steps") {
      out.steps = std::max(1, std::atoi(next(k).c_str()));
    } else {
      numbers.push_back(std::atoi(argv[k]));
    }
  }
  if (numbers.size() != 2 || numbers[0] < 1 || numbers[1] < 1 || out.width < 1 || out.height < 1) {
    throw Error(
        ErrorKind::bad_input,
        "expected: bench_million [towers|avalanche] N frames [--png|--jpg DIR every] [--size W H] [--close] "
        "[--shadow SIDE] [--steps K] [--sweeps K] [--halvings K] [--kappa J] [--team K] "
        "[--color speed|energy] [--contacts]");
  }
  out.device.time_phases = true;
  out.bodies = numbers[0];
  out.frames = numbers[1];
  return out;
}

// The scene without its bodies: floors, light, and a camera that sees where things happen.
VisualScene bare_scene(const Setting& setting, const Options& options) {
  VisualScene scene;
  add_grounds(setting.model, scene);
  const Vec3 middle = 0.5 * (setting.lowest + setting.highest), size = setting.highest - setting.lowest;
  scene.centre = middle.cast<float>();
  scene.radius = static_cast<float>(0.5 * size.norm());
  Vec3 lowest = setting.lowest, highest = setting.highest;
  if (options.close) {  // where the ball comes in, or the lower end of what slides
    const Vec3 at = options.avalanche ? Vec3(middle.x() - 0.1 * size.x(), 0.3 * size.y(), 0)
                                      : Vec3(setting.lowest.x() + 0.15 * size.x(), 0, middle.z());
    lowest = at - 0.1 * size;
    highest = at + 0.1 * size;
    lowest.y() = std::max(lowest.y(), setting.lowest.y());
    if (!options.avalanche) highest.y() = setting.highest.y();
  }
  std::vector<Spot> spots;
  for (int k = 0; k < 8; ++k) {
    spots.push_back({Vec3((k & 1) != 0 ? highest.x() : lowest.x(), (k & 2) != 0 ? highest.y() : lowest.y(),
                          (k & 4) != 0 ? highest.z() : lowest.z()),
                     0});
  }
  Camera like = pleasing_side();
  like.eye = options.avalanche
                 ? Vec3f(std::abs(like.eye.x()) + 0.3f, like.eye.y(), like.eye.z())  // from below
                 : Vec3f(-0.6f, 0.75f, 0.8f);  // down into the lane of the ball
  scene.camera = fit_camera(spots, like, static_cast<double>(options.width) / options.height);
  return scene;
}

// The palette's colours, and the ball in that of steel.
BodyParts parts_of(const Setting& setting, const Options& options) {
  BodyParts parts = body_parts(setting.model);
  if (!options.avalanche) parts.colors.back() = srgb_color(0x7a8088);
  return parts;
}

struct Bench {
  explicit Bench(const Options& o)
      : options(o),
        context(make_context()),
        gl(*context),
        setting(o.avalanche ? avalanche(o.bodies) : towers_and_ball(o.bodies)),
        solver(*context, setting.model, setting.state, o.device),
        scene(bare_scene(setting, o)),
        bodies(*context, parts_of(setting, o), solver.pose_buffer()),
        renderer(*context, o.width, o.height) {
    quality.shadow_side = o.shadow;
    setting.params.solver.iterations = o.sweeps;
    setting.params.solver.halvings = o.halvings;
    if (options.steps == 0) options.steps = setting.steps;
    setting.params.h /= options.steps;
    if (o.kappa > 0) setting.params.contact.kappa = o.kappa;
  }

  static std::unique_ptr<GlContext> make_context() {
    std::vector<ContextAttempt> attempts;
    return create_headless_context(Backend::automatic, attempts);
  }

  void step() {
    for (int k = 0; k < options.steps; ++k) solver.enqueue(setting.params);
  }
  void draw() {
    if (options.color) {
      const unsigned values = solver.value_buffer(*options.color);
      bodies.color_by(values,
                      round_range(bodies.largest(values), 1e-6, *options.color == BodyQuantity::energy));
    }
    if (options.device.report_contacts)
      bodies.mark_contacts(setting.model, solver.contact_buffers(), {.d_hat = setting.params.contact.d_hat});
    renderer.draw(scene, nullptr, quality, &bodies);
  }
  // Of the last picture.
  std::uint64_t corners(DeviceList list) {
    std::uint64_t sum = 0;
    for (const DeviceBatches* batches : {&bodies.batches(list), &bodies.revealed(list)}) {
      for (const pabd::testing::DrawnCommand& c : pabd::testing::drawn_commands(gl, *batches))
        sum += std::uint64_t{c.indices} * c.instances;
    }
    return sum;
  }
  void tell_picks() {
    DevicePick pick(*context, setting.model, solver.pose_buffer());
    const Vec3 eye = scene.camera.eye.cast<double>();
    const Ray ray{eye, scene.camera.target.cast<double>() - eye};
    static_cast<void>(pick(ray));  // compiles
    auto start = Clock::now();
    const auto hit = pick(ray);
    const double here = ms_since(start);
    start = Clock::now();
    State state;
    solver.read_state(state, false);
    const double reading = ms_since(start);
    start = Clock::now();
    const auto expected = ray_cast(setting.model, state, ray);
    const double casting = ms_since(start);
    fmt::print(
        "pick: {:.2f} ms, {:.1f} KB read; of a state that is read back {:.2f} ms ({:.1f} MB) and {:.2f} ms: "
        "{}\n",
        here, static_cast<double>(pick.bytes_read()) / 1e3, reading,
        static_cast<double>(96 * state.c.size()) / 1e6, casting,
        hit && expected && hit->body == expected->body && hit->t == expected->t ? "the same" : "ANOTHER");
  }
  // Of pictures that wait for each of their passes.
  void tell_passes() {
    constexpr int kPictures = 5;
    renderer.measure_passes(true);
    PassTimes sum;
    for (int k = 0; k < kPictures; ++k) {
      draw();
      const PassTimes t = renderer.pass_times();
      sum.prepare += t.prepare / kPictures;
      sum.shadow += t.shadow / kPictures;
      sum.contact_shade += t.contact_shade / kPictures;
      sum.bodies += t.bodies / kPictures;
      sum.ground += t.ground / kPictures;
      sum.resolve += t.resolve / kPictures;
    }
    renderer.measure_passes(false);
    fmt::print(
        "passes, ms: prepare {:.2f}, shadow {:.2f}, contact shade {:.2f}, bodies {:.2f}, ground {:.2f}, "
        "resolve {:.2f}\n",
        sum.prepare, sum.shadow, sum.contact_shade, sum.bodies, sum.ground, sum.resolve);
  }
  void read(int frame) {
    renderer.queue_read();
    if (renderer.queued() == 2) take(frame - 1);
  }
  void take(int frame) {
    if (!renderer.fetch(image) || options.every == 0 || frame % options.every != 0) return;
    const auto start = Clock::now();
    const std::string path =
        fmt::format("{}/{}_{:05}.{}", options.folder, options.avalanche ? "avalanche" : "towers", frame,
                    options.jpg ? "jpg" : "png");
    if (options.jpg) {
      stbi_write_jpg(path.c_str(), image.width, image.height, 3, image.rgb.data(), 88);
    } else {
      write_png(path, image);
    }
    writing += ms_since(start);
  }

  // ms a frame.
  double measure(bool steps, bool draws, bool reads) {
    if (steps) solver.set_state(setting.state);
    gl.Finish();
    writing = 0;
    const auto start = Clock::now();
    for (int frame = 0; frame < options.frames; ++frame) {
      if (steps) step();
      if (draws) draw();
      if (reads) read(frame);
    }
    if (reads) take(options.frames - 1);
    if (steps) solver.finish();
    gl.Finish();
    return (ms_since(start) - writing) / options.frames;
  }

  Options options;
  std::unique_ptr<GlContext> context;
  ComputeFunctions gl;
  Setting setting;
  DeviceSolver solver;
  VisualScene scene;
  DeviceBodies bodies;
  Renderer renderer;
  RenderQuality quality;
  Image image;
  double writing = 0;  // ms of files
};

}  // namespace

int main(int argc, char** argv) try {
  const Options options = parse(argc, argv);
  if (!options.folder.empty()) std::filesystem::create_directories(options.folder);
  const auto start = Clock::now();
  Bench bench(options);
  bench.step();
  bench.draw();
  bench.solver.finish();
  bench.gl.Finish();
  fmt::print("{}, {} bodies, {}x{}, start {:.1f} s, solver {:.0f} MiB, pictures {:.0f} MiB\n",
             bench.renderer.gl_renderer(), bench.setting.model.size(), options.width, options.height,
             ms_since(start) / 1000, static_cast<double>(bench.solver.bytes()) / (1 << 20),
             static_cast<double>(bench.bodies.bytes()) / (1 << 20));
  const auto row = [&](const char* what, double ms) {
    fmt::print("{:<28} {:9.2f} ms a frame {:8.1f} frames a second\n", what, ms, 1000 / ms);
    std::fflush(stdout);
  };
  row("step", bench.measure(true, false, false));
  row("draw (the last state)", bench.measure(false, true, false));
  row("step and draw", bench.measure(true, true, false));
  row("step, draw and read back", bench.measure(true, true, true));
  bench.tell_passes();
  for (const auto& [list, name] : {std::pair(DeviceList::bodies, "bodies"),
                                   {DeviceList::casters, "casters"},
                                   {DeviceList::near_casters, "casters, near sides"},
                                   {DeviceList::floor_casters, "casters near the floor"},
                                   {DeviceList::glyphs, "glyphs"}})
    fmt::print("indices of {}: {:.2f} million\n", name, static_cast<double>(bench.corners(list)) / 1e6);
  bench.tell_picks();
  const StepSummary& summary = bench.solver.finish();
  const DeviceTimes& t = bench.solver.times();
  fmt::print("last step: {:.2f} ms: broad {:.2f}, narrow {:.2f}, set up {:.2f}, solve {:.2f}, end {:.2f}\n",
             t.total(), t.broad_phase, t.narrow_phase, t.set_up, t.solve, t.velocities);
  fmt::print(
      "last step: kappa {:.3g} J, {} contacts, {} colors, kinetic {:.4g} J, least gap {:.3g} m, {}; {} steps "
      "repeated, {} in halves\n",
      summary.kappa, summary.contacts, bench.solver.colors(), summary.kinetic, summary.min_gap,
      summary.status == StepStatus::non_finite ? "NOT FINITE" : "finite", bench.solver.repeated(),
      bench.solver.halved());
  State state;
  bench.solver.read_state(state, false);
  double way = 0, fastest = 0;
  for (std::size_t i = 0; i < state.c.size(); ++i) {
    way = std::max(way, (state.c[i] - bench.setting.state.c[i]).norm());
    fastest = std::max(fastest, state.v[i].norm());
  }
  fmt::print(
      "farthest way {:.3g} m, fastest {:.3g} m/s; the last body is at {:.3g} {:.3g} {:.3g} m, {:.3g} m/s\n",
      way, fastest, state.c.back().x(), state.c.back().y(), state.c.back().z(), state.v.back().norm());
  return 0;
} catch (const Error& error) {
  fmt::print(stderr, "bench_million: {}\n", error.what());
  return 4;
}
