// SPDX-License-Identifier: MIT
// Videos and pictures from the window are, byte for byte, what the render pipeline makes of the same run with
// the same camera.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/frames/frame_source.h"
#include "app/frames/frame_text.h"
#include "app/frames/render_pipeline.h"
#include "app/frames/runs_painter.h"
#include "app/gui/script.h"
#include "render/output/png.h"
#include "tests/support/places.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_pictures {

namespace fs = std::filesystem;

namespace {

const std::string kPictureScene = places::scenes() + "/two_boxes.json";
constexpr const char* kCamera = "eye=3,2,4,target=0,0.5,0,fov=40";

std::unique_ptr<GlContext> make_context() {
  std::vector<ContextAttempt> attempts;
  return create_headless_context(Backend::automatic, attempts);
}

// As `pabd render -o out --frames count --fps fps --size 160x90` does.
void render(const std::string& out, int count, double fps, const std::string& overlay_text,
            const std::string& camera, const std::vector<std::string>& sets = {},
            ColorQuantity bodies_by = ColorQuantity::body,
            ContactQuantity contacts_by = ContactQuantity::gap) {
  const auto context = make_context();
  Run run(std::make_shared<const Scene>(load_scene(kPictureScene, sets)), 1, kNoPast);
  OverlayChoice overlay = parse_overlay(overlay_text);
  overlay.color_by(bodies_by);
  overlay.show_contacts_by(contacts_by);
  run.observe(overlay.needs_iterations(), overlay.needs_contacts(), overlay.needs_bodies());
  const CameraOption option = parse_camera(camera);
  const Frame start = make_frame(0, {run.view()});
  RunsPainter painter(*context, {run.shared_scene()}, start, {}, 160, 90, overlay, option);
  const FrameRange range{0, count, fps};
  ViewFacts facts{160, 90, fps, overlay_text, camera_text(option, camera), painter.gl_renderer()};
  facts.color_by = kColorNames[static_cast<std::size_t>(bodies_by)];
  facts.contacts_by = kContactQuantities[static_cast<std::size_t>(contacts_by)];
  const PngText common = common_text(run.scene(), facts, start.a());
  AsyncSink sink(make_sink(out, sink_options(start.a(), common, range, 160, 90, 0)));
  LiveSource source(runs_of(std::move(run)), range);
  render_frames(source, painter, sink, {[] { return false; }, [](int, const StepSummary&) {}});
}

void play(const std::string& actions, const fs::path& folder) {
  const auto context = make_context();
  Runner runner(std::make_unique<Workbench>(WorkbenchOptions{}, command::Load{kPictureScene, {}, false}));
  ViewerOptions options;
  options.steady = true;
  Viewer viewer(*context, runner, options);
  Script(actions, "s").run(viewer, runner, {folder, false, 640, 360, {}, {}, {}, {}});
}

void check_same(const fs::path& folder, const char* a, const char* b, int count) {
  for (int frame = 0; frame < count; ++frame) {
    INFO(frame);
    const std::string mine = read_bytes(frame_path((folder / a).string(), frame));
    CHECK_FALSE(mine.empty());
    const bool same = mine == read_bytes(frame_path((folder / b).string(), frame));
    CHECK(same);
  }
  CHECK_FALSE(fs::exists(frame_path((folder / a).string(), count)));
}

}  // namespace

TEST_CASE("a video of the past is what render makes of the run") {
  const TempFolder folder;
  play(R"([{"do":"step","steps":24},{"do":"look","eye":[3,2,4],"target":[0,0.5,0],"fov":40},
           {"do":"record","path":"{out}/a{frame:03}.png","width":160,"height":90,"to":0.3334},
           {"do":"record","path":"{out}/c{frame:03}.png","width":160,"height":90,"to":0.2,"fps":100,
            "overlay":"convergence,series,contacts"},
           {"do":"expect","at":"/message","contains":"saved"}])",
       folder.path());
  render((folder.path() / "b{frame:03}.png").string(), 20, 60, "contacts,bonds", kCamera);
  check_same(folder.path(), "a{frame:03}.png", "b{frame:03}.png", 20);
  render((folder.path() / "d{frame:03}.png").string(), 20, 100, "convergence,series,contacts", kCamera);
  check_same(folder.path(), "c{frame:03}.png", "d{frame:03}.png", 20);
}

TEST_CASE("a video of the past has the colours of the window, as render draws them") {
  const TempFolder folder;
  play(R"([{"do":"step","steps":24},{"do":"look","eye":[3,2,4],"target":[0,0.5,0],"fov":40},
           {"do":"color_by","quantity":"energy"},{"do":"show","what":"contacts","on":false},
           {"do":"contacts_by","quantity":"force"},{"do":"expect","at":"/ui/contacts","is":true},
           {"do":"expect","at":"/ui/contacts_by","is":"force"},
           {"do":"record","path":"{out}/a{frame:03}.png","width":160,"height":90}])",
       folder.path());
  render((folder.path() / "b{frame:03}.png").string(), 24, 60, "contacts,bonds", kCamera, {},
         ColorQuantity::energy, ContactQuantity::force);
  check_same(folder.path(), "a{frame:03}.png", "b{frame:03}.png", 24);
}

TEST_CASE("parameters that were set at the start are those of the video, and the camera flies the same way") {
  const TempFolder folder;
  play(R"([{"do":"set","key":"contact.kappa","value":50},
           {"do":"look","eye":[3,2,4],"target":[0,0.5,0],"fov":40},{"do":"add_camera_key"},
           {"do":"step","steps":20},
           {"do":"look","eye":[-3,1,4],"target":[0,0.7,0],"fov":50},{"do":"add_camera_key"},
           {"do":"save_camera","path":"{out}/keys.json"},{"do":"fly"},
           {"do":"record","path":"{out}/a{frame:03}.png","width":160,"height":90}])",
       folder.path());
  const std::string keys = (folder.path() / "keys.json").string();
  render((folder.path() / "b{frame:03}.png").string(), 20, 60, "contacts,bonds", keys, {"contact.kappa=50"});
  // The hash of the scene is that before --set, everything else is the same.
  for (int frame = 0; frame < 20; ++frame) {
    INFO(frame);
    const fs::path a = frame_path((folder.path() / "a{frame:03}.png").string(), frame);
    const fs::path b = frame_path((folder.path() / "b{frame:03}.png").string(), frame);
    const bool same = read_png(a).rgb == read_png(b).rgb;
    CHECK(same);
    PngText mine = read_png_text(a), theirs = read_png_text(b);
    mine.erase("Scene hash");
    theirs.erase("Scene hash");
    CHECK(mine == theirs);
  }
  const bool moved = read_png(folder.path() / "a000.png").rgb != read_png(folder.path() / "a019.png").rgb;
  CHECK(moved);
}

TEST_CASE("a screenshot without panels is the picture that render makes of that step") {
  const TempFolder folder;
  play(R"([{"do":"step","steps":12},{"do":"look","eye":[3,2,4],"target":[0,0.5,0],"fov":40},
           {"do":"screenshot","path":"{out}/a.png","ui":false,"width":160,"height":90},
           {"do":"screenshot","path":"{out}/w.png"}])",
       folder.path());
  render((folder.path() / "b{frame:03}.png").string(), 13, 60, "contacts,bonds", kCamera);
  const Image mine = read_png(folder.path() / "a.png"), theirs = read_png(folder.path() / "b012.png");
  const bool same = mine.rgb == theirs.rgb;
  CHECK(same);
  const PngText text = read_png_text(folder.path() / "a.png");
  const PngText other = read_png_text(folder.path() / "b012.png");
  for (const char* key :
       {"Software", "Scene", "Scene hash", "Parameters", "Start", "GL_RENDERER", "Frame", "Time"})
    CHECK(text.at(key) == other.at(key));
  CHECK(read_png(folder.path() / "w.png").width == 640);
}

TEST_CASE("the plot of a panel is written as what its name says") {
  const TempFolder folder;
  play(R"([{"do":"step","steps":12},
           {"do":"series_view","quantity":"chosen","x":"step","y":"kinetic"},
           {"do":"export_plot","panel":"series","path":"{out}/s.csv"},
           {"do":"export_plot","panel":"series","path":"{out}/s.svg"},
           {"do":"export_plot","panel":"barrier","path":"{out}/b.pdf"},
           {"do":"export_plot","panel":"convergence","path":"{out}/c.png","width":500,"height":350},
           {"do":"frame","path":"after.png"},
           {"do":"export_plot","panel":"series","path":"{out}/s.svg","may_fail":true},
           {"do":"expect","at":"/message","contains":"s.svg"},
           {"do":"export_plot","panel":"scenes","path":"{out}/x.svg","may_fail":true},
           {"do":"expect","at":"/message","contains":"not one of \"barrier\""},
           {"do":"export_plot","panel":"series","path":"{out}/x.txt","may_fail":true},
           {"do":"expect","at":"/message","contains":".csv"}])",
       folder.path());
  const auto text = [&](const char* name) {
    std::ifstream in(folder.path() / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const std::string csv = text("s.csv");
  CHECK(csv.starts_with("plot,series,x,y\n"));
  // The header, a row for the start and each step, and the one where the run is.
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 1 + 13 + 1);
  CHECK(text("s.svg").find("step 12") != std::string::npos);
  CHECK(text("b.pdf").starts_with("%PDF"));
  CHECK(read_png(folder.path() / "c.png").width == 500);
  CHECK(read_png_text(folder.path() / "c.png").at("Caption").find("step 12") != std::string::npos);
}

TEST_CASE("frames of the past: which moment each shows") {
  const auto scene = std::make_shared<const Scene>(load_scene(kPictureScene));
  Run run(scene, 1, 1 << 24);
  for (int i = 0; i < 30; ++i) REQUIRE(run.advance());
  const double h = run.params().h;
  const auto every = moments_of_frames(run.timeline(), {-1, -1, 1 / h});
  REQUIRE(every.size() == 30);
  for (std::size_t i = 0; i < 30; ++i) CHECK(every[i] == i);
  CHECK(moments_of_frames(run.timeline(), {-1, -1, 0.5 / h}) ==
        std::vector<std::size_t>{0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28});
  CHECK(moments_of_frames(run.timeline(), {10 * h, 12 * h, 1 / h}) == std::vector<std::size_t>{10, 11});
  CHECK(moments_of_frames(run.timeline(), {12 * h, 10 * h, 1 / h}) == std::vector<std::size_t>{12});
  // Other steps in the middle: by time.
  Params params = run.params();
  params.h = h / 2;
  run.set_params(params);
  for (int i = 0; i < 20; ++i) REQUIRE(run.advance());
  const auto mixed = moments_of_frames(run.timeline(), {28 * h, 1e9, 1 / h});
  REQUIRE(mixed.size() == 12);
  CHECK(mixed[2] == 30);
  CHECK(mixed[3] == 32);
  CHECK(mixed[11] == 48);
}

}  // namespace pabd::test_pictures
