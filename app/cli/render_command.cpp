// SPDX-License-Identifier: MIT
// pabd render: simulate and draw without a display; video, PNG frames or raw RGB.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "app/cli/device_option.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/cli/render_runs.h"
#include "app/cli/run_notes.h"
#include "app/cli/simulation_setup.h"
#include "app/cli/streams.h"
#include "app/frames/frame_text.h"
#include "app/frames/render_pipeline.h"
#include "app/frames/runs_painter.h"
#include "app/session/step_at_time.h"
#include "render/output/frame_sink.h"
#include "sim/base/counted.h"
#include "sim/base/error.h"

namespace pabd::cli {
namespace {

// A GIF is for a page: files of three digits of megabytes are of no use there.
constexpr double kFps = 60, kGifFps = 20;
constexpr const char *kSize = "1280x720", *kGifSize = "640x360";

struct RenderOptions {
  CommonOptions common;
  std::string scene;
  OutputOptions output;
  LengthOptions length;
  double fps = kFps;
  std::string size;  // empty: what suits the output
  std::string overlay = "none";
  std::string caption;
  std::string speed = "1";
  std::string camera;
  std::string backend = "auto";
  std::string device;
  std::string from;
  double encoder_timeout = SinkOptions{}.encoder_timeout;
  std::string ab;
  std::string ab_view = "side";
  std::vector<std::string> grid;
  bool resume = false;
  std::string quality = "good";
  std::string encoder = "software";
  VideoOptions video;
  std::string theme = "studio";
  std::string color_by = kColorNames[0];
  std::string contacts_by = kContactQuantities[0];
  std::vector<std::string> trails;
  double trail_time = kTrailTime;
};

RenderQuality parse_quality(const std::string& word) {
  if (word == "draft") return RenderQuality::live();
  if (word == "best") return {Quality::best, 0.1f};
  return {};
}

// With what is not said as it suits the output.
RenderOptions completed(RenderOptions options) {
  const bool gif = std::filesystem::path(options.output.path).extension() == ".gif";
  options.fps = options.length.fps.value_or(gif ? kGifFps : kFps);
  if (options.size.empty()) options.size = gif ? kGifSize : kSize;
  options.video.encoder = parse_video_encoder(options.encoder);
  return options;
}

// One PNG shows the state at the end; everything else shows the way there.
bool is_still(const std::string& out) { return out.ends_with(".png") && !is_frame_template(out); }

// "wrote pyramid.mp4: 300 frames of 1280x720, 5 s at 60 a second, 3.1 MB".
std::string written_text(const RenderOptions& options, const FrameRange& range, int frames) {
  const std::string& out = options.output.path;
  if (frames == 0) return "wrote nothing: ended before the first frame\n";
  const FrameSize drawn = parse_size(options.size);
  const std::string what = fmt::format("{} of {}x{}", counted(frames, "frame"),
                                       side_in_file(out, drawn.width), side_in_file(out, drawn.height));
  if (out == "-") return fmt::format("wrote {} to standard output\n", what);
  if (is_frame_template(out)) {
    const std::string first = frame_path(out, range.first).string();
    const std::string last = frame_path(out, range.first + frames - 1).string();
    return fmt::format("wrote {}{}: {}\n", first, frames > 1 ? " … " + last : "", what);
  }
  const std::string bytes = file_size_text(out);
  if (is_still(out)) return fmt::format("wrote {}: {}{}\n", out, options.size, bytes);
  return fmt::format("wrote {}: {}, {:.4g} s at {:g} a second{}\n", out, what, frames / options.fps,
                     options.fps, bytes);
}

void check_output(const RenderOptions& options) {
  if (options.resume && !is_frame_template(options.output.path)) {
    throw Error(ErrorKind::bad_input,
                fmt::format("--resume: {} is no sequence of frames; only an output with {{frame}} and "
                            ".png can be continued",
                            options.output.path));
  }
  if (find_theme(options.theme).transparent && !options.output.path.ends_with(".png")) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("--theme transparent: {} cannot be seen through; expected an output that ends with .png",
                    options.output.path == "-" ? "raw RGB" : options.output.path));
  }
  if (options.output.path == "-" && stdout_is_terminal()) {
    throw Error(ErrorKind::bad_input,
                "-o -: raw RGB frames would go to the terminal; redirect or pipe standard output");
  }
}

constexpr int kLeastSide = 34;  // px: two pictures of the least width, and the seam

void check_compared(const RenderOptions& options, const OverlayChoice& overlay, const FrameSize& size) {
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

int render(const RenderOptions& asked) {
  if (asked.length.fps) check_range("--fps", *asked.length.fps, 0.01, 1000, "1/s");
  const RenderOptions options = completed(asked);
  check_range("--encoder-timeout", options.encoder_timeout, 0.1, 1e6, "s");
  const FrameSize size = parse_size(options.size);
  CameraOption camera = parse_camera(options.camera);
  OverlayChoice overlay = parse_overlay(options.overlay);
  overlay.theme = &find_theme(options.theme);
  overlay.caption = options.caption;
  const Pace pace(options.speed);
  overlay.color_by(color_quantity(options.color_by));
  overlay.show_contacts_by(contact_quantity(options.contacts_by));
  check_range("--trail-time", options.trail_time, 0.01, 1e6, "s");
  std::vector<TrailPoint> trail_points;
  for (const std::string& trail : options.trails) trail_points.push_back(parse_trail(trail, "--trail"));
  const std::string& out = options.output.path;
  check_output(options);
  check_compared(options, overlay, size);
  InputFiles inputs;
  Arrangement arrangement{parse_ab_view(options.ab_view), RunGrid(options.grid)};
  const RunGrid& grid = arrangement.grid;
  const AskedRuns asked_runs{options.scene, options.common, options.from, options.ab, grid};
  Run a = open_run(options.scene, options.common, options.from, inputs);
  // A video of T seconds has T·fps frames, the last one a frame before T; a still shows the state at T.
  const auto frames = frame_count(options.length, a.scene(), options.fps, is_still(out), pace);
  FrameRange range{0, static_cast<int>(frames), options.fps, pace};
  const double seconds = range.time(range.count - (is_still(out) ? 1 : 0));
  if (camera.whole_turn && seconds > 0) camera.orbit = 360 / seconds;
  if (is_still(out)) range.first = range.count - 1;
  inputs.add(options.ab);
  if (!camera.keys.empty()) inputs.add(options.camera);
  for (const TrailPoint& point : trail_points) check_trail(point, a.model(), "--trail");
  const StepOptions wanted{.record_iterations = overlay.needs_iterations(),
                           .report_contacts = overlay.needs_contacts(),
                           .report_bodies = overlay.needs_bodies()};
  arrangement.plain = a.shared_scene();
  std::vector<Run> runs = open_runs(asked_runs, std::move(a), inputs);
  std::vector<std::shared_ptr<const Scene>> scenes;
  std::vector<FrameView> views;
  std::vector<RunNotes> notes;
  for (Run& run : runs) {
    run.observe(wanted.record_iterations, wanted.report_contacts, wanted.report_bodies);
    scenes.push_back(run.shared_scene());
    notes.emplace_back(run.model(), run.params());
  }
  const Backend backend = parse_backend(options.backend);
  const DeviceChoices device = choose_devices(options.device, backend, options.scene, runs, wanted);
  const bool filmed = device.run(0).gpu && runs.size() == 1 && trail_points.empty() &&
                      DeviceFilm::shows_all(runs[0], overlay, camera);
  if (!filmed) solve_by(device, backend, runs);
  for (const Run& run : runs) views.push_back(run.view());
  Frame start = make_frame(0, std::move(views));
  start.compared = !options.ab.empty();

  std::vector<ContextAttempt> attempts;
  const auto context = create_headless_context(backend, attempts);
  RunsPainter painter(*context, scenes, start, arrangement, size.width, size.height, overlay, camera,
                      seconds);
  painter.set_quality(parse_quality(options.quality));
  PngText common = common_text(*scenes[0],
                               {.width = size.width,
                                .height = size.height,
                                .fps = options.fps,
                                .overlay = options.overlay,
                                .camera = camera_text(camera, options.camera),
                                .gl_renderer = painter.gl_renderer(),
                                .quality = options.quality,
                                .theme = options.theme,
                                .color_by = options.color_by,
                                .contacts_by = options.contacts_by,
                                .trails = options.trails,
                                .grid = grid.text()},
                               start.a(), start.b(), options.ab_view, scenes.back().get());
  if (device.run(0).gpu) common["Device"] = device.run(0).name;
  if (start.compared && device.of.size() > 1) common["Device of B"] = device.of[1].name;
  if (options.resume) range.first = find_resume_frame(out, range.count, common);
  if (range.first == range.count) {
    if (!options.common.quiet)
      write_stderr(range.count == 1 ? std::string("the frame is there already\n")
                                    : fmt::format("all {} frames are there already\n", range.count));
    return 0;
  }

  SinkOptions sink_setup =
      sink_options(start.a(), common, range, size.width, size.height, options.resume ? range.first : 0);
  sink_setup.inputs = inputs;
  // What follows the last whole frame is drawn again.
  sink_setup.force = options.output.force || options.resume;
  sink_setup.encoder_timeout = options.encoder_timeout;
  sink_setup.video = options.video;
  AsyncSink sink(make_sink(out, sink_setup));

  const InterruptGuard interrupt;
  std::optional<Progress> progress(std::in_place, "frame", range.count, !options.common.quiet);
  const auto show = [&](int done, const StepSummary& step) { progress->update(done, step); };
  const RenderWatch watch{[&] { return interrupt.requested(); }, show};
  const auto stepped = [&](const StepSummary& step, std::size_t run) { notes[run].add(step); };
  std::optional<DeviceFilm> film;
  if (filmed) {
    try {
      film.emplace(*context, runs[0], range, overlay.contacts, show, stepped);
    } catch (const Error& error) {  // solver and pictures do not fit together
      if (error.kind() != ErrorKind::no_context) throw;
      solve_by(device, backend, runs);
      context->make_current();  // an engine has one of its own, and leaves none current
    }
  }
  RenderResult result;
  std::vector<LiveSource::Diverged> diverged;
  if (film) {
    result = render_film(*film, painter, sink, watch);
    if (film->diverged()) diverged.push_back({*film->diverged()});
  } else {
    FrameRange seen = range;
    if (options.resume && overlay.remembers()) seen.first = 0;
    LiveSource source(std::move(runs), seen, show, TrailRecorder(std::move(trail_points), options.trail_time),
                      stepped, !grid.empty());
    result = render_frames(source, painter, sink, watch, range.first);
    diverged = source.diverged();
  }
  progress.reset();  // what follows has a line of its own
  if (!options.common.quiet) {
    write_stderr(written_text(options, range, result.frames));
    write_stderr(fmt::format("{:.1f} s (simulating {:.1f}, drawing {:.1f}, encoding {:.1f}) · {} · {}{}\n",
                             result.times.total, result.times.simulate, result.times.draw,
                             result.times.encode, context->name(), painter.gl_renderer(), device.words()));
    for (std::size_t run = 0; run < notes.size(); ++run) {
      const std::string name = asked_runs.name(run);
      for (const std::string& line : notes[run].lines())
        write_notes({(name.empty() ? "" : name + ": ") + line});
    }
  }
  const bool is_result = !grid.empty() && diverged.size() < grid.size();  // it is seen in the picture
  for (const auto& [step, run] : diverged) {
    const std::string name = asked_runs.name(run);
    const Error error = diverged_error(options.scene + (name.empty() ? "" : " with " + name), step);
    if (!is_result) throw error;
    if (!options.common.quiet) write_notes({error.what()});
  }
  return interrupt.exit_code();
}

}  // namespace

void add_render_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<RenderOptions>();
  const Command command(
      app, "render", "simulate a scene and draw it, without a display",
      {"pabd render pyramid -o pyramid.mp4 --time 5 --overlay plots,contacts",
       "pabd render two_boxes -o 'frames/{frame:04}.png' --frames 120 --size 640x360 --resume",
       "pabd render pyramid -o last.png --time 2 --camera orbit:20 --set contact.N=8",
       "pabd render bridge -o bridge.gif --time 3 --loop 1", "pabd render pile -o speed.mp4 --color-by speed",
       "pabd render two_boxes -o slow.mp4 --speed 1,0.1:0.5-0.8 --caption 'two boxes, {time}'",
       "pabd render pyramid -o loads.mp4 --contacts-by force",
       "pabd render pile -o pile.mp4 --crf 14 --preset slow --quality best",
       "pabd render four_bar -o pen.mp4 --camera front,ortho --trail pen --overlay axes,scale",
       "pabd render stack -o ab.mp4 --ab softer.json --overlay params,series,difference",
       "pabd render two_boxes -o grid.mp4 --grid contact.N=1,3,8 contact.kappa=10,100",
       "pabd render pyramid -o - --size 640x360 | ffplay -f rawvideo -pixel_format rgb24 "
       "-video_size 640x360 -"},
      options->common);
  using namespace group;
  command.scene(options->scene);
  command.output(
      options->output,
      ".mp4, .webm, .gif: video; a name with {frame:04} and .png: a PNG a frame, from 0000; .png: the last "
      "frame; -: raw RGB to standard output");
  command.flag(kOutput, "--resume", options->resume, "go on with a sequence of frames that was cut short");
  command.length(options->length, "length (default: the duration of the scene, or 5 s)",
                 "frames a second (default 60; of a .gif 20)");
  command.option(kOutput, "--speed", options->speed, speed_help(), "LIST");
  command.option(kOutput, "--size", options->size, "pixels (default 1280x720; of a .gif 640x360)", "WxH");

  command.option(kPicture, "--overlay", options->overlay, "comma-separated: " + overlay_help(), "LIST");
  command.option(kPicture, "--caption", options->caption,
                 "a line over the picture; {time} and {step} stand for the picture's", "LINE");
  command.word(kPicture, "--color-by", options->color_by, {std::begin(kColorNames), std::end(kColorNames)},
               "what colours of bodies say, with a legend; body: nothing but which is which (default); "
               "projection: ‖A − R‖; speed, m/s; energy, J: kinetic and of contacts; component: bodies that "
               "are solved together; residual, in d̂: of that component, where steps end unsolved");
  command.word(
      kPicture, "--contacts-by", options->contacts_by,
      {std::begin(kContactQuantities), std::end(kContactQuantities)},
      "shows contacts, with colours that say: gap: d/d̂, with --overlay contacts (default); force: the "
      "normal force of two bodies (N), as bars from body to body; friction: the part that is used of "
      "the largest friction, f_t/(μ f_n)");
  command.option(kPicture, "--camera", options->camera, camera_help(), "VIEW");
  command.option(kPicture, "--theme", options->theme, "light and background: " + theme_help(), "NAME");
  command.trail(options->trails, "");
  command.option(kPicture, "--trail-time", options->trail_time,
                 "how much of the past trails show (default 2)", "S");
  auto* ab = command.option(
      kPicture, "--ab", options->ab,
      "beside the scene (A) the same one with changed parameters (B): a JSON merge patch of its keys, such "
      "as {\"contact\": {\"kappa\": 50}} or {\"joints_default\": {\"kappa\": 50}}",
      "PATCH.json");
  command
      .option(kPicture, "--ab-view", options->ab_view,
              "side: side by side (default); ghost: B translucent over A", "VIEW")
      ->needs(ab);
  command
      .option(kPicture, "--grid", options->grid,
              fmt::format("a picture of many runs: one for every combination of the values of keys of --set, "
                          "columns by the first key, rows by the others; {} at most",
                          kMostCells),
              "KEY=V1,V2 …")
      ->excludes(ab);
  command.quality(options->quality,
                  "draft: hard shadows and jagged edges, in a fraction of the time; good (default); best: "
                  "round bodies to a tenth of a pixel");
  command.backend(options->backend);

  command.option(kVideo, "--crf", options->video.crf,
                 "how much may be lost, smaller is better and larger: .mp4 0 … 51 (default 18), .webm 0 … 63 "
                 "(default 24)",
                 "N");
  command.option(kVideo, "--preset", options->video.preset,
                 fmt::format("time for a smaller file: {} (default: .mp4 veryfast, .webm fast)",
                             fmt::join(preset_names(), ", ")),
                 "WORD");
  command.option(kVideo, "--loop", options->video.plays, "how often a .gif is played; 0: for ever (default)",
                 "N");
  command.word(kVideo, "--encoder", options->encoder, {"software", "nvenc"},
               "of .mp4: software: libx264 (default); nvenc: that of an NVIDIA GPU, where ffmpeg has it");
  command.option(kVideo, "--encoder-timeout", options->encoder_timeout,
                 "how long ffmpeg may make no progress before it is ended, with exit code 6 (default 60)",
                 "S");

  command.from(options->from);
  command.simulation(options->common);
  add_device_option(command, options->device);
  command.carry_out(action, options, render);
}

}  // namespace pabd::cli
