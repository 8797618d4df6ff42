// SPDX-License-Identifier: MIT
// Wavefront OBJ: a file a frame with all bodies where they are, and one .mtl beside them. World coordinates, m, y up.
#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "app/export/body_mesh.h"
#include "app/export/exporter.h"
#include "app/export/motion.h"
#include "app/frames/scene_framing.h"
#include "render/output/frame_sink.h"
#include "render/visual/bounds.h"
#include "sim/base/atomic_file.h"
#include "sim/base/srgb.h"
#include "sim/base/utf8.h"

namespace pabd {
namespace fs = std::filesystem;
namespace {

// Linear light to what .mtl files hold.
float srgb(float light) { return static_cast<float>(srgb_from_linear(static_cast<double>(light))); }

// Names end at a blank.
std::string word_of(const std::string& name) {
  std::string out = one_line(name);
  for (char& c : out)
    if (c == ' ' || c == '#') c = '_';
  return out.empty() ? "_" : out;
}

// "frames/body_{frame:04}.obj" → "frames/body.mtl".
fs::path material_path(const std::string& out) {
  const fs::path path(out);
  std::string stem = path.stem().string();
  if (const auto open = stem.find('{'); open != std::string::npos) {
    const auto close = stem.find('}', open);
    stem.erase(open, close == std::string::npos ? close : close - open + 1);
  }
  while (!stem.empty() && (stem.back() == '_' || stem.back() == '-' || stem.back() == '.')) stem.pop_back();
  return path.parent_path() / ((stem.empty() ? "bodies" : stem) + ".mtl");
}

class ObjExporter : public Exporter {
 public:
  ObjExporter(std::string out, const Scene& scene, const FrameView& start, const ExportSetup& setup)
      : out_(std::move(out)),
        sequence_(is_frame_template(out_)),
        inputs_(setup.inputs),
        model_(start.model),
        bodies_(mesh_bodies(*start.model, looks_of(scene, *start.model), setup.segments)),
        materials_(material_path(out_)) {
    check_overwrite(materials_.string(), materials_, {setup.force, &inputs_});
    check_creatable(materials_);
    if (const auto seen = bounding_sphere(*start.model, *start.state)) {
      middle_ = seen->centre;
      reach_ = kFloor * seen->radius;
    }
  }

  void add(std::int64_t frame, const FrameView& view) override {
    check_same_bodies(*model_, view);
    if (frames_++ == 0) write_materials();
    if (!sequence_) {
      last_ = *view.state;
      return;
    }
    const fs::path path = frame_path(out_, static_cast<int>(frame));
    check_overwrite(path.string(), path, {true, &inputs_});
    write_file(path, text_of(*view.state));
  }

  void finish() override {
    if (!sequence_) write_file(out_, text_of(last_));
  }

 private:
  static constexpr double kFloor = 4;  // half edge of a plane, in radii of what is to be seen at the start

  static std::string material(int number) { return fmt::format("color_{}", number); }

  void write_materials() const {
    std::string text = "# pabd " PABD_VERSION "\n";
    const auto add = [&](const std::string& name, const Vec4f& c) {
      text += fmt::format("newmtl {}\nKd {} {} {}\nd {}\nillum 1\n", name, srgb(c.x()), srgb(c.y()),
                          srgb(c.z()), c.w());
    };
    for (std::size_t k = 0; k < bodies_.materials.size(); ++k)
      add(material(static_cast<int>(k)), bodies_.materials[k]);
    const float* c = kStudioTheme.floor;
    add("floor", {c[0], c[1], c[2], 1});
    write_file(materials_, text);
  }

  std::string text_of(const State& state) const {
    std::string text = fmt::format("# pabd " PABD_VERSION ", t = {} s; m, y up\nmtllib {}\n", state.time,
                                   materials_.filename().string());
    std::size_t next = 1;  // vertices count from 1, through the whole file
    for (std::size_t i = 0; i < bodies_.bodies.size(); ++i) {
      const MeshedBody& body = bodies_.bodies[i];
      text += fmt::format("o {}\n", word_of(body.name));
      if (body.mesh == kNoMesh) {
        const BodyMesh quad = plane_mesh(std::get<Plane>(model_->shape[i]), middle_, reach_);
        add_vertices(quad, Vec3::Zero(), Mat3::Identity(), text);
        add_faces("floor", quad.light, next, text);
        next += quad.positions.size();
        continue;
      }
      const BodyMesh& mesh = bodies_.meshes[static_cast<std::size_t>(body.mesh)];
      add_vertices(mesh, state.c[i], state.R[i], text);
      add_faces(material(body.material), mesh.light, next, text);
      add_faces(material(body.dark_material), mesh.dark, next, text);
      next += mesh.positions.size();
    }
    return text;
  }

  static void add_vertices(const BodyMesh& mesh, const Vec3& c, const Mat3& R, std::string& text) {
    const auto line = [&](const char* what, const Vec3f& v) {
      fmt::format_to(std::back_inserter(text), "{} {} {} {}\n", what, v.x(), v.y(), v.z());
    };
    for (const Vec3f& p : mesh.positions) line("v", (c + R * p.cast<double>()).cast<float>());
    for (const Vec3f& n : mesh.normals) line("vn", (R * n.cast<double>()).cast<float>());
  }

  static void add_faces(const std::string& name, const std::vector<std::uint32_t>& corners, std::size_t first,
                        std::string& text) {
    if (corners.empty()) return;
    text += "usemtl " + name + "\n";
    for (std::size_t k = 0; k + 2 < corners.size(); k += 3) {
      const std::size_t a = first + corners[k], b = first + corners[k + 1], c = first + corners[k + 2];
      fmt::format_to(std::back_inserter(text), "f {0}//{0} {1}//{1} {2}//{2}\n", a, b, c);
    }
  }

  std::string out_;
  bool sequence_;
  InputFiles inputs_;
  std::shared_ptr<const Model> model_;
  MeshedBodies bodies_;
  fs::path materials_;
  Vec3 middle_ = Vec3::Zero();
  double reach_ = 20;  // m, where there is nothing to go by
  std::int64_t frames_ = 0;
  State last_;
};

}  // namespace

std::unique_ptr<Exporter> make_obj_exporter(const std::string& out, const Scene& scene,
                                            const FrameView& start, const ExportSetup& setup) {
  return std::make_unique<ObjExporter>(out, scene, start, setup);
}

}  // namespace pabd
