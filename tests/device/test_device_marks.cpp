// SPDX-License-Identifier: MIT
// Glyphs of contacts that never leave the GPU: those of the processor, which reads the contacts back.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "render/device/device_bodies.h"
#include "render/device/device_layout.h"
#include "render/device/device_marks.h"
#include "render/output/png.h"
#include "render/visual/body_parts.h"
#include "render/visual/contact_glyphs.h"
#include "tests/device/device_pictures.h"
#include "tests/device/device_scenes.h"
#include "tests/device/drawn_commands.h"
#include "tests/support/tiny_model.h"

namespace pabd::test_device_marks {

using namespace testing;

namespace {

constexpr int kWidth = 640, kHeight = 360;

// Instances of glyphs that the last picture drew.
std::uint32_t drawn(const ComputeFunctions& gl, const DeviceBodies& bodies) {
  std::uint32_t sum = 0;
  for (const DrawnCommand& c : drawn_commands(gl, bodies.batches(DeviceList::glyphs))) sum += c.instances;
  return sum;
}

std::uint32_t glyphs(const VisualScene& scene) {
  std::size_t sum = 0;
  for (const auto& list : scene.instances) {
    for (const Instance& instance : list) sum += instance.xray ? 1 : 0;
  }
  return static_cast<std::uint32_t>(sum);
}

struct Contacts {
  std::vector<ContactReport> reports;
  std::vector<device::ContactTold> told;

  void add(Index a, Index b, const Vec3& y_b, const Vec3& n, double d, double force) {
    reports.push_back({a, b, y_b - d * n, y_b, n, d, force, Vec3::Zero(), false, 0});
    device::ContactTold out{};
    out.ends[0] = static_cast<std::uint32_t>(a);
    out.ends[1] = static_cast<std::uint32_t>(b);
    std::copy_n(y_b.data(), 3, out.y_b);
    std::copy_n(n.data(), 3, out.n);
    out.y_b[3] = d;
    out.n[3] = force;
    told.push_back(out);
  }
};

GlBuffer buffer_of(const ComputeFunctions& gl, const void* data, std::size_t bytes) {
  GlBuffer out(gl);
  gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, out.id());
  gl.BufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
  return out;
}

CompareResult compare(Renderer& renderer, const Twin& twin, DeviceBodies& bodies, const char* name) {
  // On software GL too, which draws shapes of what is not on the GPU.
  const RenderQuality meshes{Quality::best};
  const Image expected = picture(renderer, twin.all, meshes, nullptr);
  const Image actual = picture(renderer, twin.bare, meshes, &bodies);
  if (const char* folder = std::getenv("PABD_KEEP_IMAGES")) {
    write_png(std::string(folder) + "/" + name + "_cpu.png", expected);
    write_png(std::string(folder) + "/" + name + "_gpu.png", actual);
  }
  return compare_images(actual, expected, CompareTier::same_class);
}

}  // namespace

TEST_CASE("glyphs of contacts are the same from the GPU's records, few and many, and of every kind") {
  const auto context = any_context();
  const ComputeFunctions gl(*context);
  TinyModel tiny;
  tiny.add_fixed(Box{{0.3, 0.3, 0.3}}, {0, -1, 0});
  for (int k = 0; k < 40; ++k) tiny.add(Box{{0.3, 0.3, 0.3}}, {k % 8 - 4.0, k / 8 - 1.0, -3});
  constexpr double kHat = 0.02;
  Contacts contacts;
  const Vec3 normals[] = {{0, 1, 0}, {0, -1, 0}, {1, 0, 0},     {-1, 0, 0},
                          {0, 0, 1}, {0, 0, -1}, {0.6, 0, 0.8}, {0.6, 0.8, 0}};
  const bool many = GENERATE(false, true);
  for (Index pair = 0; pair < (many ? 38 : 20); ++pair) {
    const Index a = pair % 3 == 0 ? 0 : pair + 1, b = pair % 3 == 1 ? 0 : pair % 3 == 0 ? pair + 1 : pair + 2;
    for (int k = 0; k < (many ? 9 : 1); ++k) {
      const Vec3 at(pair % 8 - 4.0 + 0.07 * k, pair / 8 - 1.0 + 0.05 * (k % 3), 0.3);
      const Vec3& n = normals[static_cast<std::size_t>(pair + k / 6) % 8];
      const double d = kHat * (0.13 * ((7 * pair + k) % 16) - 0.9),
                   force = pair % 5 == 4 ? 0 : 900 * pair * ((k + 1) % 4);
      if (k % 2 == 0 || pair % 4 != 3) {
        contacts.add(a, b, at, n, d, force);
      } else {
        contacts.add(b, a, at, -n, d, force);  // the other one owns the normal
      }
    }
  }
  contacts.add(1, 2, {0, 0, 0.5}, {0, 1, 0}, 1.5 * kHat, 100);             // open
  contacts.add(1, 2, {0, std::nan(""), 0.5}, {0, 1, 0}, 0.5 * kHat, 100);  // left the numbers
  contacts.add(1, 2, {0, 3, 0.5}, {0, 1, 0}, 0.5 * kHat, INFINITY);
  device::Counters counters{};
  counters.contacts = static_cast<std::uint32_t>(contacts.told.size());
  StepReport report;
  for (const ContactReport& c : contacts.reports) {
    if (c.d < kHat) report.contact_reports.push_back(c);
  }
  counters.pushing = static_cast<std::uint32_t>(report.contact_reports.size());
  REQUIRE((report.contact_reports.size() > kManyContacts) == many);
  // Beyond those that there are, the buffer has others of a step before.
  contacts.add(1, 2, {1, 3, 0.5}, {0, 1, 0}, 0.5 * kHat, 100);
  const GlBuffer told =
      buffer_of(gl, contacts.told.data(), contacts.told.size() * sizeof(device::ContactTold));
  const GlBuffer numbers = buffer_of(gl, &counters, sizeof counters);

  const PoseBuffer poses(gl, tiny.state);
  Renderer renderer(*context, kWidth, kHeight);
  DeviceBodies bodies(*context, body_parts(tiny.model), poses.id(), {.late_bounds = false});
  VisualOptions options;
  options.contacts = true;
  options.d_hat = kHat;
  Camera camera = frame_camera(tiny.model, tiny.state, double{kWidth} / kHeight);
  camera.orthographic = GENERATE(false, true);
  camera.eye += 0.5f * (camera.eye - camera.target);  // all are in sight
  const Twin twin(tiny.model, tiny.state, options, camera, report);
  bodies.mark_contacts(tiny.model, {told.id(), numbers.id(), contacts.told.size()}, {.d_hat = kHat});
  const CompareResult result = compare(renderer, twin, bodies, many ? "many_marks" : "few_marks");
  CAPTURE(many, camera.orthographic, result.reason, result.max_difference, result.differing);
  // Rounding moves a few edges of arrows where forces were added up.
  CHECK((many ? result.differing < 1e-4 : same_but_edges(*context, result)));
  CHECK(glyphs(twin.all) > (many ? 100 : 60));
  CHECK(drawn(gl, bodies) == glyphs(twin.all));
  // And without them it is another picture.
  bodies.mark_contacts(tiny.model, {}, {});
  CHECK_FALSE(compare(renderer, twin, bodies, "no_marks").equal);
}

TEST_CASE("glyphs of a heap's contacts are the same from the solver's buffers, step by step") {
  const auto context = any_context();
  const ComputeFunctions gl(*context);
  const Scene scene = mixed_heap(GENERATE(3, 16), {3, 0, -2});
  // Little room at first: buffers are replaced on the way.
  DeviceSolver solver(*context, scene.model, scene.initial, {.contacts = 16, .report_contacts = true});
  Renderer renderer(*context, kWidth, kHeight);
  DeviceBodies bodies(*context, body_parts(scene.model), solver.pose_buffer(), {.late_bounds = false});
  VisualOptions options;
  options.contacts = true;
  options.d_hat = scene.params.contact.d_hat;
  Camera camera = frame_camera(scene.model, scene.initial, double{kWidth} / kHeight);
  camera.eye += 0.7f * (camera.eye - camera.target);  // all are in sight
  std::size_t most = 0;
  for (int frame = 0; frame < 3; ++frame) {
    for (int k = 0; k < 25; ++k) solver.enqueue(scene.params);
    State state;
    StepReport report;
    solver.read_state(state);
    solver.read_contacts(report.contact_reports);
    most = std::max(most, report.contact_reports.size());
    const Twin twin(scene.model, state, options, camera, report);
    bodies.mark_contacts(scene.model, solver.contact_buffers(), {.d_hat = options.d_hat});
    const CompareResult result = compare(renderer, twin, bodies, "heap_marks");
    CAPTURE(frame, report.contact_reports.size(), result.reason, result.max_difference, result.differing);
    // Those that bodies hide show through in another order, and mix to another colour where they overlap.
    CHECK(result.differing < 1e-3);
    CHECK(drawn(gl, bodies) == glyphs(twin.all));
  }
  CHECK(most > 5);
}

}  // namespace pabd::test_device_marks
