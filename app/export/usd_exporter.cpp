// SPDX-License-Identifier: MIT
// OpenUSD as text (.usda): https://openusd.org/release/spec.html. Metres, y up, colours linear, as in pabd.
//
//   /World/Shapes/shape_K      a class: the mesh of bodies alike
//   /World/Materials/color_K   UsdPreviewSurface
//   /World/Bodies/NAME         an Xform with the samples of its body, and in it the mesh
//   /World/Trails/NAME         a linear BasisCurves
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "app/export/body_mesh.h"
#include "app/export/exporter.h"
#include "app/export/motion.h"
#include "app/frames/scene_framing.h"
#include "render/visual/body_marks.h"
#include "sim/base/atomic_file.h"
#include "sim/base/utf8.h"

namespace pabd {
namespace {

constexpr const char* kBinds = "prepend apiSchemas = [\"MaterialBindingAPI\"]";

// Text of inputs between quotes.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : one_line(text)) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

// Names of prims are ASCII words, and no two in one place are alike.
class PrimNames {
 public:
  std::string unique(const std::string& name) {
    std::string word;
    for (const char c : name) {
      const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
      const bool digit = c >= '0' && c <= '9';
      if (word.empty() && !letter) word = "_";
      if (letter || digit) {
        word += c;
      } else if (word.back() != '_') {
        word += '_';
      }
    }
    if (word.empty()) word = "_";
    std::string out = word;
    for (int k = 2; !used_.insert(out).second; ++k) out = fmt::format("{}_{}", word, k);
    return out;
  }

 private:
  std::set<std::string> used_;
};

// All text of the file, and how deep it is set in.
class Writer {
 public:
  explicit Writer(const std::string& path) : file_(path) {}

  template <class... T>
  void line(fmt::format_string<T...> format, T&&... values) {
    buffer_.append(2 * static_cast<std::size_t>(depth_), ' ');
    fmt::format_to(std::back_inserter(buffer_), format, std::forward<T>(values)...);
    end_line();
  }
  // `head` and on the next lines what is in it, up to close().
  template <class... T>
  void open(fmt::format_string<T...> head, T&&... values) {
    line(head, std::forward<T>(values)...);
    line("{{");
    ++depth_;
  }
  // A value in braces, which begin on the line of its name.
  template <class... T>
  void open_map(fmt::format_string<T...> name, T&&... values) {
    line("{} = {{", fmt::format(name, std::forward<T>(values)...));
    ++depth_;
  }
  // As open(), with metadata of the prim, a line each.
  void open_with(const std::string& head, const std::vector<std::string>& metadata) {
    line("{} (", head);
    for (const std::string& each : metadata) line("  {}", each);
    line(")");
    line("{{");
    ++depth_;
  }
  void close() {
    --depth_;
    line("}}");
  }

  // `about`: metadata of the attribute, in brackets.
  void points(const char* name, const std::vector<Vec3f>& list, std::string_view about = "") {
    buffer_.append(2 * static_cast<std::size_t>(depth_), ' ');
    buffer_ += name;
    buffer_ += " = [";
    for (std::size_t k = 0; k < list.size(); ++k) {
      const Vec3f& p = list[k];
      fmt::format_to(std::back_inserter(buffer_), "{}({}, {}, {})", k > 0 ? ", " : "", p.x(), p.y(), p.z());
    }
    buffer_ += ']';
    buffer_ += about;
    end_line();
  }
  void integers(const char* name, const std::vector<std::uint32_t>& list) {
    line("{} = [{}]", name, fmt::join(list, ", "));
  }

  void commit() {
    file_.write(buffer_);
    file_.commit();
  }

 private:
  void end_line() {
    buffer_ += '\n';
    if (buffer_.size() < (std::size_t{1} << 20)) return;
    file_.write(buffer_);
    buffer_.clear();
  }

  AtomicFile file_;
  std::string buffer_;
  int depth_ = 0;
};

class UsdExporter : public AnimationExporter {
 public:
  UsdExporter(const std::string& out, const Scene& scene, const FrameView& start, const ExportSetup& setup)
      : AnimationExporter(scene, start, setup), out_(out), fps_(setup.fps) {
    for (const MeshedBody& body : bodies_.bodies) names_.push_back(prims_.unique(body.name));
  }

  void finish() override {
    out_.line("#usda 1.0");
    out_.line("(");
    out_.line("  defaultPrim = \"World\"");
    out_.line("  doc = {}", quoted("pabd " PABD_VERSION ", scene " + name_ + ", hash " + hash_));
    out_.line("  metersPerUnit = 1");
    out_.line("  upAxis = \"Y\"");
    out_.line("  startTimeCode = 0");
    out_.line("  endTimeCode = {}", motion_.keys() > 0 ? code(motion_.keys() - 1) : 0);
    out_.line("  timeCodesPerSecond = {}", fps_);
    out_.line("  framesPerSecond = {}", fps_);
    out_.line(")");
    out_.line("");
    out_.open("def Xform \"World\"");
    write_materials();
    write_shapes();
    out_.open("def Scope \"Bodies\"");
    for (std::size_t i = 0; i < bodies_.bodies.size(); ++i) write_body(i);
    out_.close();
    write_trails();
    out_.close();
    out_.commit();
  }

 private:
  // Codes count frames, in which samples of a state lie where it is.
  double code(std::size_t key) const {
    const double code = static_cast<double>(motion_.times()[key]) * fps_;
    // Times are float: what is meant to be a whole frame is one.
    return std::abs(code - std::round(code)) < 1e-6 + 2e-7 * code ? std::round(code) : code;
  }

  void write_material(const std::string& name, const Vec4f& color, double roughness) {
    out_.open("def Material \"{}\"", name);
    out_.line("token outputs:surface.connect = </World/Materials/{}/surface.outputs:surface>", name);
    out_.open("def Shader \"surface\"");
    out_.line("uniform token info:id = \"UsdPreviewSurface\"");
    out_.line("color3f inputs:diffuseColor = ({}, {}, {})", color.x(), color.y(), color.z());
    out_.line("float inputs:metallic = 0");
    out_.line("float inputs:opacity = {}", color.w());
    out_.line("float inputs:roughness = {}", roughness);
    out_.line("token outputs:surface");
    out_.close();
    out_.close();
  }

  void write_materials() {
    out_.open("def Scope \"Materials\"");
    for (std::size_t k = 0; k < bodies_.materials.size(); ++k)
      write_material(fmt::format("color_{}", k), bodies_.materials[k], kBodyRoughness);
    const float* c = kStudioTheme.floor;
    write_material("floor", {c[0], c[1], c[2], 1}, 1);
    for (std::size_t k = 0; k < motion_.trails().size(); ++k)
      write_material(fmt::format("trail_{}", k), trail_color(k), 1);
    out_.close();
  }

  void write_mesh(const BodyMesh& mesh) {
    std::vector<std::uint32_t> corners = mesh.light;
    corners.insert(corners.end(), mesh.dark.begin(), mesh.dark.end());
    out_.integers("int[] faceVertexCounts", std::vector<std::uint32_t>(corners.size() / 3, 3));
    out_.integers("int[] faceVertexIndices", corners);
    out_.points("point3f[] points", mesh.positions);
    out_.points("normal3f[] primvars:normals", mesh.normals, " (interpolation = \"vertex\")");
    out_.line("uniform token subdivisionScheme = \"none\"");
    Vec3f lo = mesh.positions.front(), hi = lo;
    for (const Vec3f& p : mesh.positions) {
      lo = lo.cwiseMin(p);
      hi = hi.cwiseMax(p);
    }
    out_.points("float3[] extent", {lo, hi});
  }

  void write_shapes() {
    out_.open("def Scope \"Shapes\"");
    for (std::size_t k = 0; k < bodies_.meshes.size(); ++k) {
      out_.open("class Mesh \"shape_{}\"", k);
      write_mesh(bodies_.meshes[k]);
      out_.close();
    }
    out_.close();
  }

  void bind(const std::string& material) {
    out_.line("rel material:binding = </World/Materials/{}>", material);
  }
  static Vec3f color_of(const Vec4f& color) { return color.head<3>(); }

  // A subset of faces has the other colour of a checker.
  void write_dark_fields(const BodyMesh& mesh, int material) {
    out_.open_with("def GeomSubset \"dark\"", {kBinds});
    out_.line("uniform token elementType = \"face\"");
    out_.line("uniform token familyName = \"materialBind\"");
    std::vector<std::uint32_t> faces;
    for (std::size_t k = 0; k < mesh.dark.size() / 3; ++k)
      faces.push_back(static_cast<std::uint32_t>(mesh.light.size() / 3 + k));
    out_.integers("int[] indices", faces);
    bind(fmt::format("color_{}", material));
    out_.close();
  }

  void write_body(std::size_t i) {
    const MeshedBody& body = bodies_.bodies[i];
    out_.open_with(fmt::format("def Xform \"{}\"", names_[i]),
                   {"customData = {", "  string name = " + quoted(body.name), "}"});
    if (body.mesh == kNoMesh) {
      out_.open_with("def Mesh \"surface\"", {kBinds});
      write_mesh(plane_mesh(std::get<Plane>(model_->shape[i]), motion_.middle(), motion_.reach()));
      const float* c = kStudioTheme.floor;
      out_.points("color3f[] primvars:displayColor", {Vec3f(c[0], c[1], c[2])});
      out_.line("uniform bool doubleSided = true");
      bind("floor");
      out_.close();
      return out_.close();
    }
    const auto position = [&](std::size_t k) {
      const Vec3f p = motion_.position(i, k);
      return fmt::format("({}, {}, {})", p.x(), p.y(), p.z());
    };
    const auto orientation = [&](std::size_t k) {
      const Vec4f q = motion_.orientation(i, k);
      return fmt::format("({}, {}, {}, {})", q.w(), q.x(), q.y(), q.z());
    };
    write_samples("quatf xformOp:orient", motion_.turns(i), orientation);
    write_samples("double3 xformOp:translate", motion_.moves(i), position);
    out_.line("uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:orient\"]");
    out_.open_with("def Mesh \"surface\"",
                   {fmt::format("inherits = </World/Shapes/shape_{}>", body.mesh), kBinds});
    const Vec4f& color = bodies_.materials[static_cast<std::size_t>(body.material)];
    out_.points("color3f[] primvars:displayColor", {color_of(color)});
    if (color.w() < 1) out_.line("float[] primvars:displayOpacity = [{}]", color.w());
    bind(fmt::format("color_{}", body.material));
    const BodyMesh& mesh = bodies_.meshes[static_cast<std::size_t>(body.mesh)];
    if (!mesh.dark.empty()) write_dark_fields(mesh, body.dark_material);
    out_.close();
    out_.close();
  }

  template <class Value>
  void write_samples(const char* attribute, bool changes, const Value& value) {
    if (!changes) return out_.line("{} = {}", attribute, value(0));
    out_.open_map("{}.timeSamples", attribute);
    for (std::size_t k = 0; k < motion_.keys(); ++k) out_.line("{}: {},", code(k), value(k));
    out_.close();
  }

  void write_trails() {
    if (motion_.trails().empty()) return;
    out_.open("def Scope \"Trails\"");
    PrimNames names;
    for (std::size_t k = 0; k < motion_.trails().size(); ++k) {
      const std::vector<Vec3f>& path = motion_.trails()[k];
      if (path.size() < 2) continue;
      const std::string name = names.unique("trail_of_" + trail_words(motion_.trail_points()[k]));
      out_.open_with(fmt::format("def BasisCurves \"{}\"", name), {kBinds});
      out_.line("uniform token type = \"linear\"");
      out_.line("int[] curveVertexCounts = [{}]", path.size());
      out_.points("point3f[] points", path);
      out_.line("float[] widths = [0.01] (interpolation = \"constant\")");
      out_.points("color3f[] primvars:displayColor", {color_of(trail_color(k))});
      bind(fmt::format("trail_{}", k));
      out_.close();
    }
    out_.close();
  }

  Writer out_;
  double fps_;
  PrimNames prims_;
  std::vector<std::string> names_;
};

}  // namespace

std::unique_ptr<Exporter> make_usd_exporter(const std::string& out, const Scene& scene,
                                            const FrameView& start, const ExportSetup& setup) {
  return std::make_unique<UsdExporter>(out, scene, start, setup);
}

}  // namespace pabd
