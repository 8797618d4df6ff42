// SPDX-License-Identifier: MIT
// Videos of the past: see pictures.h.
//
//   Runner (a copy of the runs) → PastSource (FrameThread) → RunsPainter (here) → AsyncSink (a thread) → file
#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "app/frames/frame_text.h"
#include "app/frames/frame_thread.h"
#include "app/gui/camera_motion.h"
#include "app/gui/pictures.h"
#include "app/workbench/check_output.h"
#include "sim/base/counted.h"
#include "sim/base/error.h"

namespace pabd {

struct Recorder::Job {
  command::Record record;
  VideoOptions video;
  std::string overlay_text, camera_text;
  std::optional<FollowedView> view;  // of the camera, unless it flies along its keys
  TrailRecorder trails;
  OverlayChoice overlay;
  CameraOption camera;
  AbView ab_view = AbView::ghost;
  std::future<RunCopies> runs;
  std::vector<std::shared_ptr<const Scene>> scenes;
  std::unique_ptr<PastSource> source;
  std::unique_ptr<FrameThread> frames;
  std::unique_ptr<RunsPainter> painter;
  std::unique_ptr<AsyncSink> sink;
  std::future<void> finished;
  Image image;
  int drawn = 0, written = 0;
  bool stopping = false;  // with what is there
};

void Recorder::JobDeleter::operator()(Job* job) const { delete job; }

namespace {

void check(const char* what, double value, double lo, double hi) {
  if (value >= lo && value <= hi) return;
  throw Error(ErrorKind::bad_input,
              fmt::format("record: {}: expected {:g} to {:g}, got {:g}", what, lo, hi, value));
}

// How the file is encoded. Throws Error(bad_input) for what does not fit its kind.
VideoOptions video_of(const command::Record& record) {
  VideoOptions video;
  try {
    if (record.crf >= 0) video.crf = record.crf;
    video.preset = record.preset;
    if (record.loop != 0) video.plays = record.loop;
    video.encoder = parse_video_encoder(record.encoder);
    check_video_options(std::filesystem::path(record.path).extension().string(), video);
  } catch (const Error& error) {
    const std::string said = error.what();
    throw Error(error.kind(), "record: " + (said.starts_with("--") ? said.substr(2) : said));
  }
  return video;
}

template <class T>
bool ready(const std::future<T>& future) {
  return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace

void Recorder::start(const command::Record& record, const Snapshot& sim, const UiState& ui) {
  if (busy()) throw Error(ErrorKind::bad_input, "record: one video is being made; stop it first");
  check("fps", record.fps, 0.01, 1000);
  check("width", record.width, 16, 16384);
  check("height", record.height, 16, 16384);
  check("from", record.from, -1, 1e9);
  check("to", record.to, -1, 1e9);
  if (record.path == "-") throw Error(ErrorKind::bad_input, "record: expected the name of a file");
  check_output(record.path, record.force);
  std::unique_ptr<Job, JobDeleter> job(new Job);
  job->record = record;
  job->video = video_of(record);
  job->overlay_text = record.overlay.empty() ? overlay_words(ui) : record.overlay;
  job->overlay = parse_overlay(job->overlay_text);
  job->overlay.theme = ui.theme;
  job->overlay.color_by(ui.color);
  if (job->overlay.contacts) job->overlay.show_contacts_by(ui.contacts_by);
  job->trails = TrailRecorder(ui.trails, kTrailTime);
  if (ui.fly && !ui.camera_keys.empty()) {
    job->camera.keys = ui.camera_keys;
  } else {
    job->view = followed_view(sim, ui);
  }
  job->ab_view = ui.side_by_side ? AbView::side : AbView::ghost;
  job->runs = runner_.copy_runs();
  job_ = std::move(job);
}

void Recorder::begin(RunCopies runs) {
  Job& job = *job_;
  std::vector<Run> list = runs_of(std::move(runs.a), std::move(runs.b));
  for (const Run& run : list) job.scenes.push_back(run.shared_scene());
  const OverlayChoice& overlay = job.overlay;
  job.source = std::make_unique<PastSource>(
      std::move(list), PastRange{job.record.from, job.record.to, job.record.fps}, overlay.needs_iterations(),
      overlay.needs_contacts(), job.trails, overlay.needs_bodies());
  job.frames = std::make_unique<FrameThread>(*job.source);
}

// With the first frame everything that pictures have in common is known.
void Recorder::open(const Frame& first) {
  Job& job = *job_;
  const command::Record& r = job.record;
  if (job.view) {
    job.camera_text = camera_words(*job.view, *first.a().model, *first.a().state);
    job.camera = parse_camera(job.camera_text);
  }
  std::vector<std::string> trails;
  for (const TrailPoint& point : job.trails.points()) trails.push_back(trail_words(point));
  job.painter = std::make_unique<RunsPainter>(context_, job.scenes, first, Arrangement{job.ab_view}, r.width,
                                              r.height, job.overlay, job.camera, job.source->count() / r.fps);
  const ViewFacts facts{.width = r.width,
                        .height = r.height,
                        .fps = r.fps,
                        .overlay = job.overlay_text,
                        .camera = camera_text(job.camera, job.camera_text),
                        .gl_renderer = job.painter->gl_renderer(),
                        .theme = std::string(job.overlay.theme->name),
                        .color_by = kColorNames[static_cast<std::size_t>(job.overlay.color)],
                        .contacts_by = kContactQuantities[static_cast<std::size_t>(job.overlay.contacts_by)],
                        .trails = std::move(trails)};
  const PngText common = common_text(*job.scenes.front(), facts, first.a(), first.b(),
                                     job.ab_view == AbView::side ? "side" : "ghost", job.scenes.back().get());
  SinkOptions options;
  options.width = r.width;
  options.height = r.height;
  options.fps = r.fps;
  options.force = r.force;
  options.about = common;
  options.video = job.video;
  options.png_text = [common, source = job.source.get()](int frame) {
    return frame_text(common, frame, source->time(frame));
  };
  job.sink = std::make_unique<AsyncSink>(make_sink(r.path, options));
}

void Recorder::deliver() {
  job_->painter->fetch(job_->image);
  job_->sink->write(job_->image);
  ++job_->written;
}

void Recorder::draw(const Frame& frame) {
  Job& job = *job_;
  if (!job.painter) open(frame);
  job.painter->draw(frame);
  ++job.drawn;
  if (job.painter->queued() > 1) deliver();
}

// An encoder takes its time at the end.
void Recorder::finish() {
  Job& job = *job_;
  while (job.painter && job.painter->queued() > 0) deliver();
  job.finished = std::async(std::launch::async, [sink = job.sink.get()] { sink->finish(); });
}

std::optional<Recorder::Outcome> Recorder::work(std::chrono::milliseconds budget, bool all) {
  using Clock = std::chrono::steady_clock;
  Job& job = *job_;
  const auto end = Clock::now() + budget;
  if (!job.source) {
    if (!all && !ready(job.runs)) return std::nullopt;
    begin(job.runs.get());
    if (!all)
      return Outcome{fmt::format("recording {}: {}", counted(job.source->count(), "frame"), job.record.path),
                     false};
  }
  while (!job.finished.valid() && !job.stopping && job.drawn < job.source->count()) {
    if (!all && (Clock::now() >= end || (job.sink && !job.sink->has_room()))) return std::nullopt;
    const auto frame = job.frames->next(all);
    if (!frame && !all) return std::nullopt;
    if (!frame) break;
    draw(*frame);
  }
  if (!job.finished.valid()) {
    if (job.drawn == 0) job.frames->next(true);  // throws why
    if (job.drawn == 0) return Outcome{"record: stopped before the first frame; nothing was written", false};
    finish();
  }
  if (!all && !ready(job.finished)) return std::nullopt;
  job.finished.get();
  return Outcome{fmt::format("saved {}: {}, {:.3g} s at {:g} a second", job.record.path,
                             counted(job.written, "frame"), job.written / job.record.fps, job.record.fps),
                 false};
}

std::optional<Recorder::Outcome> Recorder::update(std::chrono::milliseconds budget, bool all) {
  if (!busy()) return std::nullopt;
  std::optional<Outcome> outcome;
  bool over = true;
  try {
    const bool began = job_->source != nullptr;
    outcome = work(budget, all);
    over = outcome.has_value() && (all || began);
  } catch (const std::exception& error) {
    outcome = Outcome{error.what(), true};
  }
  if (over && outcome) job_.reset();
  return outcome;
}

void Recorder::stop(bool keep) {
  if (!busy()) throw Error(ErrorKind::bad_input, "stop_record: nothing is being recorded");
  if (keep && job_->drawn > 0) {
    job_->stopping = true;
  } else {
    job_.reset();
  }
}

Recorder::Progress Recorder::progress() const {
  if (!busy()) return {};
  return {job_->record.path, job_->drawn, job_->source ? job_->source->count() : 0, job_->finished.valid()};
}

}  // namespace pabd
