// SPDX-License-Identifier: MIT
// glTF 2.0 as one binary file (.glb): https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html
//
//   header   "glTF", version 2, length                    12 bytes
//   JSON     length, "JSON", text filled up with blanks   to 4 bytes
//   BIN      length, "BIN\0", the buffer                  to 4 bytes
//
// glTF is in metres, y up and right-handed, as pabd is, and its colours are linear: nothing is turned or scaled.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/export/body_mesh.h"
#include "app/export/exporter.h"
#include "app/export/little_endian.h"
#include "app/export/motion.h"
#include "app/frames/scene_framing.h"
#include "render/visual/body_marks.h"
#include "sim/base/atomic_file.h"
#include "sim/base/error.h"
#include "sim/base/ordered_json.h"
#include "sim/body/shape_kind.h"

namespace pabd {
namespace {

enum Component { kFloat = 5126, kUnsigned = 5125 };
enum Target { kNoTarget = 0, kVertices = 34962, kTriangles = 34963 };
enum Mode { kLineStrip = 3 };

// The buffer: parts of it that are of one kind, a view each; accessors are written into its JSON.
class Buffer {
 public:
  explicit Buffer(OrderedJson& document) : document_(document) {
    document_["accessors"] = OrderedJson::array();
    document_["bufferViews"] = OrderedJson::array();
  }

  // Numbers of `width` components each; returns the accessor. `bounds`: with min and max.
  int add(std::span<const float> values, int width, Target target, bool bounds) {
    static constexpr const char* kTypes[] = {"", "SCALAR", "", "VEC3", "VEC4"};
    OrderedJson accessor = {{"bufferView", view(bytes_of(values), target)},
                            {"componentType", kFloat},
                            {"count", values.size() / static_cast<std::size_t>(width)},
                            {"type", kTypes[width]}};
    if (bounds) {
      for (const auto& [name, better] :
           {std::pair<const char*, bool (*)(float, float)>{"min", [](float a, float b) { return a < b; }},
            {"max", [](float a, float b) { return a > b; }}}) {
        std::vector<float> best(values.begin(), values.begin() + width);
        for (std::size_t k = 0; k < values.size(); ++k) {
          float& at = best[k % static_cast<std::size_t>(width)];
          if (better(values[k], at)) at = values[k];
        }
        accessor[name] = best;
      }
    }
    return push(accessor);
  }

  int add_indices(std::span<const std::uint32_t> indices) {
    return push({{"bufferView", view(bytes_of(indices), kTriangles)},
                 {"componentType", kUnsigned},
                 {"count", indices.size()},
                 {"type", "SCALAR"}});
  }

  const std::string& bytes() const { return bytes_; }

 private:
  int view(std::string_view part, Target target) {
    OrderedJson view = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", part.size()}};
    if (target != kNoTarget) view["target"] = target;
    document_["bufferViews"].push_back(std::move(view));
    bytes_ += part;  // all are of 4-byte numbers: aligned
    return static_cast<int>(document_["bufferViews"].size()) - 1;
  }
  int push(OrderedJson accessor) {
    document_["accessors"].push_back(std::move(accessor));
    return static_cast<int>(document_["accessors"].size()) - 1;
  }

  OrderedJson& document_;
  std::string bytes_;
};

std::span<const float> floats(const std::vector<Vec3f>& list) {
  static_assert(sizeof(Vec3f) == 3 * sizeof(float));
  return {list.empty() ? nullptr : list.front().data(), 3 * list.size()};
}

template <class V>
OrderedJson numbers(const V& v) {
  return std::vector<float>(v.data(), v.data() + v.size());
}

int push(OrderedJson& document, const char* list, OrderedJson item) {
  document[list].push_back(std::move(item));
  return static_cast<int>(document[list].size()) - 1;
}

int add_material(OrderedJson& document, const std::string& name, const Vec4f& color, double roughness,
                 bool two_sided) {
  OrderedJson out = {
      {"name", name},
      {"pbrMetallicRoughness",
       {{"baseColorFactor", numbers(color)}, {"metallicFactor", 0}, {"roughnessFactor", roughness}}}};
  if (color.w() < 1) out["alphaMode"] = "BLEND";
  if (two_sided) out["doubleSided"] = true;
  return push(document, "materials", std::move(out));
}

class GltfExporter : public AnimationExporter {
 public:
  GltfExporter(const std::string& out, const Scene& scene, const FrameView& start, const ExportSetup& setup)
      : AnimationExporter(scene, start, setup),
        file_(out),
        out_(out),
        camera_(scene_camera(scene, 16.0 / 9)) {}

  void finish() override {
    OrderedJson document = {
        {"asset",
         {{"version", "2.0"},
          {"generator", "pabd " PABD_VERSION},
          {"extras", {{"scene", name_}, {"scene_hash", hash_}, {"length_unit", "m"}, {"up", "y"}}}}},
        {"scene", 0},
        {"scenes", OrderedJson::array({OrderedJson{{"name", name_}, {"nodes", OrderedJson::array()}}})}};
    Buffer buffer(document);
    add_bodies(document, buffer);
    add_trails(document, buffer);
    add_camera(document);
    add_animation(document, buffer);
    write(document, buffer.bytes());
  }

 private:
  OrderedJson primitive(const std::pair<int, int>& vertices, int indices, int material) const {
    return {{"attributes", {{"POSITION", vertices.first}, {"NORMAL", vertices.second}}},
            {"indices", indices},
            {"material", material}};
  }

  void add_bodies(OrderedJson& document, Buffer& buffer) {
    for (std::size_t k = 0; k < bodies_.materials.size(); ++k)
      add_material(document, fmt::format("color {}", k), bodies_.materials[k], kBodyRoughness, false);

    struct Accessors {
      std::pair<int, int> vertices;
      int light = -1, dark = -1;
    };
    std::vector<Accessors> of_mesh;
    for (const BodyMesh& mesh : bodies_.meshes) {
      Accessors a;
      a.vertices = {buffer.add(floats(mesh.positions), 3, kVertices, true),
                    buffer.add(floats(mesh.normals), 3, kVertices, false)};
      if (!mesh.light.empty()) a.light = buffer.add_indices(mesh.light);
      if (!mesh.dark.empty()) a.dark = buffer.add_indices(mesh.dark);
      of_mesh.push_back(a);
    }
    // A mesh of glTF has its materials: one for each pair, all of the same accessors.
    std::map<std::pair<int, int>, int> known;
    int floor_material = -1;
    for (std::size_t i = 0; i < bodies_.bodies.size(); ++i) {
      const MeshedBody& body = bodies_.bodies[i];
      OrderedJson node = {{"name", body.name}};
      if (body.mesh == kNoMesh) {
        if (floor_material < 0) {
          const float* c = kStudioTheme.floor;
          floor_material = add_material(document, "floor", {c[0], c[1], c[2], 1}, 1, true);
        }
        const BodyMesh quad =
            plane_mesh(std::get<Plane>(model_->shape[i]), motion_.middle(), motion_.reach());
        const std::pair<int, int> vertices{buffer.add(floats(quad.positions), 3, kVertices, true),
                                           buffer.add(floats(quad.normals), 3, kVertices, false)};
        node["mesh"] = push(
            document, "meshes",
            {{"name", body.name},
             {"primitives",
              OrderedJson::array({primitive(vertices, buffer.add_indices(quad.light), floor_material)})}});
      } else {
        const auto [at, is_new] = known.try_emplace({body.mesh, body.material}, 0);
        if (is_new) {
          const Accessors& a = of_mesh[static_cast<std::size_t>(body.mesh)];
          OrderedJson primitives = OrderedJson::array();
          if (a.light >= 0) primitives.push_back(primitive(a.vertices, a.light, body.material));
          if (a.dark >= 0) primitives.push_back(primitive(a.vertices, a.dark, body.dark_material));
          at->second = push(
              document, "meshes",
              {{"name", std::string(kind_of(model_->shape[i]).name)}, {"primitives", std::move(primitives)}});
        }
        node["mesh"] = at->second;
        node["translation"] = numbers(motion_.position(i, 0));
        node["rotation"] = numbers(motion_.orientation(i, 0));
      }
      document["scenes"][0]["nodes"].push_back(push(document, "nodes", std::move(node)));
    }
  }

  void add_trails(OrderedJson& document, Buffer& buffer) {
    for (std::size_t k = 0; k < motion_.trails().size(); ++k) {
      const std::vector<Vec3f>& path = motion_.trails()[k];
      if (path.size() < 2) continue;
      const Vec4f color = trail_color(k);
      const int material = add_material(document, fmt::format("trail {}", k), color, 1, false);
      document["materials"].back()["extensions"]["KHR_materials_unlit"] = OrderedJson::object();
      document["extensionsUsed"] = OrderedJson::array({"KHR_materials_unlit"});
      const std::string name = "trail of " + trail_words(motion_.trail_points()[k]);
      const int mesh = push(
          document, "meshes",
          {{"name", name},
           {"primitives", OrderedJson::array({OrderedJson{
                              {"attributes", {{"POSITION", buffer.add(floats(path), 3, kVertices, true)}}},
                              {"mode", kLineStrip},
                              {"material", material}}})}});
      document["scenes"][0]["nodes"].push_back(push(document, "nodes", {{"name", name}, {"mesh", mesh}}));
    }
  }

  // From where `pabd render` looks at the start.
  void add_camera(OrderedJson& document) const {
    const Eigen::Matrix4d to_world = view_matrix(camera_).cast<double>().inverse();
    const Vec4f turn = continued(to_world.topLeftCorner<3, 3>(), Quat(0, 0, 0, 0)).coeffs().cast<float>();
    const double distance = static_cast<double>((camera_.eye - camera_.target).norm());
    const int camera = push(document, "cameras",
                            {{"type", "perspective"},
                             {"perspective",
                              {{"yfov", static_cast<double>(camera_.fov) * kPi / 180},
                               {"aspectRatio", 16.0 / 9},
                               {"znear", 0.01 * distance},
                               {"zfar", 100 * distance}}}});
    const int node = push(document, "nodes",
                          {{"name", "camera"},
                           {"camera", camera},
                           {"translation", numbers(camera_.eye)},
                           {"rotation", numbers(turn)}});
    document["scenes"][0]["nodes"].push_back(node);
  }

  void add_animation(OrderedJson& document, Buffer& buffer) const {
    if (motion_.keys() < 2) return;
    OrderedJson samplers = OrderedJson::array(), channels = OrderedJson::array();
    int times = -1;
    const auto add = [&](std::size_t node, const char* path, std::span<const float> values, int width) {
      if (times < 0) times = buffer.add(motion_.times(), 1, kNoTarget, true);
      channels.push_back({{"sampler", samplers.size()}, {"target", {{"node", node}, {"path", path}}}});
      samplers.push_back({{"input", times},
                          {"interpolation", "LINEAR"},
                          {"output", buffer.add(values, width, kNoTarget, false)}});
    };
    std::vector<float> values;
    for (std::size_t i = 0; i < bodies_.bodies.size(); ++i) {  // nodes have the numbers of their bodies
      if (motion_.moves(i)) {
        values.clear();
        for (std::size_t k = 0; k < motion_.keys(); ++k) {
          const Vec3f p = motion_.position(i, k);
          values.insert(values.end(), p.data(), p.data() + 3);
        }
        add(i, "translation", values, 3);
      }
      if (motion_.turns(i)) {
        values.clear();
        for (std::size_t k = 0; k < motion_.keys(); ++k) {
          const Vec4f q = motion_.orientation(i, k);
          values.insert(values.end(), q.data(), q.data() + 4);
        }
        add(i, "rotation", values, 4);
      }
    }
    if (!channels.empty())
      document["animations"] = OrderedJson::array({OrderedJson{
          {"name", name_}, {"channels", std::move(channels)}, {"samplers", std::move(samplers)}}});
  }

  void write(OrderedJson& document, const std::string& bytes) {
    if (bytes.empty()) {
      for (const char* list : {"accessors", "bufferViews"}) document.erase(list);
    } else {
      document["buffers"] = OrderedJson::array({OrderedJson{{"byteLength", bytes.size()}}});
    }
    std::string text = document.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
    text.append((4 - text.size() % 4) % 4, ' ');
    const double length = 28.0 + static_cast<double>(text.size()) + static_cast<double>(bytes.size());
    if (length > kMostGlbBytes) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}: {:.1f} GB; a .glb holds 4 GiB at most: take fewer --fps or less --time",
                              out_, length / 1e9));
    }
    std::string head = "glTF";
    const auto word = [&](std::size_t value) { append_bytes(static_cast<std::uint32_t>(value), head); };
    const std::size_t bin = bytes.empty() ? 0 : 8 + bytes.size();
    word(2);
    word(20 + text.size() + bin);
    word(text.size());
    head += "JSON";
    file_.write(head);
    file_.write(text);
    if (bin > 0) {
      head.clear();
      word(bytes.size());
      head.append("BIN\0", 4);
      file_.write(head);
      file_.write(bytes);
    }
    file_.commit();
  }

  AtomicFile file_;
  std::string out_;
  Camera camera_;
};

}  // namespace

std::unique_ptr<Exporter> make_gltf_exporter(const std::string& out, const Scene& scene,
                                             const FrameView& start, const ExportSetup& setup) {
  return std::make_unique<GltfExporter>(out, scene, start, setup);
}

}  // namespace pabd
