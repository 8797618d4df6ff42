// SPDX-License-Identifier: MIT
// pabd export: a run as a file for other programs.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "app/cli/device_option.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/cli/run_notes.h"
#include "app/cli/simulation_setup.h"
#include "app/cli/streams.h"
#include "app/export/exporter.h"
#include "app/export/session_source.h"
#include "app/frames/frame_source.h"
#include "app/session/recording.h"
#include "app/session/step_at_time.h"
#include "sim/base/counted.h"
#include "sim/base/error.h"

namespace pabd::cli {
namespace {

constexpr double kExportFps = 30;
constexpr std::size_t kRecordingMemory = std::size_t{512} << 20;  // bytes for states of its past

struct ExportOptions {
  CommonOptions common;
  std::string scene;
  OutputOptions output;
  LengthOptions length;  // --fps: 30, or of an .npz every step
  std::string quality = "good";
  std::vector<std::string> trails;
  bool all_trails = false;
  std::string from;
  std::string recording;
  std::string device;
};

int segments_of(const std::string& quality) { return quality == "draft" ? 16 : quality == "best" ? 96 : 48; }

// Where the frames come from, and how many there are.
struct Frames {
  std::unique_ptr<FrameSource> source;
  SessionSource* live = nullptr;    // the same, where it simulates
  std::shared_ptr<RunNotes> notes;  // of the same
  std::int64_t count = 0;
  double fps = kExportFps;
  FrameView start;
  std::string device_words;
};

std::vector<TrailPoint> trails_of(const ExportOptions& options, const Model& model) {
  std::vector<TrailPoint> points;
  for (const std::string& trail : options.trails) points.push_back(parse_trail(trail, "--trail"));
  for (const TrailPoint& point : points) check_trail(point, model, "--trail");
  for (std::size_t i = 0; options.all_trails && i < model.name.size(); ++i)
    if (!model.fixed[i]) points.push_back({model.name[i]});
  return points;
}

Frames live_frames(const ExportOptions& options, Session session, bool arrays) {
  Frames out;
  // Of arrays every step is a row, unless it is said otherwise.
  out.fps = options.length.fps.value_or(arrays ? 1 / session.params().h : kExportFps);
  // A run of T seconds has a frame at its start and one at T.
  out.count = frame_count(options.length, session.scene(), out.fps, true);
  StepOptions wanted;
  wanted.report_contacts = wanted.report_joints = arrays;
  session.report_contacts(arrays);
  session.report_joints(arrays);
  out.device_words = prepare_on_device(options.device, options.scene, session, wanted).words();
  out.start = session.view();
  out.notes = std::make_shared<RunNotes>(session.model(), session.params());
  auto source = std::make_unique<SessionSource>(
      std::move(session), out.count, out.fps,
      [notes = out.notes](const StepSummary& step, bool) { notes->add(step); });
  out.live = source.get();
  out.source = std::move(source);
  return out;
}

Frames recorded_frames(const ExportOptions& options, const std::shared_ptr<const Scene>& scene, bool arrays) {
  Timeline past = read_recording(options.recording, scene, kRecordingMemory);
  const double h = past.back().params->h;
  Frames out;
  out.fps = options.length.fps.value_or(arrays ? 1 / h : kExportFps);
  Run run(scene, options.common.thread_count(), std::move(past));
  const std::optional<double>& time = options.length.time;
  if (time) check_range("--time", *time, 0, 1e6, "s");
  run.seek(0);
  out.start = run.view();
  const double begin = run.state().time;
  // The frame at the end belongs to it, too.
  const PastRange range{-1, time ? begin + *time : -1, out.fps};
  auto source = std::make_unique<PastSource>(runs_of(std::move(run)), range, false, arrays);
  out.count = source->count();
  out.source = std::move(source);
  return out;
}

Frames open_frames(const ExportOptions& options, bool arrays, std::shared_ptr<const Scene>& scene,
                   InputFiles& inputs) {
  if (options.recording.empty()) {
    Session session = open_session(options.scene, options.common, options.from, inputs);
    scene = session.shared_scene();
    return live_frames(options, std::move(session), arrays);
  }
  scene = open_scene(options.scene, options.common, inputs);
  inputs.add(options.recording);
  return recorded_frames(options, scene, arrays);
}

// "wrote pyramid.glb: 151 frames of 22 bodies, 5 s at 30 a second, 0.4 MB".
std::string written_text(const std::string& out, std::int64_t frames, Index bodies, double fps) {
  if (frames == 0) return "wrote nothing: ended before the first frame\n";
  return fmt::format("wrote {}: {} of {}, {:.4g} s at {:.4g} a second{}\n", out, counted(frames, "frame"),
                     counted(bodies, "body", "bodies"), static_cast<double>(frames - 1) / fps, fps,
                     file_size_text(out));
}

int export_run(const ExportOptions& options) {
  const auto& fps = options.length.fps;
  if (fps) check_range("--fps", *fps, 0.01, 1000, "1/s");
  const std::string& out = options.output.path;
  const bool arrays = export_format(out).arrays;
  InputFiles inputs;
  std::shared_ptr<const Scene> scene;
  Frames frames = open_frames(options, arrays, scene, inputs);
  ExportSetup setup{.fps = frames.fps,
                    .frames = frames.count,
                    .segments = segments_of(options.quality),
                    .trails = trails_of(options, *frames.start.model),
                    .force = options.output.force,
                    .inputs = inputs};
  const auto exporter = make_exporter(out, *scene, frames.start, setup);

  const InterruptGuard interrupt;
  std::int64_t done = 0;
  {
    Progress progress("frame", frames.count, !options.common.quiet);
    while (const auto frame = frames.source->next([&] { return interrupt.requested(); })) {
      exporter->add(frame->number, frame->a());
      progress.update(++done, frame->a().report);
    }
  }
  if (done > 0) exporter->finish();
  if (!options.common.quiet) {
    write_stderr(written_text(out, done, frames.start.model->size(), frames.fps));
    if (!frames.device_words.empty()) write_stderr(frames.device_words.substr(4) + "\n");
    if (frames.notes) write_notes(frames.notes->lines());
  }
  if (frames.live)
    if (const auto& diverged = frames.live->diverged()) throw diverged_error(options.scene, *diverged);
  return interrupt.exit_code();
}

}  // namespace

void add_export_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<ExportOptions>();
  const Command command(
      app, "export", "simulate a scene and write it for other programs: glTF, USD, NumPy",
      {"pabd export pyramid -o pyramid.glb --time 5", "pabd export four_bar -o pen.glb --trail pen",
       "pabd export bridge -o bridge.usda --time 3 --fps 24", "pabd export pyramid -o pyramid.npz --time 5",
       "pabd export pyramid -o seen.glb --recording run.pabdrec"},
      options->common);
  using namespace group;
  command.scene(options->scene);
  command.output(options->output, export_help());
  auto* frames = command.length(
      options->length, "length (default: the duration of the scene, or 5 s; of a recording all of it)",
      "frames a second (default 30; of an .npz every step)");
  command.quality(options->quality, "around round bodies draft: 16, good: 48 (default), best: 96 segments");
  command.trail(options->trails, ", as a line");
  command.flag(kPicture, "--trails", options->all_trails, "the paths of all movable bodies");
  auto* from = command.from(options->from);
  command.simulation(options->common);
  auto* device = add_device_option(command, options->device);
  command
      .option(kSimulation, "--recording", options->recording,
              "no new steps: a recording of this scene that 'pabd view' saved", "RUN.pabdrec")
      ->excludes(from)
      ->excludes(frames)
      ->excludes(device);
  command.carry_out(action, options, export_run);
}

}  // namespace pabd::cli
