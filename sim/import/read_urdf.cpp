// SPDX-License-Identifier: MIT
// URDF as urdfdom and the ROS documentation describe it: links, joints and their frames; roll, pitch and yaw are about
// fixed axes. What is taken stands in taken.cpp.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>

#include "sim/import/geometry.h"
#include "sim/import/readers.h"
#include "sim/import/taken.h"
#include "sim/math/so3.h"
#include "sim/scene/text.h"
#include "sim/solver/params.h"

namespace pabd {
namespace {

// In names of what has a robot stand or roll on the ground.
constexpr std::string_view kMobile[] = {"wheel", "caster", "castor", "foot", "feet", "floating"};
constexpr std::string_view kShapes[] = {"box", "sphere", "cylinder", "capsule", "mesh"};

class UrdfReader {
 public:
  UrdfReader(const XmlElement& root, RobotMeshes& meshes, ImportNotes& notes)
      : root_(root), meshes_(meshes), notes_(notes) {}

  Robot read(RobotBase base) {
    note_attributes(root_, urdf_rows(), notes_);
    robot_.name = root_.find("name").value_or("");
    for (const XmlElement& e : root_.children()) read_top(e);
    for (const auto& [name, e] : links_) read_link(name, e);
    order_and_place(base);
    return std::move(robot_);
  }

 private:
  struct Edge {
    XmlElement element;
    std::string parent;
  };

  void read_top(const XmlElement& e) {
    const std::string name = e.name();
    if (name == "link") {
      const std::string link = e.text("name");
      if (links_.size() == kMostLinks) e.fail(fmt::format("more than {} links; expected fewer", kMostLinks));
      if (!known_.emplace(link, links_.size()).second)
        e.fail_at("name", "another link is named " + in_quotes(link) + " too");
      links_.emplace_back(link, e);
    } else if (name == "joint") {
      const std::string child = end(e, "child");
      if (!edges_.emplace(child, Edge{e, end(e, "parent")}).second)
        e.fail(fmt::format("the link {} has two parents; expected a tree", in_quotes(child)));
      if (!joint_names_.insert(e.text("name")).second)
        e.fail_at("name", "another joint is named " + in_quotes(e.text("name")) + " too");
    } else if (name == "material") {
      if (const auto color = read_color(e)) colors_.insert_or_assign(e.text("name"), *color);
    } else {
      note_element(e, urdf_rows(), notes_);
    }
  }

  std::string end(const XmlElement& joint, std::string_view which) {
    const auto e = joint.child(which);
    if (!e) joint.fail(fmt::format("without <{}>; expected one", which));
    return e->text("link");
  }

  void known_children(const XmlElement& e, std::initializer_list<std::string_view> known) {
    note_attributes(e, urdf_rows(), notes_);
    for (const XmlElement& child : e.children()) {
      if (std::find(known.begin(), known.end(), child.name()) == known.end()) {
        note_element(child, urdf_rows(), notes_);
      } else {
        note_attributes(child, urdf_rows(), notes_);
      }
    }
  }

  LinkPose pose_in(const XmlElement& e) const {
    const auto origin = e.child("origin");
    if (!origin) return {};
    const Vec3 rpy = origin->vec3("rpy").value_or(Vec3::Zero());
    const Eigen::AngleAxisd roll(rpy.x(), Vec3::UnitX()), pitch(rpy.y(), Vec3::UnitY()),
        yaw(rpy.z(), Vec3::UnitZ());
    return {(yaw * pitch * roll).toRotationMatrix(), origin->vec3("xyz").value_or(Vec3::Zero())};
  }

  std::optional<Vec3> read_color(const XmlElement& material) const {
    if (const auto color = material.child("color")) {
      const auto rgba = color->numbers("rgba", 4, 4);
      if (rgba) return Vec3((*rgba)[0], (*rgba)[1], (*rgba)[2]).cwiseMax(0).cwiseMin(1);
    }
    const auto found = colors_.find(material.find("name").value_or(""));
    if (found == colors_.end()) return {};
    return found->second;
  }

  double number(const XmlElement& e, std::string_view attribute) const {
    const auto value = e.number(attribute);
    if (!value) e.fail_at(attribute, "missing; expected a number");
    return *value;
  }

  void read_link(const std::string& name, const XmlElement& e) {
    known_children(e, {"inertial", "visual", "collision", "contact"});
    RobotLink link;
    link.name = name;
    link.place = place_of(e);
    std::optional<Vec3> color;
    std::optional<SurfaceFriction> friction;
    for (const XmlElement& child : e.children()) {
      const bool visual = child.name() == "visual";
      if (child.name() == "contact") {
        friction = read_friction(child);
      } else if (child.name() == "inertial") {
        if (link.inertia) child.fail("a link has one <inertial>; this is the second");
        link.inertia = read_inertial(child);
      } else if (visual || child.name() == "collision") {
        auto geom = read_geom(child, visual);
        if (!geom) continue;
        if (visual && !color) color = geom->color;
        if (++geoms_ > kMostGeoms)
          child.fail(fmt::format("more than {} geometries; expected fewer", kMostGeoms));
        link.geoms.push_back(std::move(*geom));
      }
    }
    for (RobotGeom& geom : link.geoms) {
      if (!geom.color) geom.color = color;
      geom.friction = friction;
    }
    robot_.links.push_back(std::move(link));
  }

  // As the Bullet engine reads it. Empty where it says nothing of friction.
  std::optional<SurfaceFriction> read_friction(const XmlElement& e) {
    known_children(e, {"lateral_friction", "rolling_friction", "spinning_friction"});
    const auto of = [&](const char* name) -> std::optional<double> {
      const auto child = e.child(name);
      if (!child) return {};
      const double value = number(*child, "value");
      if (value < 0) child->fail_at("value", "is negative");
      return value;
    };
    const auto lateral = of("lateral_friction"), rolling = of("rolling_friction"),
               spinning = of("spinning_friction");
    if (!lateral && !rolling && !spinning) return {};
    const double slip = lateral.value_or(ContactParams{}.mu_static);
    return SurfaceFriction{slip, slip, spinning.value_or(0), rolling.value_or(0)};
  }

  RobotInertia read_inertial(const XmlElement& e) {
    known_children(e, {"origin", "mass", "inertia"});
    RobotInertia out;
    const auto mass = e.child("mass");
    if (!mass) e.fail("without <mass>; expected one");
    out.mass = number(*mass, "value");
    if (out.mass < 0) mass->fail_at("value", "is negative");
    if (const auto i = e.child("inertia")) {
      const auto of = [&](std::string_view key) { return i->number(key).value_or(0); };
      // Read before the matrix is filled: what fails must not leave it half full.
      const double xx = number(*i, "ixx"), yy = number(*i, "iyy"), zz = number(*i, "izz");
      const double xy = of("ixy"), xz = of("ixz"), yz = of("iyz");
      out.I << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    }
    return moved(out, pose_in(e));
  }

  std::optional<RobotGeom> read_geom(const XmlElement& e, bool visual) {
    known_children(e, {"origin", "geometry", "material"});
    const auto geometry = e.child("geometry");
    if (!geometry) e.fail("without <geometry>; expected one");
    RobotGeom geom;
    geom.visual = visual;
    geom.place = place_of(e);
    geom.at = pose_in(e);
    if (const auto material = e.child("material")) geom.color = read_color(*material);
    const auto shape = shape_of(*geometry);
    if (!shape || !read_shape(*shape, geom)) return {};
    return geom;
  }

  // What is no shape stands at the wrong place.
  std::optional<XmlElement> shape_of(const XmlElement& geometry) {
    std::optional<XmlElement> out;
    for (const XmlElement& e : geometry.children()) {
      const bool shape = std::find(std::begin(kShapes), std::end(kShapes), e.name()) != std::end(kShapes);
      if (shape && !out)
        out = e;
      else
        e.note(notes_, fmt::format("<{}> in <geometry>: left out", printable(e.name())));
    }
    if (!out) geometry.note(notes_, "<geometry> without a shape: left out");
    return out;
  }

  // False, with a note, for what is left out.
  bool read_shape(const XmlElement& shape, RobotGeom& geom) {
    note_attributes(shape, urdf_rows(), notes_);
    const std::string kind = shape.name();
    if (kind == "mesh") return read_mesh(shape, geom);
    if (kind == "box") {
      const auto edges = shape.vec3("size");
      if (!edges) shape.fail_at("size", "missing; expected three numbers");
      geom.kind = GeomKind::box;
      geom.size = *edges / 2;
    } else if (kind == "sphere") {
      geom.kind = GeomKind::sphere;
      geom.size = Vec3::Constant(number(shape, "radius"));
    } else {
      geom.kind = kind == "cylinder" ? GeomKind::cylinder : GeomKind::capsule;
      const double half = number(shape, "length") / 2;
      geom.size = Vec3(number(shape, "radius"), half, half);
    }
    const bool sized = geom.size.minCoeff() >= kLeastSize / 2 && geom.size.maxCoeff() <= kMostSize;
    if (!sized) shape.note(notes_, kNoSize);
    return sized;
  }

  bool read_mesh(const XmlElement& shape, RobotGeom& geom) {
    std::vector<double> scale = shape.numbers("scale", 1, 9).value_or(std::vector<double>{1});
    if (shape.has("scale") && scale.size() != 3)
      shape.note(notes_, "scale of a mesh that is not three numbers: the first count");
    scale.resize(3, scale.front());
    std::string problem;
    const auto file = meshes_.find(shape.text("filename"), shape.file().folder, problem);
    if (!problem.empty()) {
      shape.note(notes_, "mesh left out: " + problem);
      return false;
    }
    return meshes_.put(file, Vec3(scale[0], scale[1], scale[2]), shape, geom, notes_);
  }

  // Joints of a moving one; `link` gets them. Fixed ones get none.
  void read_joint(const XmlElement& e, RobotLink& link) {
    known_children(e, {"parent", "child", "origin", "axis", "limit", "dynamics", "mimic"});
    link.at = pose_in(e);
    const std::string type = e.text("type");
    if (type == "fixed") return;
    RobotJoint joint;
    joint.name = e.text("name");
    joint.place = place_of(e);
    Vec3 axis = Vec3::UnitX();
    if (const auto a = e.child("axis")) {
      axis = a->vec3("xyz").value_or(axis);
      if (!(axis.norm() > 1e-9)) a->fail_at("xyz", "its length is 0; expected a direction");
    }
    joint.axis = axis.normalized();
    const auto dynamics = e.child("dynamics");
    if (type == "revolute" || type == "prismatic") {
      joint.kind = type == "revolute" ? RobotJointKind::hinge : RobotJointKind::slide;
      joint.range = range_of(e);
    } else if (type == "floating") {
      joint.kind = RobotJointKind::ball;  // of the place it is told, too: three offsets before it
      for (int k = 0; k < 3; ++k)
        link.joints.push_back(along(joint, RobotJointKind::slide, Vec3::Unit(k), k));
    } else if (type == "planar") {
      const Mat3 F = rotation_between(Vec3::UnitX(), joint.axis);
      link.joints.push_back(along(joint, RobotJointKind::slide, F.col(1), 0));
      link.joints.push_back(along(joint, RobotJointKind::slide, F.col(2), 1));
    } else if (type != "continuous") {
      e.fail_at("type", "expected revolute, continuous, prismatic, fixed, floating or planar, got " +
                            in_quotes(type));
    }
    if (dynamics && (type == "planar" || type == "floating")) {
      dynamics->note(notes_, fmt::format("<dynamics> of a {} joint: not taken", type));
    } else if (dynamics) {
      joint.action.damping = dynamics->resistance("damping");
      joint.action.friction = dynamics->resistance("friction");
    }
    if (const auto mimic = e.child("mimic"))
      joint.follows = RobotFollow{mimic->text("joint"), mimic->number("multiplier").value_or(1),
                                  mimic->number("offset").value_or(0), place_of(*mimic)};
    link.joints.push_back(std::move(joint));
  }

  std::optional<std::pair<double, double>> range_of(const XmlElement& joint) {
    const auto limit = joint.child("limit");
    if (!limit) {
      joint.note(notes_, "revolute or prismatic joint without <limit>: not limited");
      return {};
    }
    const std::pair out(limit->bound("lower"), limit->bound("upper"));
    if (out.first <= out.second) return out;
    limit->note(notes_, kReversed);
    return {};
  }

  static RobotJoint along(const RobotJoint& whole, RobotJointKind kind, const Vec3& axis, int number) {
    RobotJoint out = whole;
    out.kind = kind;
    out.axis = axis;
    out.name += fmt::format(" {}", "xyz"[number]);
    return out;
  }

  // Links in an order in which parents come first.
  void order_and_place(RobotBase base) {
    if (robot_.links.empty()) root_.fail("without <link>; expected a robot");
    std::map<std::string, std::vector<std::string>> children;
    for (const auto& [child, edge] : edges_) {
      for (const std::string& name : {child, edge.parent})
        if (!known_.contains(name)) edge.element.fail("there is no link " + in_quotes(name));
      children[edge.parent].push_back(child);
    }
    std::vector<std::string> order;
    for (const auto& [name, element] : links_)
      if (!edges_.contains(name)) order.push_back(name);
    const std::size_t roots = order.size();
    std::vector<RobotLink> links;
    std::map<std::string, int> index;
    for (std::size_t k = 0; k < order.size(); ++k) {  // grows
      RobotLink& link = robot_.links[known_.at(order[k])];
      index[order[k]] = static_cast<int>(k);
      if (const auto edge = edges_.find(order[k]); edge != edges_.end()) {
        link.parent = index.at(edge->second.parent);
        read_joint(edge->second.element, link);
      }
      auto& below = children[order[k]];
      std::sort(below.begin(), below.end(),
                [&](const auto& a, const auto& b) { return known_.at(a) < known_.at(b); });
      order.insert(order.end(), below.begin(), below.end());
      links.push_back(std::move(link));
    }
    if (links.size() != robot_.links.size())
      root_.fail("joints go round in a circle; expected a tree of links");
    for (std::size_t k = 0; k < roots; ++k) stand(base, links[k]);
    for (std::size_t k = roots; k < order.size(); ++k) {  // floats in the world
      const auto parent = static_cast<std::size_t>(links[k].parent);
      if (parent >= roots || links[parent].free || edges_.at(order[k]).element.text("type") != "floating")
        continue;
      links[k].free = true;
      links[k].joints.clear();
    }
    robot_.links = std::move(links);
  }

  // A part that has a robot stand or roll on the ground, by its name; empty: there is none.
  std::string mobile_part() const {
    const auto named = [](const std::string& name) {
      std::string lower = name;
      std::transform(lower.begin(), lower.end(), lower.begin(),
                     [](unsigned char c) { return std::tolower(c); });
      return std::any_of(std::begin(kMobile), std::end(kMobile),
                         [&](std::string_view word) { return lower.find(word) != std::string::npos; });
    };
    for (const auto& [name, element] : links_)
      if (named(name)) return name;
    for (const std::string& name : joint_names_)
      if (named(name)) return name;
    return {};
  }

  void stand(RobotBase base, RobotLink& root) {
    const bool massless = !root.inertia || !(root.inertia->mass > 0);
    const std::string part = mobile_part();
    std::string why;
    if (base != RobotBase::automatic) {
      root.free = base == RobotBase::floating;
      why = "as --base says";
    } else if (root.name == "world") {
      why = "it is called world";
    } else if (!massless) {
      root.free = true;
      why = "it has a mass";
    } else if (!part.empty()) {
      root.free = true;
      why = fmt::format("it has no mass, but the robot has {}", in_quotes(part));
    } else {
      why = "it has no mass";
    }
    robot_.base = root.free ? "the root floats: " : "the root is fixed to the world: ";
    robot_.base += why;
    if (base == RobotBase::automatic)
      robot_.base += root.free ? " (--base fixed holds it)" : " (--base floating lets it go)";
  }

  XmlElement root_;
  RobotMeshes& meshes_;
  ImportNotes& notes_;
  Robot robot_;
  std::size_t geoms_ = 0;
  std::vector<std::pair<std::string, XmlElement>> links_;  // in the order of the file
  std::map<std::string, std::size_t> known_;               // places there
  std::map<std::string, Edge> edges_;                      // by child
  std::set<std::string> joint_names_;
  std::map<std::string, Vec3> colors_;
};

}  // namespace

Robot read_urdf(const XmlElement& root, RobotMeshes& meshes, ImportNotes& notes,
                const ImportOptions& options) {
  return UrdfReader(root, meshes, notes).read(options.base);
}

}  // namespace pabd
