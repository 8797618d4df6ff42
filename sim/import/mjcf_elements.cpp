// SPDX-License-Identifier: MIT
// See mjcf_elements.h. Meanings and defaults are those of MuJoCo's XML reference.
#include "sim/import/mjcf_elements.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "sim/import/geometry.h"
#include "sim/import/taken.h"
#include "sim/math/so3.h"
#include "sim/scene/text.h"

namespace pabd {
namespace {

Vec3 unit(const XmlElement& element, std::string_view attribute, const Vec3& v) {
  if (!(v.norm() > 1e-9)) element.fail_at(attribute, "its length is 0; expected a direction");
  return v.normalized();
}

Mat3 about(int axis, double angle) { return Eigen::AngleAxisd(angle, Vec3::Unit(axis)).toRotationMatrix(); }

Mat3 from_euler(const XmlElement& element, const Vec3& angles, const MjcfCompiler& compiler) {
  Mat3 R = Mat3::Identity();
  for (int k = 0; k < 3; ++k) {
    const char c = compiler.eulerseq[static_cast<std::size_t>(k)];
    const bool fixed_axes = c >= 'X' && c <= 'Z';
    const int axis = c - (fixed_axes ? 'X' : 'x');
    if (axis < 0 || axis > 2)
      element.fail_at("euler", "the compiler's eulerseq is no sequence of x, y and z");
    const Mat3 turn = about(axis, angles[k] * compiler.angle);
    R = fixed_axes ? Mat3(turn * R) : Mat3(R * turn);
  }
  return R;
}

bool turned(const XmlElement& element) {
  return element.has("quat") || element.has("axisangle") || element.has("euler") || element.has("xyaxes") ||
         element.has("zaxis");
}

const XmlElement& with_turn(const MjcfElement& element) {
  for (const XmlElement& each : element.all())
    if (turned(each)) return each;
  return element.own();
}

constexpr std::pair<std::string_view, GeomKind> kKinds[] = {
    {"plane", GeomKind::plane},       {"sphere", GeomKind::sphere},       {"capsule", GeomKind::capsule},
    {"cylinder", GeomKind::cylinder}, {"ellipsoid", GeomKind::ellipsoid}, {"box", GeomKind::box},
    {"mesh", GeomKind::mesh}};

// Numbers of "size" that each kind needs.
std::size_t sizes_of(GeomKind kind) {
  switch (kind) {
    case GeomKind::sphere:
      return 1;
    case GeomKind::capsule:
    case GeomKind::cylinder:
      return 2;
    case GeomKind::box:
    case GeomKind::ellipsoid:
      return 3;
    default:
      return 0;
  }
}

// From one point to another along z; the size then is the radius alone.
bool read_fromto(const MjcfElement& element, RobotGeom& geom) {
  const XmlElement& source = element.with("fromto");
  const auto ends = source.numbers("fromto", 6, 6);
  if (!ends) return false;
  if (sizes_of(geom.kind) < 2) source.fail_at("fromto", "expected a capsule, cylinder, box or ellipsoid");
  const Vec3 a((*ends)[0], (*ends)[1], (*ends)[2]), b((*ends)[3], (*ends)[4], (*ends)[5]);
  geom.at.t = (a + b) / 2;
  geom.at.R = rotation_between(Vec3::UnitZ(), unit(source, "fromto", a - b));
  const double half = (a - b).norm() / 2;
  const XmlElement& sized = element.with("size");
  const auto size = sized.numbers("size", 1, 3);
  if (!size) element.own().fail_at("size", "missing; expected a radius");
  const double r = size->front();
  geom.size =
      geom.kind == GeomKind::box || geom.kind == GeomKind::ellipsoid ? Vec3(r, r, half) : Vec3(r, half, 0);
  return true;
}

bool read_mesh(const MjcfElement& element, const MjcfContext& context, RobotGeom& geom) {
  const XmlElement& own = element.own();
  const XmlElement& source = element.with("mesh");
  const std::string name = source.text("mesh");
  const auto found = context.assets.meshes.find(name);
  if (found == context.assets.meshes.end()) source.fail_at("mesh", "there is no mesh " + in_quotes(name));
  const MjcfAssets::Mesh& mesh = found->second;
  geom.kind = GeomKind::mesh;
  if (mesh.file.empty() && mesh.vertices.empty()) {
    own.note(*context.notes,
             fmt::format("mesh {} is left out: it is made by MuJoCo itself", in_quotes(name)));
    return false;
  }
  if (!mesh.file.empty()) {
    if (!context.meshes->put(context.compiler.mesh_folder / mesh.file, mesh.scale, own, geom, *context.notes))
      return false;
  } else {
    const RobotMesh made = robot_mesh(mesh.vertices, {});
    if (!made.problem.empty()) {
      own.note(*context.notes, fmt::format("mesh {} is left out: {}", in_quotes(name), made.problem));
      return false;
    }
    geom.points = made.corners;
    geom.solid = made.solid;
  }
  const LinkPose& r = mesh.reference;
  const LinkPose undo{r.R.transpose(), -(r.R.transpose() * r.t)};
  for (Vec3& point : geom.points) point = undo * point;
  geom.solid = moved(geom.solid, undo);
  return true;
}

// A primitive in place of a mesh: about its centre of mass, by the box that has its moments, whose longest edge is z.
bool fit_to_mesh(const MjcfElement& element, const MjcfContext& context, RobotGeom& geom) {
  RobotGeom mesh;
  if (!read_mesh(element, context, mesh)) return false;
  const RobotInertia& solid = mesh.solid;
  const Eigen::SelfAdjointEigenSolver<Mat3> principal(solid.I);
  Mat3 axes = principal.eigenvectors().rowwise().reverse();
  if (axes.determinant() < 0) axes.col(0) = -axes.col(0);
  const Vec3 I = principal.eigenvalues().reverse();
  Vec3 half;
  for (int k = 0; k < 3; ++k) half[k] = std::sqrt(std::max(1.5 * (I.sum() - 2 * I[k]) / solid.mass, 0.0));
  geom.at = geom.at * LinkPose{axes, solid.com};
  const double r = (half.x() + half.y()) / 2;
  switch (geom.kind) {
    case GeomKind::sphere:
      geom.size = Vec3(half.mean(), 0, 0);
      return true;
    case GeomKind::capsule:
      geom.size = Vec3(r, std::max(half.z() - r / 2, 1e-6), 0);
      return true;
    case GeomKind::cylinder:
      geom.size = Vec3(r, half.z(), 0);
      return true;
    default:
      geom.size = half;
      return true;
  }
}

void read_size(const MjcfElement& element, RobotGeom& geom) {
  const std::size_t needed = sizes_of(geom.kind);
  const XmlElement& source = element.with("size");
  const auto size = source.numbers("size", needed, 3);
  if (!size) {
    if (needed > 0) element.own().fail_at("size", fmt::format("missing; expected {} numbers", needed));
    return;
  }
  for (std::size_t k = 0; k < needed; ++k) geom.size[static_cast<Index>(k)] = (*size)[k];
}

// The lengths count from condim 4 (torsional) and 6 (rolling) on; 1 has no friction.
SurfaceFriction geom_friction(const XmlElement& element, const XmlElement& dimension) {
  std::array<double, 3> given{1, 0.005, 0.0001};
  if (const auto own = element.numbers("friction", 1, 3)) std::copy(own->begin(), own->end(), given.begin());
  if (std::any_of(given.begin(), given.end(), [](double x) { return x < 0; }))
    element.fail_at("friction", "is negative");
  const double condim = dimension.number("condim").value_or(3);
  const double slip = condim < 3 ? 0 : given[0];
  return {slip, slip, condim < 4 ? 0 : given[1], condim < 6 ? 0 : given[2]};
}

// Empty things are marks.
bool has_size(const RobotGeom& geom) {
  const auto size = geom.size.head(static_cast<Index>(sizes_of(geom.kind)));
  return size.size() == 0 || (size.minCoeff() >= kLeastSize && size.maxCoeff() <= kMostSize);
}

std::optional<Vec3> read_color(const MjcfElement& element, const MjcfContext& context) {
  const auto rgba = element.with("rgba").numbers("rgba", 4, 4);
  if (rgba) return Vec3((*rgba)[0], (*rgba)[1], (*rgba)[2]).cwiseMax(0).cwiseMin(1);
  const auto material = element.with("material").find("material");
  if (!material) return {};
  const auto found = context.assets.colors.find(*material);
  if (found == context.assets.colors.end()) return {};
  return found->second;
}

// "ctrlrange" and "ctrllimited", or the like: a range that holds.
std::optional<std::pair<double, double>> range_of(const MjcfElement& element, std::string_view key,
                                                  std::string_view limited, const MjcfContext& context) {
  const auto range = element.with(key).numbers(key, 2, 2);
  const std::string word = element.with(limited).find(limited).value_or("auto");
  if (!range || !(word == "true" || (word == "auto" && context.compiler.autolimits))) return {};
  if (!((*range)[0] <= (*range)[1])) {
    element.own().note(*context.notes,
                       fmt::format("{}: its lower bound is above the upper one: not held", key));
    return {};
  }
  return std::pair((*range)[0], (*range)[1]);
}

int bits(const MjcfElement& element, std::string_view attribute) {
  const auto value = element.with(attribute).number(attribute);
  if (!value) return 1;
  if (*value != std::floor(*value) || !(*value >= 0 && *value <= 0x7fffffff))
    element.with(attribute).fail_at(attribute, "expected a whole number of 31 bits");
  return static_cast<int>(*value);
}

}  // namespace

Mat3 mjcf_rotation(const XmlElement& element, const MjcfCompiler& compiler) {
  if (const auto q = element.numbers("quat", 4, 4)) {
    const Quat quat((*q)[0], (*q)[1], (*q)[2], (*q)[3]);
    if (!(quat.norm() > 1e-9)) element.fail_at("quat", "its length is 0; expected a quaternion");
    return quat.normalized().toRotationMatrix();
  }
  if (const auto a = element.numbers("axisangle", 4, 4)) {
    const Vec3 axis = unit(element, "axisangle", Vec3((*a)[0], (*a)[1], (*a)[2]));
    return Eigen::AngleAxisd((*a)[3] * compiler.angle, axis).toRotationMatrix();
  }
  if (const auto e = element.vec3("euler")) return from_euler(element, *e, compiler);
  if (const auto a = element.numbers("xyaxes", 6, 6)) {
    const Vec3 x = unit(element, "xyaxes", Vec3((*a)[0], (*a)[1], (*a)[2]));
    Vec3 y((*a)[3], (*a)[4], (*a)[5]);
    y = unit(element, "xyaxes", y - x.dot(y) * x);
    Mat3 R;
    R << x, y, x.cross(y);
    return R;
  }
  if (const auto z = element.vec3("zaxis"))
    return rotation_between(Vec3::UnitZ(), unit(element, "zaxis", *z));
  return Mat3::Identity();
}

LinkPose mjcf_pose(const MjcfElement& element, const MjcfCompiler& compiler) {
  return {mjcf_rotation(with_turn(element), compiler),
          element.with("pos").vec3("pos").value_or(Vec3::Zero())};
}

std::optional<RobotGeom> mjcf_geom(const MjcfElement& element, const MjcfContext& context) {
  const XmlElement& own = element.own();
  note_attributes(own, mjcf_rows(), *context.notes);
  RobotGeom geom;
  geom.place = place_of(own);
  const std::string type = element.with("type").find("type").value_or("sphere");
  const auto* kind =
      std::find_if(std::begin(kKinds), std::end(kKinds), [&](auto& k) { return k.first == type; });
  if (kind == std::end(kKinds)) {
    own.note(*context.notes, fmt::format("geom of type {} is left out: no such shape here", in_quotes(type)));
    return {};
  }
  geom.kind = kind->second;
  geom.type = bits(element, "contype");
  geom.affinity = bits(element, "conaffinity");
  geom.visual = geom.type == 0 && geom.affinity == 0;
  geom.at = mjcf_pose(element, context.compiler);
  if (geom.kind == GeomKind::mesh) {
    if (!read_mesh(element, context, geom)) return {};
  } else {
    const bool fitted = element.has("mesh") && geom.kind != GeomKind::plane;
    if (fitted && !fit_to_mesh(element, context, geom)) return {};
    if (!fitted && !read_fromto(element, geom)) read_size(element, geom);
    if (!has_size(geom)) {
      own.note(*context.notes, kNoSize);
      return {};
    }
  }
  geom.mass = element.with("mass").number("mass");
  geom.density = element.with("density").number("density").value_or(1000);
  if (geom.mass.value_or(0) < 0 || geom.density < 0) own.fail("its mass is negative");
  geom.friction = geom_friction(element.with("friction"), element.with("condim"));
  geom.color = read_color(element, context);
  return geom;
}

RobotInertia mjcf_inertial(const XmlElement& element, const MjcfContext& context) {
  note_attributes(element, mjcf_rows(), *context.notes);
  RobotInertia out;
  const auto mass = element.number("mass");
  if (!mass || *mass < 0) element.fail_at("mass", "expected a mass of at least 0");
  out.mass = *mass;
  out.com = element.vec3("pos").value_or(Vec3::Zero());
  Mat3 I = Mat3::Zero();
  if (const auto full = element.numbers("fullinertia", 6, 6)) {
    const auto& f = *full;
    I << f[0], f[3], f[4], f[3], f[1], f[5], f[4], f[5], f[2];
  } else if (const auto diagonal = element.vec3("diaginertia")) {
    I = diagonal->asDiagonal();
  } else {
    element.fail("expected diaginertia or fullinertia");
  }
  const Mat3 R = mjcf_rotation(element, context.compiler);
  out.I = R * I * R.transpose();
  return out;
}

std::optional<RobotJoint> mjcf_joint(const MjcfElement& element, const MjcfContext& context) {
  const XmlElement& own = element.own();
  note_attributes(own, mjcf_rows(), *context.notes);
  RobotJoint joint;
  joint.place = place_of(own);
  joint.name = own.find("name").value_or("");
  const std::string type = element.with("type").find("type").value_or("hinge");
  if (type == "free") {
    if (element.with("stiffness").resistance("stiffness") > 0)
      element.with("stiffness").note(*context.notes, "stiffness of a free joint: not taken");
    return {};
  }
  if (type == "ball") {
    joint.kind = RobotJointKind::ball;
  } else if (type == "slide") {
    joint.kind = RobotJointKind::slide;
  } else if (type != "hinge") {
    element.with("type").fail_at("type", "expected free, ball, slide or hinge, got " + in_quotes(type));
  }
  joint.anchor = element.with("pos").vec3("pos").value_or(Vec3::Zero());
  joint.axis = unit(own, "axis", element.with("axis").vec3("axis").value_or(Vec3::UnitZ()));
  joint.action.damping = element.with("damping").resistance("damping");
  joint.action.friction = element.with("frictionloss").resistance("frictionloss");
  if (joint.kind == RobotJointKind::ball && joint.action.friction > 0) {
    element.with("frictionloss").note(*context.notes, "frictionloss of a ball joint: not taken");
    joint.action.friction = 0;
  }
  const double unit_size = joint.kind == RobotJointKind::slide ? 1 : context.compiler.angle;
  joint.ref = element.with("ref").number("ref").value_or(0) * unit_size;
  joint.action.stiffness = element.with("stiffness").resistance("stiffness");
  joint.action.rest = element.with("springref").number("springref").value_or(0) * unit_size - joint.ref;
  if (joint.kind == RobotJointKind::ball && joint.action.stiffness > 0) {
    element.with("stiffness").note(*context.notes, "stiffness of a ball joint: not taken");
    joint.action.stiffness = 0;
  }
  const auto range = element.with("range").numbers("range", 2, 2);
  const std::string limited = element.with("limited").find("limited").value_or("auto");
  const bool held = limited == "true" || (limited == "auto" && context.compiler.autolimits && range);
  if (!held) return joint;
  if (!range) own.fail_at("range", "missing in a joint that is limited");
  if (joint.kind == RobotJointKind::ball) {
    own.note(*context.notes, "range of a ball joint: not taken: it turns freely");
    return joint;
  }
  joint.range = {(*range)[0] * unit_size - joint.ref, (*range)[1] * unit_size - joint.ref};
  if (!(joint.range->first < joint.range->second)) {
    own.note(*context.notes, kReversed);
    joint.range.reset();
  }
  return joint;
}

double mjcf_control(const MjcfElement& element, const MjcfContext& context) {
  const auto range = range_of(element, "ctrlrange", "ctrllimited", context);
  const double control = context.control.value_or(0);
  return range ? std::clamp(control, range->first, range->second) : control;
}

void mjcf_motor(const MjcfElement& element, const MjcfContext& context, RobotAction& out) {
  const XmlElement& e = element.own();
  const auto gears = element.with("gear").numbers("gear", 1, 6);
  const double gear = gears ? gears->front() : 1, control = mjcf_control(element, context);
  if (gear == 0) return e.note(*context.notes, "motor with gear 0: moves nothing");
  if (e.name() == "motor") {
    out.force = gear * control;
  } else {
    const double kv = element.with("kv").number("kv").value_or(1);
    if (kv < 0) e.fail_at("kv", "is negative");
    if (kv == 0) return e.note(*context.notes, "velocity actuator with kv 0: moves nothing");
    out.speed = control / gear;
    out.gain = kv * gear * gear;
    if (const auto most = range_of(element, "forcerange", "forcelimited", context)) {
      if (most->first != -most->second)
        e.note(*context.notes, "forcerange that is not the same both ways: the larger is taken for both");
      out.most = std::abs(gear) * std::max(std::abs(most->first), std::abs(most->second));
    }
  }
  e.note(
      *context.notes,
      "motor or velocity actuator: stands at control 0 or the nearest of its range; \"motor\" of the scene's "
      "joint is what it gives");
}

}  // namespace pabd
