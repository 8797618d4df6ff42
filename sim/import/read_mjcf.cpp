// SPDX-License-Identifier: MIT
// MJCF: the subset that scenes can have. Sections are read in the order that their uses need: compiler, defaults,
// assets, bodies, and then what names bodies and joints. What is taken stands in taken.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "sim/base/error.h"
#include "sim/import/geometry.h"
#include "sim/import/mjcf_elements.h"
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

  Robot read() {
    note_attributes(root_, mjcf_rows(), notes_);
    robot_.name = root_.find("model").value_or("");
    robot_.parent_is_filtered_at_world = false;
    const std::vector<XmlElement> sections = children_of(root_);
    for (const XmlElement& each : sections)
      if (each.name() == "compiler") read_compiler(each);
    for (const XmlElement& each : sections)
      if (each.name() == "default") read_defaults(each);
    for (const XmlElement& each : sections)
      if (each.name() == "asset") read_assets(each);
    for (const XmlElement& each : sections)
      if (each.name() == "worldbody") read_world(each);
    for (const XmlElement& each : sections) read_rest(each);
    apply_flags();
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
    if (e.find("coordinate").value_or("local") != "local") e.fail_at("coordinate", "expected local");
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
      } else if (name == "geom") {
        auto geom = mjcf_geom(context_.defaults.of(e, childclass), context_);
        if (!geom) continue;
        if (++geoms_ > kMostGeoms)
          e.fail(fmt::format("more than {} geoms; expected a smaller model", kMostGeoms));
        geom->at = frame * geom->at;
        robot_.links[static_cast<std::size_t>(link)].geoms.push_back(std::move(*geom));
      } else if (name == "joint" || name == "freejoint") {
        read_joint(e, link, frame, childclass);
      } else if (name == "inertial") {
        robot_.links[static_cast<std::size_t>(link)].inertia = moved(mjcf_inertial(e, context_), frame);
      } else {
        note_element(e, mjcf_rows(), notes_);
      }
    }
  }

  void read_body(const XmlElement& e, int parent, const LinkPose& frame, const std::string& above,
                 int depth) {
    note_attributes(e, mjcf_rows(), notes_);
    context_.defaults.require(e, "childclass");
    if (robot_.links.size() == kMostLinks)
      e.fail(fmt::format("more than {} bodies; expected fewer", kMostLinks));
    RobotLink link;
    link.name = e.find("name").value_or("");
    link.place = place_of(e);
    link.parent = parent;
    link.at = frame * mjcf_pose(MjcfElement(e, {}), context_.compiler);
    const int index = static_cast<int>(robot_.links.size());
    if (!link.name.empty() && !bodies_.emplace(link.name, index).second)
      e.fail_at("name", "another body is named " + in_quotes(link.name) + " too");
    robot_.links.push_back(link);
    read_contents(e, index, LinkPose{}, e.find("childclass").value_or(above), depth);
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
      return;
    }
    if (link.joints.size() == kMostJoints)
      e.fail(fmt::format("more than {} joints in a body; expected fewer", kMostJoints));
    joint->anchor = frame * joint->anchor;
    joint->axis = frame.R * joint->axis;
    if (!joint->name.empty() && !joints_.emplace(joint->name, std::pair(index, link.joints.size())).second)
      e.fail_at("name", "another joint is named " + in_quotes(joint->name) + " too");
    link.joints.push_back(std::move(*joint));
  }

  int body(const XmlElement& e, std::string_view attribute) const {
    const std::string name = e.text(attribute);
    if (name == "world") return 0;
    const auto found = bodies_.find(name);
    if (found == bodies_.end()) e.fail_at(attribute, "there is no body " + in_quotes(name));
    return found->second;
  }

  void read_rest(const XmlElement& section) {
    const std::string name = section.name();
    if (name == "option") return read_option(section);
    if (name == "contact" || name == "actuator" || name == "equality") {
      for (const XmlElement& e : children_of(section)) {
        const std::string kind = e.name();
        if (name == "contact" && kind == "exclude") {
          note_attributes(e, mjcf_rows(), notes_);
          robot_.excludes.emplace_back(body(e, "body1"), body(e, "body2"));
        } else if (name == "actuator" && (kind == "position" || kind == "general")) {
          read_servo(context_.defaults.of(e, ""));
        } else if (name == "actuator" && (kind == "motor" || kind == "velocity")) {
          read_motor(context_.defaults.of(e, ""));
        } else if (name == "equality" && (kind == "connect" || kind == "weld")) {
          read_loop(e);
        } else if (name == "equality" && kind == "joint") {
          read_follow(e);
        } else {
          note_element(e, mjcf_rows(), notes_);
        }
      }
      return;
    }
    if (name != "compiler" && name != "default" && name != "asset" && name != "worldbody")
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

  void apply_flags() {
    if (!loops_hold_) robot_.loops.clear();
    for (RobotLink& link : robot_.links) {
      for (RobotJoint& joint : link.joints) {
        if (!loops_hold_) joint.follows.reset();
        if (!limits_hold_) joint.range.reset();
      }
    }
  }

  // A servo at its rest: control 0. <general> is one when its force is k (control − position).
  void read_servo(const MjcfElement& element) {
    const XmlElement& e = element.own();
    if (e.name() == "general") {
      const auto gain = element.with("gainprm").numbers("gainprm", 1, 10);
      const auto bias = element.with("biasprm").numbers("biasprm", 1, 10);
      const bool servo = element.with("biastype").find("biastype").value_or("") == "affine" && gain && bias &&
                         bias->size() > 1 && (*bias)[0] == 0 && (*bias)[1] == -(*gain)[0] && (*gain)[0] > 0;
      if (!servo) return e.note(notes_, "<general>: not taken: only those that hold a position are");
    }
    note_attributes(e, mjcf_rows(), notes_);
    RobotJoint* joint = joint_of(element);
    if (!joint) return;
    joint->target = mjcf_control(element, context_.compiler) - joint->ref;
    e.note(notes_,
           "position actuator: holds its joint at control 0 as stiffly as the joint itself, in place of the "
           "joint's range");
  }

  void read_motor(const MjcfElement& element) {
    note_attributes(element.own(), mjcf_rows(), notes_);
    RobotJoint* joint = joint_of(element);
    if (!joint) return;
    if (joint->action.motor()) return element.own().note(notes_, "second motor of a joint: not taken");
    mjcf_motor(element, context_, joint->action);
  }

  // The joint that an actuator moves; null, with a note, where it is none that can be moved.
  RobotJoint* joint_of(const MjcfElement& element) {
    const XmlElement& e = element.own();
    const XmlElement& source = element.with("joint");
    const auto leave = [&](const char* why) {
      e.note(notes_, why);
      return nullptr;
    };
    if (!source.has("joint")) return leave("actuator without a joint: not taken");
    const std::string name = source.text("joint");
    const auto found = joints_.find(name);
    if (found == joints_.end()) source.fail_at("joint", "there is no joint " + in_quotes(name));
    const auto [link, number] = found->second;
    RobotJoint& joint = robot_.links[static_cast<std::size_t>(link)].joints[number];
    if (joint.kind == RobotJointKind::ball) return leave("actuator of a ball joint: not taken");
    return &joint;
  }

  // joint1 = a polynomial of joint2, each from its pose in the file.
  void read_follow(const XmlElement& e) {
    note_attributes(e, mjcf_rows(), notes_);
    if (!e.boolean("active").value_or(true)) return;
    const auto found = joints_.find(e.text("joint1"));
    if (found == joints_.end()) e.fail_at("joint1", "there is no joint " + in_quotes(e.text("joint1")));
    if (!e.has("joint2")) return e.note(notes_, "equality of one joint: not taken");
    std::vector<double> poly = e.numbers("polycoef", 1, 5).value_or(std::vector<double>{0, 1});
    poly.resize(5, 0);
    if (poly[2] != 0 || poly[3] != 0 || poly[4] != 0)
      return e.note(notes_, "equality of joints by a polynomial above the first order: not taken");
    const auto [link, number] = found->second;
    RobotJoint& joint = robot_.links[static_cast<std::size_t>(link)].joints[number];
    if (joint.follows) return e.note(notes_, "second equality of a joint: not taken");
    joint.follows = RobotFollow{e.text("joint2"), poly[1], poly[0], place_of(e)};
  }

  void read_loop(const XmlElement& e) {
    note_attributes(e, mjcf_rows(), notes_);
    if (!e.has("body1")) return e.note(notes_, fmt::format("<{}> between sites: not taken", e.name()));
    if (!e.boolean("active").value_or(true)) return;
    RobotLoop loop;
    loop.weld = e.name() == "weld";
    loop.place = place_of(e);
    loop.i = body(e, "body1");
    loop.j = e.has("body2") ? body(e, "body2") : 0;
    if (loop.weld) {
      e.note(notes_, "<weld>: holds the two as they stand at the start");
    } else {
      const auto anchor = e.vec3("anchor");
      if (!anchor) e.fail_at("anchor", "missing");
      loop.anchor = *anchor;
    }
    robot_.loops.push_back(loop);
  }

  XmlElement root_;
  XmlFiles& files_;
  ImportNotes& notes_;
  MjcfContext context_;
  Robot robot_;
  bool has_world_ = false, loops_hold_ = true, limits_hold_ = true;
  std::size_t geoms_ = 0;
  std::map<const XmlFile*, int> include_level_;  // 0: the first file
  std::map<std::string, int> bodies_;
  std::map<std::string, std::pair<int, std::size_t>> joints_;
};

}  // namespace

Robot read_mjcf(const XmlElement& root, XmlFiles& files, RobotMeshes& meshes, ImportNotes& notes) {
  return MjcfReader(root, files, meshes, notes).read();
}

}  // namespace pabd
