// SPDX-License-Identifier: MIT
// MJCF: the subset that scenes can have. Sections are read in the order that their uses need: compiler, defaults,
// assets, bodies, and then what names bodies and joints. What is taken stands in taken.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "sim/base/error.h"
#include "sim/import/geometry.h"
#include "sim/import/mjcf_elements.h"
#include "sim/import/mjcf_keyframe.h"
#include "sim/import/mjcf_mechanics.h"
#include "sim/import/readers.h"
#include "sim/import/taken.h"
#include "sim/scene/text.h"

namespace pabd {
namespace {

constexpr int kDeepestInclude = 8, kDeepestBody = 100;
constexpr std::size_t kMostJoints = 6;  // of a body, as in MuJoCo

class MjcfReader {
 public:
  MjcfReader(const XmlElement& root, XmlFiles& files, RobotMeshes& meshes, ImportNotes& notes)
      : root_(root), files_(files), notes_(notes) {
    context_.meshes = &meshes;
    context_.notes = &notes;
    context_.compiler.mesh_folder = root.file().folder;
  }

  Robot read(const std::string& keyframe) {
    note_attributes(root_, mjcf_rows(), notes_);
    robot_.name = root_.find("model").value_or("");
    robot_.has_world = true;
    const std::vector<XmlElement> sections = children_of(root_);
    for (const XmlElement& each : sections)
      if (each.name() == "compiler") read_compiler(each);
    for (const XmlElement& each : sections)
      if (each.name() == "default") read_defaults(each);
    for (const XmlElement& each : sections)
      if (each.name() == "asset") read_assets(each);
    for (const XmlElement& each : sections)
      if (each.name() == "worldbody") read_world(each);
    read_keyframes(sections, keyframe);
    for (const XmlElement& each : sections) read_rest(each);
    apply_flags();
    scale_to_total_mass();
    return std::move(robot_);
  }

 private:
  // Files that it includes stand in place of <include>.
  std::vector<XmlElement> children_of(const XmlElement& element) {
    std::vector<XmlElement> out;
    for (const XmlElement& child : element.children()) {
      if (child.name() != "include") {
        out.push_back(child);
        continue;
      }
      const int level = include_level_[&child.file()] + 1;
      if (level > kDeepestInclude)
        child.fail(
            fmt::format("files include each other too deeply; expected at most {} levels", kDeepestInclude));
      const XmlElement file = included(child);
      include_level_[&file.file()] = level;
      const auto more = children_of(file);
      out.insert(out.end(), more.begin(), more.end());
    }
    return out;
  }

  // A file that cannot be read is a fault of the line that names it.
  XmlElement included(const XmlElement& child) {
    const std::string file = child.text("file");
    try {
      return files_.read(root_.file().folder / file);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::file) throw;
      child.fail_at("file", error.what());
    }
  }

  void read_compiler(const XmlElement& e) {
    note_attributes(e, mjcf_rows(), notes_);
    MjcfCompiler& out = context_.compiler;
    if (const auto angle = e.find("angle")) {
      if (*angle != "degree" && *angle != "radian") e.fail_at("angle", "expected degree or radian");
      out.angle = *angle == "degree" ? kPi / 180 : 1;
    }
    if (const auto order = e.find("eulerseq")) {
      if (order->size() != 3 || order->find_first_not_of("xyzXYZ") != std::string::npos)
        e.fail_at("eulerseq", "expected three of x, y, z, X, Y and Z");
      out.eulerseq = *order;
    }
    const std::string coordinate = e.find("coordinate").value_or("local");
    if (coordinate != "local" && coordinate != "global") e.fail_at("coordinate", "expected local or global");
    out.global = coordinate == "global";
    out.total_mass = e.number("settotalmass").value_or(out.total_mass);
    for (const char* key : {"assetdir", "meshdir"})
      if (const auto folder = e.find(key)) out.mesh_folder = root_.file().folder / *folder;
    out.autolimits = e.boolean("autolimits").value_or(out.autolimits);
    out.strippath = e.boolean("strippath").value_or(out.strippath);
    if (const auto from = e.find("inertiafromgeom")) {
      using Inertia = MjcfCompiler::Inertia;
      if (*from != "true" && *from != "false" && *from != "auto")
        e.fail_at("inertiafromgeom", "expected true, false or auto");
      out.from_geoms = *from == "true"    ? Inertia::always
                       : *from == "false" ? Inertia::never
                                          : Inertia::where_missing;
    }
  }

  void read_defaults(const XmlElement& e) {
    note_attributes(e, mjcf_rows(), notes_);
    const auto contents = [this](const XmlElement& nested) { return children_of(nested); };
    context_.defaults.add(e, "main", "main", contents, notes_);
    if (const auto name = e.find("class"); name && *name != "main")
      context_.defaults.add_class(*name, "main");
  }

  void read_assets(const XmlElement& section) {
    for (const XmlElement& e : children_of(section)) {
      if (e.name() == "mesh" || e.name() == "material") {
        context_.assets.read(context_.defaults.of(e, ""), context_.compiler, notes_);
      } else {
        note_element(e, mjcf_rows(), notes_);
      }
    }
  }

  void read_world(const XmlElement& world) {
    if (!has_world_) {
      RobotLink link;
      link.name = "world";
      link.place = place_of(world);
      robot_.links.push_back(link);
      has_world_ = true;
    }
    read_contents(world, 0, LinkPose{}, world.find("childclass").value_or(""), 0);
  }

  // What stands in a body, or in a frame of it. Files in files make it deeper than one file may be.
  void read_contents(const XmlElement& element, int link, const LinkPose& frame,
                     const std::string& childclass, int depth) {
    if (depth > kDeepestBody)
      element.fail(fmt::format("nested too deeply; expected at most {} levels", kDeepestBody));
    for (const XmlElement& e : children_of(element)) {
      const std::string name = e.name();
      if (name == "body") {
        read_body(e, link, frame, childclass, depth + 1);
      } else if (name == "frame") {
        note_attributes(e, mjcf_rows(), notes_);
        context_.defaults.require(e, "childclass");
        read_contents(e, link, frame * mjcf_pose(MjcfElement(e, {}), context_.compiler),
                      e.find("childclass").value_or(childclass), depth + 1);
      } else if (name == "replicate") {
        replicate(e, link, frame, childclass, depth);
      } else if (name == "geom") {
        auto geom = mjcf_geom(context_.defaults.of(e, childclass), context_);
        if (!geom) continue;
        if (++geoms_ > kMostGeoms)
          e.fail(fmt::format("more than {} geoms; expected a smaller model", kMostGeoms));
        geom->at = frame_of(e, frame) * geom->at;
        robot_.links[static_cast<std::size_t>(link)].geoms.push_back(std::move(*geom));
      } else if (name == "joint" || name == "freejoint") {
        read_joint(e, link, frame, childclass);
      } else if (name == "inertial") {
        robot_.links[static_cast<std::size_t>(link)].inertia =
            moved(mjcf_inertial(e, context_), frame_of(e, frame));
      } else {
        note_element(e, mjcf_rows(), notes_);
      }
    }
  }

  static LinkPose inverse(const LinkPose& pose) {
    return {pose.R.transpose(), -(pose.R.transpose() * pose.t)};
  }

  // What tells no place of its own among global ones stands where its body does.
  LinkPose frame_of(const XmlElement& e, const LinkPose& frame) const {
    const bool told = e.has("pos") || e.has("fromto");
    return context_.compiler.global && !told ? LinkPose{} : frame;
  }

  // Copies, each moved and turned from the one before.
  void replicate(const XmlElement& e, int link, LinkPose frame, const std::string& childclass, int depth) {
    note_attributes(e, mjcf_rows(), notes_);
    const double count = e.number("count").value_or(0);
    if (!(count >= 1 && count <= static_cast<double>(kMostGeoms)) || count != std::floor(count))
      e.fail_at("count", fmt::format("expected a whole number from 1 to {}", kMostGeoms));
    copies_ += count;
    if (copies_ > static_cast<double>(kMostGeoms))
      e.fail(fmt::format("more than {} copies; expected fewer", kMostGeoms));
    const LinkPose step{mjcf_rotation(e, context_.compiler), e.vec3("offset").value_or(Vec3::Zero())};
    const std::string suffix = suffix_, sep = e.find("sep").value_or("");
    const std::size_t digits = fmt::format("{}", count - 1).size();
    for (int k = 0; k < static_cast<int>(count); ++k) {
      suffix_ = suffix + fmt::format("{}{:0{}}", sep, k, digits);
      read_contents(e, link, frame, childclass, depth + 1);
      frame = frame * step;
    }
    suffix_ = suffix;
  }

  std::string named(const XmlElement& e) const {
    const std::string name = e.find("name").value_or("");
    return name.empty() ? name : name + suffix_;
  }

  void read_body(const XmlElement& e, int parent, const LinkPose& frame, const std::string& above,
                 int depth) {
    note_attributes(e, mjcf_rows(), notes_);
    context_.defaults.require(e, "childclass");
    if (robot_.links.size() == kMostLinks)
      e.fail(fmt::format("more than {} bodies; expected fewer", kMostLinks));
    RobotLink link;
    link.name = named(e);
    link.place = place_of(e);
    link.parent = parent;
    link.lifted = e.number("gravcomp").value_or(0);
    const LinkPose told = mjcf_pose(MjcfElement(e, {}), context_.compiler);
    link.at = frame * told;
    const int index = static_cast<int>(robot_.links.size());
    if (!link.name.empty() && !names_.bodies.emplace(link.name, index).second)
      e.fail_at("name", "another body is named " + in_quotes(link.name) + " too");
    robot_.links.push_back(link);
    read_contents(e, index, context_.compiler.global ? inverse(told) : LinkPose{},
                  e.find("childclass").value_or(above), depth);
    RobotLink& read = robot_.links[static_cast<std::size_t>(index)];
    if (read.free && !read.joints.empty()) e.fail("a free joint beside others; expected it alone");
    weigh(read);
  }

  // Mass from geoms where the body does not say its own, or is told not to.
  void weigh(RobotLink& link) {
    using Inertia = MjcfCompiler::Inertia;
    const Inertia from = context_.compiler.from_geoms;
    if (from == Inertia::always) link.inertia.reset();
    const bool count = !link.inertia && from != Inertia::never;
    if (count) return;
    for (RobotGeom& geom : link.geoms) {
      geom.mass.reset();
      geom.density = 0;
    }
  }

  void read_joint(const XmlElement& e, int index, const LinkPose& frame, const std::string& childclass) {
    RobotLink& link = robot_.links[static_cast<std::size_t>(index)];
    if (index == 0) e.fail("the world has no joints");
    std::optional<RobotJoint> joint;
    if (e.name() == "joint")
      joint = mjcf_joint(context_.defaults.of(e, childclass), context_);
    else
      note_attributes(e, mjcf_rows(), notes_);
    if (!joint) {
      if (link.parent != 0) e.fail("a free joint in a body of another; expected it in a body of the world");
      link.free = true;
      names_.free_joints.insert(named(e));
      return;
    }
    if (link.joints.size() == kMostJoints)
      e.fail(fmt::format("more than {} joints in a body; expected fewer", kMostJoints));
    joint->name = named(e);
    joint->anchor = frame_of(e, frame) * joint->anchor;
    joint->axis = frame.R * joint->axis;
    if (!joint->name.empty() &&
        !names_.joints.emplace(joint->name, std::pair(index, link.joints.size())).second)
      e.fail_at("name", "another joint is named " + in_quotes(joint->name) + " too");
    link.joints.push_back(std::move(*joint));
  }

  void read_keyframes(const std::vector<XmlElement>& sections, const std::string& name) {
    std::vector<XmlElement> keys;
    for (const XmlElement& section : sections)
      if (section.name() == "keyframe")
        for (const XmlElement& key : children_of(section)) keys.push_back(key);
    if (!name.empty()) {
      const XmlElement key = find_key(keys, root_, name);
      start_at_key(key, robot_, notes_);
      controls_ = key.numbers("ctrl", 1, kMostLinks).value_or(controls_);
    } else {
      for (const XmlElement& key : keys)
        key.note(notes_, "a keyframe: the start is the pose of the bodies; --keyframe NAME starts there");
    }
  }

  void next_control() {
    context_.control = actuators_ < controls_.size() ? std::optional(controls_[actuators_]) : std::nullopt;
    ++actuators_;
  }

  void read_rest(const XmlElement& section) {
    const std::string name = section.name();
    if (name == "option") return read_option(section);
    if (name == "contact" || name == "actuator" || name == "equality") {
      MjcfMechanics mechanics(context_, names_, robot_);
      for (const XmlElement& e : children_of(section)) {
        if (name == "actuator") next_control();
        mechanics.read(name, e);
      }
      return;
    }
    if (name != "compiler" && name != "default" && name != "asset" && name != "worldbody" &&
        name != "keyframe")
      note_element(section, mjcf_rows(), notes_);
  }

  void read_option(const XmlElement& e) {
    note_attributes(e, mjcf_rows(), notes_);
    if (const auto g = e.vec3("gravity")) robot_.gravity = *g;
    if (const auto h = e.number("timestep")) {
      if (!(*h >= 1e-6 && *h <= 1)) e.fail_at("timestep", "expected 1e-06 to 1 (s)");
      robot_.time_step = *h;
    }
    for (const XmlElement& child : e.children()) {
      if (child.name() == "flag") {
        read_flags(child);
      } else {
        note_element(child, mjcf_rows(), notes_);
      }
    }
  }

  // What MuJoCo is told not to compute.
  void read_flags(const XmlElement& e) {
    note_attributes(e, mjcf_rows(), notes_);
    const auto off = [&](std::string_view flag) { return e.find(flag).value_or("") == "disable"; };
    if (off("gravity")) robot_.gravity.setZero();
    if (off("contact") || off("constraint")) robot_.contacts = false;
    if (off("equality") || off("constraint")) loops_hold_ = false;
    if (off("limit") || off("constraint")) limits_hold_ = false;
  }

  // All bodies but the world weigh so much together.
  void scale_to_total_mass() {
    if (!(context_.compiler.total_mass > 0)) return;
    double mass = 0;
    for (std::size_t l = 1; l < robot_.links.size(); ++l) {
      RobotLink& link = robot_.links[l];
      if (!link.inertia) {
        link.inertia.emplace();
        for (const RobotGeom& geom : link.geoms) link.inertia = together(*link.inertia, inertia_of(geom));
      }
      mass += link.inertia->mass;
    }
    for (RobotLink& link : robot_.links) {
      if (!link.inertia || !(mass > 0)) continue;
      link.inertia->mass *= context_.compiler.total_mass / mass;
      link.inertia->I *= context_.compiler.total_mass / mass;
    }
  }

  void apply_flags() {
    if (!loops_hold_) robot_.loops.clear();
    for (RobotLink& link : robot_.links) {
      for (RobotJoint& joint : link.joints) {
        if (!loops_hold_) joint.follows.reset();
        if (!limits_hold_) joint.range.reset();
      }
    }
  }

  XmlElement root_;
  XmlFiles& files_;
  ImportNotes& notes_;
  MjcfContext context_;
  Robot robot_;
  bool has_world_ = false, loops_hold_ = true, limits_hold_ = true;
  std::size_t geoms_ = 0, actuators_ = 0;
  std::vector<double> controls_;  // of the keyframe
  double copies_ = 0;
  std::string suffix_;                           // of names in a copy
  std::map<const XmlFile*, int> include_level_;  // 0: the first file
  MjcfNames names_;
};

}  // namespace

Robot read_mjcf(const XmlElement& root, XmlFiles& files, RobotMeshes& meshes, ImportNotes& notes,
                const ImportOptions& options) {
  return MjcfReader(root, files, meshes, notes).read(options.keyframe);
}

}  // namespace pabd
