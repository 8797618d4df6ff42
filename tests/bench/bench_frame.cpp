// Frames per second of the pyramid at 1280×720, split by phase: draw (GL finished), read back, encode.

#include <benchmark/benchmark.h>

#include <filesystem>

#include "render/context/context.h"
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
