// SPDX-License-Identifier: MIT
// pabd render: simulate and draw without a display; video, PNG frames or raw RGB.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/cli/backend_option.h"
#include "app/cli/common.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/cli/simulation_setup.h"
#include "app/cli/streams.h"
#include "app/frames/ab_painter.h"
#include "app/frames/frame_schedule.h"
#include "app/frames/frame_text.h"
#include "app/frames/render_pipeline.h"
#include "render/output/frame_sink.h"
#include "sim/base/error.h"
#include "sim/base/input_file.h"
#include "sim/scene/tuning.h"

namespace pabd::cli {
namespace {

constexpr double kDefaultTime = 5;
constexpr int kMostFrames = 10'000'000;
constexpr std::size_t kMostPatchBytes = std::size_t{1} << 20;

struct RenderOptions {
  CommonOptions common;
  std::string scene;
  OutputOptions output;
  std::optional<double> time;
  std::optional<std::int64_t> frames;
  double fps = 60;
  std::string size = "1280x720";
  std::string overlay = "none";
  std::string camera;
  std::string backend = "auto";
  std::string from;
  std::string timings;
  double encoder_timeout = SinkOptions{}.encoder_timeout;
  std::string ab;
  std::string ab_view = "side";
  bool resume = false;
};

// One PNG shows the state at the end; everything else shows the way there.
bool is_still(const std::string& out) { return out.ends_with(".png") && !is_frame_template(out); }

// A video of T seconds has T·fps frames, the last one a frame before T. A still of T seconds shows the state
// at T.
int frame_count(const RenderOptions& options) {
  if (options.frames) {
    check_range("--frames", static_cast<double>(*options.frames), 1, kMostFrames);
    return static_cast<int>(*options.frames);
  }
  const double time = options.time.value_or(kDefaultTime);
  check_range("--time", time, 0, 1e6, "s");
  const double frames =
      static_cast<double>(steps_until(time, 1 / options.fps)) + (is_still(options.output.path) ? 1 : 0);
  if (frames < 1) {
    throw Error(ErrorKind::bad_input,
                fmt::format("--time {}: shorter than one frame; give at least {:.4g} s, or --frames 1", time,
                            1 / options.fps));
  }
  check_range("--time × --fps", frames, 1, kMostFrames, "frames");
  return static_cast<int>(frames);
}

void check_output(const RenderOptions& options) {
  if (options.resume && !is_frame_template(options.output.path)) {
    throw Error(ErrorKind::bad_input,
                fmt::format("--resume: {} is no sequence of frames; only an output with {{frame}} and "
                            ".png can be continued",
                            options.output.path));
  }
  if (options.output.path == "-" && stdout_is_terminal()) {
    throw Error(ErrorKind::bad_input,
                "-o -: raw RGB frames would go to the terminal; redirect or pipe standard output");
  }
}

constexpr int kLeastSide = 34;  // px: two pictures of the least width, and the seam

void check_ab(const RenderOptions& options, const OverlayChoice& overlay, const FrameSize& size) {
  const OverlayPanel* of_two = overlay.panels.needing(&OverlayPanel::other_run);
  if (options.ab.empty() && of_two != nullptr) {
    throw Error(ErrorKind::bad_input,
                fmt::format("--overlay {}: there is nothing to compare; add --ab PATCH.json", of_two->name));
  }
  if (!options.ab.empty() && size.width < kLeastSide) {
    throw Error(ErrorKind::bad_input,
                fmt::format("--size {}: --ab needs a width of {} or more", options.size, kLeastSide));
  }
}

// B: the same scene and start with other parameters.
Run open_patched(const RenderOptions& options, const Run& a) {
  const std::string patch = read_file(options.ab, kMostPatchBytes, "a JSON merge patch");
  Run b = a.fork();
  b.set_params(patched(a.params(), patch, options.ab));
  return b;
}

std::string timings_json(const RenderResult& result) {
  const StageTimes& times = result.times;
  const double slowest = std::max({times.simulate, times.draw, times.encode});
  const nlohmann::ordered_json json = {{"frames", result.frames},    {"simulate_s", times.simulate},
                                       {"draw_s", times.draw},       {"encode_s", times.encode},
                                       {"slowest_stage_s", slowest}, {"total_s", times.total}};
  return json.dump(2) + "\n";
}

int render(const RenderOptions& options) {
  check_range("--fps", options.fps, 0.01, 1000, "1/s");
  check_range("--encoder-timeout", options.encoder_timeout, 0.1, 1e6, "s");
  const FrameSize size = parse_size(options.size);
  const CameraOption camera = parse_camera(options.camera);
  const OverlayChoice overlay = parse_overlay(options.overlay);
  const AbView ab_view = parse_ab_view(options.ab_view);
  const std::string& out = options.output.path;
  check_output(options);
  check_ab(options, overlay, size);
  FrameRange range{0, frame_count(options), options.fps};
  if (is_still(out)) range.first = range.count - 1;

  InputFiles inputs;
  Run a = open_run(options.scene, options.common, options.from, inputs);
  inputs.add(options.ab);
  if (!camera.keys.empty()) inputs.add(options.camera);
  a.observe(overlay.needs_iterations(), overlay.needs_contacts());
  std::optional<Run> b;
  if (!options.ab.empty()) b.emplace(open_patched(options, a));
  std::optional<FrameView> start_b;
  if (b) start_b = b->view();
  const Frame start = make_frame(0, a.view(), std::move(start_b), {});

  std::optional<TextOutput> timings;
  if (!options.timings.empty()) timings.emplace("--timings", options.timings, options.output.force, inputs);
  std::vector<ContextAttempt> attempts;
  const auto context = create_headless_context(parse_backend(options.backend), attempts);
  AbPainter painter(*context, a.shared_scene(), start, ab_view, size.width, size.height, overlay, camera,
                    range.count / options.fps);
  const PngText common = common_text(a.scene(),
                                     {size.width, size.height, options.fps, options.overlay,
                                      camera_text(camera, options.camera), painter.gl_renderer()},
                                     start.a, start.b ? &*start.b : nullptr, options.ab_view);
  if (options.resume) range.first = find_resume_frame(out, range.count, common);
  if (range.first == range.count) {
    if (!options.common.quiet) write_stderr(fmt::format("all {} frames are there already\n", range.count));
    return 0;
  }

  SinkOptions sink_setup =
      sink_options(start.a, common, range, size.width, size.height, options.resume ? range.first : 0);
  sink_setup.inputs = inputs;
  // What follows the last whole frame is drawn again.
  sink_setup.force = options.output.force || options.resume;
  sink_setup.encoder_timeout = options.encoder_timeout;
  AsyncSink sink(make_sink(out, sink_setup));

  const InterruptGuard interrupt;
  std::optional<Progress> progress(std::in_place, "frame", range.count, !options.common.quiet);
  const auto show = [&](int frames, const StepSummary& step) { progress->update(frames, step); };
  LiveSource source(std::move(a), std::move(b), range, show);
  const RenderResult result =
      render_frames(source, painter, sink, {[&] { return interrupt.requested(); }, show});
  progress.reset();  // what follows has a line of its own
  if (timings) {
    timings->write(timings_json(result));
    timings->finish();
  }
  if (!options.common.quiet) {
    write_stderr(
        fmt::format("{} frames in {:.1f} s (simulating {:.1f}, drawing {:.1f}, encoding {:.1f}) · {} · {}\n",
                    result.frames, result.times.total, result.times.simulate, result.times.draw,
                    result.times.encode, context->name(), painter.gl_renderer()));
  }
  if (const auto diverged = source.diverged())
    throw diverged_error(options.scene + (diverged->in_b ? " with " + options.ab : ""), diverged->step);
  return interrupt.exit_code();
}

}  // namespace

void add_render_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command =
      add_command(app, "render", "simulate a scene and draw it, without a display",
                  {"pabd render pyramid -o pyramid.mp4 --time 5 --overlay plots,contacts",
                   "pabd render two_boxes -o 'frames/{frame:04}.png' --frames 120 --size 640x360 --resume",
                   "pabd render pyramid -o last.png --time 2 --camera orbit:20 --set contact.N=8",
                   "pabd render stack -o ab.mp4 --ab softer.json --overlay params,series,difference",
                   "pabd render pyramid -o - --size 640x360 | ffplay -f rawvideo -pixel_format rgb24 "
                   "-video_size 640x360 -"},
                  options->common);
  command->add_option("SCENE", options->scene, "scene file, or the name of a shipped scene")->required();
  add_output_options(*command, options->output,
                     ".mp4, .webm, .gif: video; a name with {frame:04} and .png: a PNG a frame; .png: the "
                     "last frame; -: raw "
                     "RGB to standard output");
  auto* time = command->add_option("--time", options->time, "length (default 5 s)")->type_name("S");
  command->add_option("--frames", options->frames, "number of frames instead")
      ->type_name("N")
      ->excludes(time);
  command->add_option("--fps", options->fps, "frames a second (default 60)")->type_name("F");
  command->add_option("--size", options->size, "pixels (default 1280x720)")->type_name("WxH");
  command->add_option("--overlay", options->overlay, "comma-separated: " + overlay_help())->type_name("LIST");
  command->add_option("--camera", options->camera, camera_help())->type_name("VIEW");
  auto* ab =
      command
          ->add_option("--ab", options->ab,
                       "beside the scene (A) the same one with changed parameters (B): a JSON merge patch "
                       "of its keys, such as {\"contact\": {\"kappa\": 50}}")
          ->type_name("PATCH.json");
  command
      ->add_option("--ab-view", options->ab_view, "side: side by side (default); ghost: B translucent over A")
      ->type_name("VIEW")
      ->needs(ab);
  add_backend_option(*command, options->backend);
  command->add_option("--from", options->from, "start at a state file of this scene")
      ->type_name("STATE.json");
  command->add_flag("--resume", options->resume, "go on with a sequence of frames that was cut short");
  command
      ->add_option("--encoder-timeout", options->encoder_timeout,
                   "how long ffmpeg may make no progress before it is ended, with exit code 6 (default 60)")
      ->type_name("S");
  command->add_option("--timings", options->timings, "write how long each stage worked")->type_name("JSON");
  add_scene_options(*command, options->common);
  command->callback([options, &action] { action = [options] { return render(*options); }; });
}

}  // namespace pabd::cli
