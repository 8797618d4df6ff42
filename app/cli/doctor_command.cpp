// SPDX-License-Identifier: MIT
// pabd doctor: what this machine offers, and what helps where something is missing.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <vector>

#include "app/cli/common.h"
#include "app/cli/machine.h"
#include "app/cli/scene_lookup.h"
#include "app/cli/streams.h"
#include "app/plots/font_data.h"
#include "render/device/device_capacity.h"
#include "render/gl/renderer.h"
#include "render/output/video_options.h"
#include "sim/base/child_process.h"
#include "sim/base/counted.h"
#include "sim/base/error.h"

namespace pabd::cli {
namespace {

struct DoctorOptions {
  CommonOptions common;
  bool json = false;
};

struct GlFacts {
  std::vector<ContextAttempt> attempts;
  std::string context;    // name of the one taken; empty: none
  std::string renderer;   // GL_RENDERER
  std::string version;    // GL_VERSION
  DeviceCapacity solver;  // of a context that there is
};

struct FfmpegFacts {
  bool found = false;
  std::string version;
  // What is against each, by trying to encode a frame; empty: nothing.
  std::string h264;   // libx264, for .mp4
  std::string vp9;    // libvpx-vp9, for .webm
  std::string nvenc;  // h264_nvenc
};

constexpr double kPatience = 10;  // seconds for another program to tell about itself
const char* const kGlRemedy = "apt-get install libegl1 libegl-mesa0 libgl1-mesa-dri libosmesa6";
const char* const kFfmpegRemedy = "apt-get install ffmpeg (videos only; PNG frames and raw RGB need none)";

// Runs a program without a shell; its standard output, or empty when it cannot be run or fails.
std::string capture(const std::vector<std::string>& arguments) {
  std::string text;
  const ChildOutcome outcome = run_child(
      arguments, kPatience, [&](std::string_view line) { text += std::string(line) + "\n"; }, kPatience);
  return outcome.status == 0 ? text : "";
}

// Throws Error(no_context) unless a ball before the background is seen in a picture of it.
void draw_ball(Renderer& renderer) {
  VisualScene scene;
  Instance ball;
  ball.transform.setIdentity();
  ball.transform.topRightCorner<3, 1>() = scene.camera.target;
  ball.color = {0.8f, 0.2f, 0.1f, 1};
  scene.instances[static_cast<std::size_t>(Primitive::sphere)].push_back(ball);
  renderer.draw(scene, nullptr);
  renderer.queue_read();
  Image image;
  const bool drawn = renderer.fetch(image) && !image.rgb.empty();
  const auto red = [&](int x, int y) { return image.rgb[3 * static_cast<std::size_t>(y * image.width + x)]; };
  if (!drawn || red(image.width / 2, image.height / 2) == red(1, 1))
    throw Error(ErrorKind::no_context, "a ball that was drawn is not in the picture; " + driver_remedy());
}

GlFacts find_gl() {
  GlFacts facts;
  try {
    const auto context = create_headless_context(Backend::automatic, facts.attempts);
    context->make_current();
    facts.context = context->name();
    Renderer renderer(*context, 64, 64);
    draw_ball(renderer);
    facts.renderer = renderer.gl_renderer();
    facts.version = renderer.gl_version();
    facts.solver = device_capacity(*context);
  } catch (const Error& error) {
    if (facts.attempts.empty() || !facts.context.empty())
      facts.attempts.push_back({facts.context, error.what()});
    facts.context.clear();
  }
  return facts;
}

FfmpegFacts find_ffmpeg() {
  FfmpegFacts facts;
  const std::string banner = capture({"ffmpeg", "-hide_banner", "-version"});
  facts.found = !banner.empty();
  if (!facts.found) return facts;
  std::istringstream words(banner);  // "ffmpeg version 5.1.6-0+deb12u1 Copyright …"
  std::string word;
  words >> word >> word >> facts.version;
  facts.h264 = encoder_complaint(".mp4", {});
  facts.vp9 = encoder_complaint(".webm", {});
  VideoOptions on_gpu;
  on_gpu.encoder = VideoEncoder::nvenc;
  facts.nvenc = encoder_complaint(".mp4", on_gpu);
  return facts;
}

// Two digits of it: 131072 is about 130000.
std::int64_t rounded(std::int64_t bodies) {
  std::int64_t unit = 1;
  while (bodies / unit >= 100) unit *= 10;
  return (bodies + unit / 2) / unit * unit;
}

// "not tried: NVIDIA H200, OpenGL 4.6, buffers of up to 4 GiB, about 1200000 bodies; …": a step takes seconds to compile.
std::string gl_solver_text(const GlFacts& gl) {
  const DeviceCapacity& solver = gl.solver;
  if (gl.context.empty()) return "no: there is no OpenGL";
  if (!solver.why_not.empty()) return "no: " + solver.why_not;
  constexpr double kGiB = 1024.0 * 1024 * 1024;
  const std::string free =
      solver.memory > 0 ? fmt::format(", {:.1f} GiB free", static_cast<double>(solver.memory) / kGiB) : "";
  return fmt::format(
      "not tried: {}, OpenGL {}, buffers of up to {:.3g} GiB{}, about {} bodies{}; 'pabd run drop --device "
      "gpu --steps 1' tries it",
      solver.renderer, solver.version, static_cast<double>(solver.largest_buffer) / kGiB, free,
      rounded(solver.bodies), solver.hardware ? "" : "; software: for tests only");
}

nlohmann::ordered_json solver_json(const GlFacts& gl) {
  const DeviceCapacity& solver = gl.solver;
  const bool can = !gl.context.empty() && solver.why_not.empty();
  const auto or_null = [](std::int64_t value) {
    return value > 0 ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
  };
  return {{"available", can},
          {"tried", false},
          {"hardware", can && solver.hardware},
          {"renderer", solver.renderer},
          {"version", solver.version},
          {"largest_buffer_bytes", or_null(solver.largest_buffer)},
          {"free_memory_bytes", or_null(solver.memory)},
          {"bodies", or_null(solver.bodies)},
          {"why_not", gl.context.empty() ? "there is no OpenGL" : solver.why_not}};
}

nlohmann::ordered_json to_json(const GlFacts& gl, const FfmpegFacts& ffmpeg, const CpuFacts& cpu) {
  auto attempts = nlohmann::ordered_json::array();
  for (const ContextAttempt& attempt : gl.attempts) {
    attempts.push_back({{"name", attempt.name}, {"failure", attempt.failure}});
  }
  return {
      {"version", PABD_VERSION},
      {"gl",
       {{"available", !gl.context.empty()},
        {"context", gl.context},
        {"renderer", gl.renderer},
        {"version", gl.version},
        {"attempts", attempts}}},
      {"gpu_solver", solver_json(gl)},
      {"ffmpeg",
       {{"available", ffmpeg.found},
        {"version", ffmpeg.version},
        {"libx264", ffmpeg.found && ffmpeg.h264.empty()},
        {"libvpx-vp9", ffmpeg.found && ffmpeg.vp9.empty()},
        {"h264_nvenc", ffmpeg.found && ffmpeg.nvenc.empty()}}},
      {"cpu", to_json(cpu)},
      {"build", build_text()},
      {"font_bytes", font_bytes().size()},
      {"shipped_scenes", shipped_scenes().size()},
  };
}

std::string to_text(const GlFacts& gl, const FfmpegFacts& ffmpeg, const CpuFacts& cpu) {
  const auto encodes = [](const std::string& complaint) {
    return complaint.empty() ? std::string("works") : fmt::format("no ({})", complaint);
  };
  std::string text = "pabd " PABD_VERSION "\n";
  text += gl.context.empty()
              ? fmt::format("OpenGL      none; {}\n", kGlRemedy)
              : fmt::format("OpenGL      {}\n            {} · {}\n", gl.context, gl.renderer, gl.version);
  for (const ContextAttempt& attempt : gl.attempts) {
    text += fmt::format("            {}: {}\n", attempt.name,
                        attempt.failure.empty() ? "works" : attempt.failure);
  }
  text += fmt::format("GPU solver  {}\n", gl_solver_text(gl));
  text += ffmpeg.found
              ? fmt::format("ffmpeg      {} · libx264 (.mp4) {} · libvpx-vp9 (.webm) {} · h264_nvenc {}\n",
                            ffmpeg.version, encodes(ffmpeg.h264), encodes(ffmpeg.vp9), encodes(ffmpeg.nvenc))
              : fmt::format("ffmpeg      none; {}\n", kFfmpegRemedy);
  text += fmt::format("CPU         {} · {} · {} · {:.1f} GiB\n", cpu.model.empty() ? "unknown" : cpu.model,
                      counted(cpu.limits.cores, "core"), cpu.simd, cpu.memory_gib);
  text +=
      fmt::format("threads     {} by default: {}\n", default_threads(cpu.limits), thread_reason(cpu.limits));
  text += fmt::format("build       {}\n", build_text());
  text += fmt::format("font        DejaVu Sans, embedded ({} kB)\n", font_bytes().size() / 1000);
  text += fmt::format("scenes      {} shipped\n", shipped_scenes().size());
  return text;
}

int doctor(const DoctorOptions& options) {
  const GlFacts gl = find_gl();
  const FfmpegFacts ffmpeg = find_ffmpeg();
  const CpuFacts cpu = find_cpu();
  write_stdout(options.json ? json_text(to_json(gl, ffmpeg, cpu)) : to_text(gl, ffmpeg, cpu));
  return 0;
}

}  // namespace

void add_doctor_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<DoctorOptions>();
  const Command command(app, "doctor", "what GL, ffmpeg and CPU this machine offers, and what to install",
                        {"pabd doctor", "pabd doctor --json"}, options->common);
  command.flag(group::kOwn, "--json", options->json, "print it as JSON");
  command.carry_out(action, options, doctor);
}

}  // namespace pabd::cli
