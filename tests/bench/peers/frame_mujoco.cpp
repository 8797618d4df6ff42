// SPDX-License-Identifier: MIT
// What MuJoCo's off-screen renderer takes for a frame: the pyramid's boxes, or a pile of a thousand boxes, balls and
// capsules, on a plane, lit and with shadows; its defaults but for the size of the frame. Beside bench_frame.
//
//     bench_peers_mujoco_frame pyramid|pile [WIDTHxHEIGHT] [FRAMES] [PICTURE.ppm]
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>
#include <variant>
#include <vector>

#include "sim/scene/scene.h"
#include "sim/solver/time_step.h"

namespace {

using namespace pabd;

// A context with the fixed functions that MuJoCo draws with; pabd's own are of the core profile.
bool make_current() {
  const auto get =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  const EGLDisplay display =
      get ? get(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr) : EGL_NO_DISPLAY;
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return false;
  const EGLint want[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display, want, &config, 1, &count) || count < 1 || !eglBindAPI(EGL_OPENGL_API))
    return false;
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
  return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
}

// The scene where it is, as fixed geometry. MuJoCo's z is up, pabd's y.
std::string mjcf(const Scene& scene, int width, int height) {
  std::string bodies;
  for (std::size_t i = 0; i < scene.model.shape.size(); ++i) {
    if (std::holds_alternative<Plane>(scene.model.shape[i])) continue;
    const Vec3 c = scene.initial.c[i];
    const Eigen::Quaterniond q(scene.initial.R[i]);
    std::string shape;
    double turn = 0;  // capsules lie along y here, along z there
    if (const auto* box = std::get_if<Box>(&scene.model.shape[i])) {
      shape = fmt::format("type='box' size='{} {} {}'", box->half.x(), box->half.y(), box->half.z());
    } else if (const auto* ball = std::get_if<Sphere>(&scene.model.shape[i])) {
      shape = fmt::format("type='sphere' size='{}'", ball->radius);
    } else if (const auto* capsule = std::get_if<Capsule>(&scene.model.shape[i])) {
      shape = fmt::format("type='capsule' size='{} {}'", capsule->radius, capsule->length / 2);
      turn = -std::acos(0.0);
    } else {
      continue;
    }
    const Eigen::Quaterniond up(Eigen::AngleAxisd(std::acos(0.0), Vec3::UnitX()));
    const Eigen::Quaterniond r = up * q * Eigen::Quaterniond(Eigen::AngleAxisd(turn, Vec3::UnitX()));
    const Vec3 p = up * c;
    bodies += fmt::format("<geom {} pos='{} {} {}' quat='{} {} {} {}' rgba='{} .5 .3 1'/>\n", shape, p.x(),
                          p.y(), p.z(), r.w(), r.x(), r.y(), r.z(), 0.2 + 0.6 * double(i % 5) / 4);
  }
  return fmt::format(
      "<mujoco><visual><global offwidth='{}' offheight='{}'/></visual><asset><texture name='g' type='2d' "
      "builtin='checker' "
      "rgb1='.8 .8 .8' rgb2='.7 .7 .7' width='256' height='256'/><material name='g' texture='g' "
      "texrepeat='20 20'/>"
      "<texture type='skybox' builtin='gradient' rgb1='.8 .85 .9' rgb2='.6 .7 .75' width='256' "
      "height='256'/></asset>"
      "<worldbody><light directional='true' pos='0 0 20' dir='-.6 .2 -1'/>"
      "<geom type='plane' size='20 20 1' material='g'/>{}</worldbody></mujoco>",
      width, height, bodies);
}

double cpu_ms() { return 1e3 * double(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

int main(int argc, char** argv) {
  const std::string name = argc > 1 ? argv[1] : "pyramid";
  int width = 1280, height = 720;
  if (argc > 2) std::sscanf(argv[2], "%dx%d", &width, &height);
  const int frames = argc > 3 ? std::atoi(argv[3]) : 30;
  if (!make_current()) return std::fprintf(stderr, "no EGL context without a surface\n"), 4;

  Scene scene = load_scene(PABD_SCENES "/" + name + ".json");
  StepWorkspace workspace;
  StepReport report;
  for (int k = 0; k < (name == "pile" ? 240 : 6); ++k)
    step(scene.model, scene.params, {false, false, 2}, scene.initial, workspace, report);

  const std::string path = fmt::format("/tmp/pabd_mujoco_{}.xml", name);
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (file == nullptr) return 3;
  const std::string xml = mjcf(scene, width, height);
  std::fwrite(xml.data(), 1, xml.size(), file);
  std::fclose(file);
  char error[500] = "";
  mjModel* model = mj_loadXML(path.c_str(), nullptr, error, sizeof error);
  std::remove(path.c_str());
  if (model == nullptr) return std::fprintf(stderr, "%s\n", error), 3;
  mjData* data = mj_makeData(model);
  mj_forward(model, data);

  mjvCamera camera;
  mjvOption option;
  mjvScene view;
  mjrContext context;
  mjv_defaultCamera(&camera);
  mjv_defaultOption(&option);
  mjv_defaultScene(&view);
  mjr_defaultContext(&context);
  mjv_makeScene(model, &view, 5000);
  mjr_makeContext(model, &context, mjFONTSCALE_100);
  mjr_setBuffer(mjFB_OFFSCREEN, &context);
  mjv_defaultFreeCamera(model, &camera);
  camera.azimuth = 60;
  camera.elevation = -20;

  const mjrRect all{0, 0, width, height};
  std::vector<unsigned char> rgb(std::size_t(width) * height * 3);
  const auto frame = [&] {
    mjv_updateScene(model, data, &option, nullptr, &camera, mjCAT_ALL, &view);
    mjr_render(all, &view, &context);
    mjr_readPixels(rgb.data(), nullptr, all, &context);
  };
  frame();
  const auto start = std::chrono::steady_clock::now();
  const double cpu = cpu_ms();
  for (int k = 0; k < frames; ++k) frame();
  const double wall =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  std::printf("mujoco %s, %s, %dx%d, %d samples: %.1f ms of wall clock, %.1f ms of CPU a frame\n",
              mj_versionString(), name.c_str(), width, height, context.offSamples, wall / frames,
              (cpu_ms() - cpu) / frames);
  if (argc > 4) {
    std::FILE* out = std::fopen(argv[4], "wb");
    if (out == nullptr) return 3;
    std::fprintf(out, "P6\n%d %d\n255\n", width, height);
    for (int y = height; y-- > 0;)
      std::fwrite(rgb.data() + std::size_t(y) * width * 3, 3, std::size_t(width), out);
    std::fclose(out);
  }
}
