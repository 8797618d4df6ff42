// SPDX-License-Identifier: MIT
// Frames per second of the pyramid at 1280×720, split by phase: draw (GL finished), read back, encode.

#include <benchmark/benchmark.h>

#include <filesystem>

#include "render/context/context.h"
#include "render/gl/drop_alpha.h"
#include "render/gl/renderer.h"
#include "render/output/frame_sink.h"
#include "render/visual/build_visual.h"
#include "sim/scene/scene.h"
#include "sim/solver/time_step.h"

namespace {

using namespace pabd;

constexpr int kWidth = 1280, kHeight = 720;

// The pyramid after a tenth of a second, ready to draw.
struct Picture {
  std::vector<ContextAttempt> attempts;
  std::unique_ptr<GlContext> context = create_headless_context(Backend::automatic, attempts);
  Renderer renderer{*context, kWidth, kHeight};
  VisualScene scene;
  Image image;

  Picture() {
    Scene file = load_scene(PABD_SCENES "/pyramid.json");
    StepWorkspace workspace;
    StepReport report;
    for (int k = 0; k < 6; ++k)
      step(file.model, file.params, {false, true, 1}, file.initial, workspace, report);
    scene.camera = frame_camera(file.model, file.initial, double(kWidth) / kHeight);
    build_visual(file.model, file.initial, report, {}, scene);
    renderer.measure_passes(true);  // draws what did not change
  }

  void frame() {
    renderer.draw(scene, nullptr);
    renderer.queue_read();
    renderer.fetch(image);
  }
};

void draw_and_read(benchmark::State& bench) {
  Picture picture;
  FrameTimes sum;
  for (auto _ : bench) {
    picture.frame();
    sum.draw += picture.renderer.times().draw;
    sum.read_back += picture.renderer.times().read_back;
  }
  bench.counters["draw_ms"] = benchmark::Counter(sum.draw, benchmark::Counter::kAvgIterations);
  bench.counters["read_back_ms"] = benchmark::Counter(sum.read_back, benchmark::Counter::kAvgIterations);
  bench.counters["frames_per_second"] = benchmark::Counter(1, benchmark::Counter::kIsIterationInvariantRate);
  bench.SetLabel(picture.renderer.gl_renderer());
}
BENCHMARK(draw_and_read)->Unit(benchmark::kMillisecond)->UseRealTime();

// A scene as a window shows it, pass by pass. Run with LP_NUM_THREADS=0 for what it takes on one core.
void window_view(benchmark::State& bench, const char* name, int steps, const RenderQuality& quality,
                 int width, int height, bool contacts = false, bool bonds = false) {
  std::vector<ContextAttempt> attempts;
  const std::unique_ptr<GlContext> context = create_headless_context(Backend::automatic, attempts);
  Renderer renderer(*context, width, height);
  Scene file = load_scene(std::string(PABD_SCENES "/") + name + ".json");
  StepWorkspace workspace;
  StepReport report;
  for (int k = 0; k < steps; ++k)
    step(file.model, file.params, {false, contacts || bonds, 2}, file.initial, workspace, report);
  VisualScene scene;
  scene.camera = frame_camera(file.model, file.initial, double(width) / height);
  VisualOptions options;
  options.contacts = contacts;
  options.bonds = bonds;
  build_visual(file.model, file.initial, report, options, scene);
  for (auto _ : bench) renderer.draw_view(0, scene, width, height, quality);
  renderer.measure_passes(true);
  renderer.draw_view(0, scene, width, height, quality);
  const PassTimes t = renderer.pass_times();
  for (const auto& [pass, ms] : {std::pair{"prepare", t.prepare},
                                 {"shadow", t.shadow},
                                 {"contact_shade", t.contact_shade},
                                 {"bodies", t.bodies},
                                 {"ground", t.ground},
                                 {"glyphs", t.glyphs},
                                 {"resolve", t.resolve}})
    bench.counters[pass] = ms;
}
BENCHMARK_CAPTURE(window_view, pyramid_1280x720, "pyramid", 6, RenderQuality{}, 1280, 720)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(window_view, two_boxes_1280x720, "two_boxes", 60, RenderQuality{}, 1280, 720)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(window_view, pyramid_contacts, "pyramid", 6, RenderQuality{}, 1280, 720, true)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(window_view, pyramid_bonds, "pyramid", 6, RenderQuality{}, 1280, 720, false, true)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(window_view, full_1280x720, "pile", 240, RenderQuality{}, 1280, 720)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(window_view, live_1280x720, "pile", 240, RenderQuality::live(), 1280, 720)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(window_view, full_680x600, "pile", 240, RenderQuality{}, 680, 600)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(window_view, live_680x600, "pile", 240, RenderQuality::live(), 680, 600)
    ->Unit(benchmark::kMillisecond);

// What fetching a frame costs beside waiting for it.
void copy_without_alpha(benchmark::State& bench, int width, int height, int threads) {
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const std::vector<std::uint8_t> rgba(4 * pixels, 77);
  std::vector<std::uint8_t> rgb(3 * pixels);
  Team team;
  for (auto _ : bench) drop_alpha(rgba.data(), width, height, team, threads, rgb.data());
}
BENCHMARK_CAPTURE(copy_without_alpha, 3840x2160_1, 3840, 2160, 1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(copy_without_alpha, 3840x2160_2, 3840, 2160, 2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void encode(benchmark::State& bench, const char* extension) {
  Picture picture;
  picture.frame();
  const std::filesystem::path out =
      std::filesystem::temp_directory_path() / (std::string("pabd_bench") + extension);
  SinkOptions options;
  options.force = true;
  std::unique_ptr<FrameSink> sink = make_sink(out.string(), options);
  for (auto _ : bench) sink->write(picture.image);
  sink->finish();
  std::filesystem::remove(out);
}
BENCHMARK_CAPTURE(encode, mp4, ".mp4")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(encode, webm, ".webm")->Unit(benchmark::kMillisecond)->UseRealTime();

void encode_png_frame(benchmark::State& bench) {
  Picture picture;
  picture.frame();
  for (auto _ : bench) benchmark::DoNotOptimize(encode_png(picture.image));
}
BENCHMARK(encode_png_frame)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
