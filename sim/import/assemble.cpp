// SPDX-License-Identifier: MIT
// See assemble.h. Groups of links become bodies and joints.
#include "sim/import/assemble.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "sim/base/error.h"
#include "sim/base/utf8.h"
#include "sim/body/compound.h"
#include "sim/import/geometry.h"
#include "sim/import/keep_apart.h"
#include "sim/import/link_groups.h"
#include "sim/scene/text.h"

namespace pabd {
namespace {

double radius_of(const std::vector<std::vector<Vec3>>& parts) {
  double out = 0;
  for (const auto& part : parts)
    for (const Vec3& corner : part) out = std::max(out, corner.norm());
  return out;
}

// Names of one kind. What comes again gets a number, looked for behind the last one.
class UniqueNames {
 public:
  explicit UniqueNames(std::set<std::string> reserved = {}) : used_(std::move(reserved)) {}

  std::string take(std::string name, std::string_view fallback) {
    std::erase_if(name, [](unsigned char c) { return c < 0x20 || c == 0x7f; });
    if (name.size() > 80 || name.empty() || !is_utf8_text(name)) name = fallback;
    int& number = last_.try_emplace(name, 1).first->second;
    std::string out = name;
    while (!used_.insert(out).second) out = fmt::format("{} {}", name, ++number);
    return out;
  }

 private:
  std::set<std::string> used_;
  std::map<std::string, int> last_;
};

constexpr std::size_t kMostSeen = 100;  // still geoms that are only seen: each is a pair with whatever moves

class Assembler {
 public:
  Assembler(const Robot& robot, ImportNotes& notes)
      : robot_(robot),
        notes_(notes),
        groups_(group_links(robot, notes)),
        links_(groups_.groups),
        group_of_(groups_.of) {}

  ScenePlan assemble() {
    for (std::size_t l = 0; l < links_.size(); ++l) make(l);
    for (const auto& [number, follow] : follows_) make_follow(number, *follow);
    for (const RobotLoop& loop : robot_.loops) make_loop(loop);
    keep_apart(robot_, groups_, plan_);
    weigh_trees();
    if (plan_.bodies.empty()) throw Error(ErrorKind::bad_input, "the robot has no bodies");
    return std::move(plan_);
  }

 private:
  void note(const Place& place, const std::string& text) { notes_.add(text, place.file, place.line); }

  void make(std::size_t l) {
    LinkGroup& group = links_[l];
    if (group.still) return make_still(group);
    if (group.dropped) return;
    const RobotLink& link = group.link;
    BodyPlan body;
    body.name = names_.take(link.name, fmt::format("link {}", l));
    body.tree = group.tree;
    body.mass = link.inertia->mass;
    body.lifted = link.inertia->lifted;
    body.c = group.pose * link.inertia->com;
    body.R = group.pose.R;
    body.I = link.inertia->I;
    shape(link, body);
    make_joints(group, body);
    group.bodies = {static_cast<int>(plan_.bodies.size())};
    // The last joint of the link is between what came before and this body.
    if (!link.joints.empty()) plan_.joints.back().j = group.bodies.front();
    lower(body);
    plan_.bodies.push_back(std::move(body));
  }

  // One primitive where it is the whole link, about the centre of mass; else convex parts.
  void shape(const RobotLink& link, BodyPlan& body) {
    std::vector<const RobotGeom*> shown;
    for (const RobotGeom& geom : link.geoms) {
      if (geom.kind == GeomKind::plane) {
        note(geom.place, "a plane that moves: left out");
      } else if (touches(geom)) {
        shown.push_back(&geom);
      }
    }
    const bool none = shown.empty();
    for (const RobotGeom& geom : link.geoms) {
      if (touches(geom)) continue;
      if (none)
        shown.push_back(&geom);
      else
        note(geom.place, "visual geometry of a link that has other geometry to collide with: not drawn");
    }
    if (none) {
      body.ghost = true;
      note(link.place, shown.empty() ? "has no shape: it touches nothing and is not drawn"
                                     : "has no geometry to collide with: it touches nothing");
    }
    if (shown.size() > kMostParts) {
      note(link.place, fmt::format("more than {} geoms in a link: only so many are taken", kMostParts));
      shown.resize(kMostParts);
    }
    if (shown.empty()) return unseen(body);
    body.color = shown.front()->color;
    masks(link, shown, body);
    if (shown.size() == 1 && primitive(*shown.front(), *link.inertia, body)) return;
    for (const RobotGeom* geom : shown) add_part(*geom, link.inertia->com, body);
  }

  void masks(const RobotLink& link, const std::vector<const RobotGeom*>& shown, BodyPlan& body) {
    body.type = body.affinity = 0;
    for (const RobotGeom* geom : shown) {
      if (geom != shown.front() &&
          (geom->type != shown.front()->type || geom->affinity != shown.front()->affinity))
        note(link.place,
             "geoms of one body with different contype or conaffinity: the body has those of all");
      body.type |= geom->type;
      body.affinity |= geom->affinity;
      if (geom != shown.front() && geom->friction != shown.front()->friction)
        note(link.place, "geoms of one body with different friction: the body has the largest");
      if (geom->friction)
        body.friction = combined(FrictionRule::max, body.friction.value_or(*geom->friction), *geom->friction);
    }
  }

  void add_part(const RobotGeom& geom, const Vec3& com, BodyPlan& body) {
    std::vector<Vec3> part = corners_of(geom);
    for (Vec3& corner : part) corner = geom.at * corner - com;
    body.parts.push_back(std::move(part));
    if (geom.kind != GeomKind::box && geom.kind != GeomKind::mesh)
      note(geom.place, "round geometry is a polyhedron: a body of several shapes is made of those");
  }

  bool primitive(const RobotGeom& geom, const RobotInertia& inertia, BodyPlan& body) {
    if (geom.kind == GeomKind::mesh || geom.kind == GeomKind::ellipsoid) return false;
    const double extent = geom.size.cwiseAbs().maxCoeff();
    const Vec3 centre = geom.at.R.transpose() * (geom.at.t - inertia.com);
    if (centre.norm() > 1e-9 * extent) body.centre = centre;
    body.kind = geom.kind;
    body.size = geom.size;
    body.R = body.R * geom.at.R;
    body.I = geom.at.R.transpose() * inertia.I * geom.at.R;
    RobotGeom centred = geom;
    centred.at = LinkPose{};
    const RobotInertia even = solid_of(centred, 1);
    body.even = (even.I * (inertia.mass / even.mass) - body.I).norm() <= 1e-9 * body.I.norm();
    body.parts = {corners_of(centred)};  // for bounds
    for (Vec3& corner : body.parts.front()) corner += body.centre;
    return true;
  }

  // A ball of about these moments, which is not drawn.
  void unseen(BodyPlan& body) {
    body.hidden = true;
    body.kind = GeomKind::sphere;
    RobotGeom ball;
    ball.size.x() = std::clamp(std::sqrt(2.5 * body.I.trace() / (3 * body.mass)), 1e-3, 0.05);
    body.size = ball.size;
    body.parts = {corners_of(ball)};
  }

  void make_joints(LinkGroup& group, const BodyPlan& body) {
    const RobotLink& link = group.link;
    if (link.joints.empty()) return;
    const LinkGroup& parent = links_[static_cast<std::size_t>(link.parent)];
    if (parent.dropped) refuse_link(link, "a parent that was left out");
    int from = parent.still ? kNoBody : parent.bodies.front();
    // Poses before each joint turned: from the parent's outwards.
    LinkPose at = parent.pose * link.at;
    const double reach = std::max(radius_of(body.parts), 1e-3);
    for (std::size_t k = 0; k < link.joints.size(); ++k) {
      const RobotJoint& joint = link.joints[k];
      JointPlan out;
      out.kind = joint.kind;
      out.name = unique_joint(joint.name);
      out.i = from;
      out.axis = at.R * joint.axis;
      out.start = group.start[k];
      if (joint.kind == RobotJointKind::slide) {
        at.t += out.start * out.axis;
        out.anchor = at * joint.anchor;
      } else {
        out.anchor = at * joint.anchor;
        const Mat3 turn = Eigen::AngleAxisd(out.start, out.axis).toRotationMatrix();
        if (out.start != 0) at = LinkPose{turn, out.anchor - turn * out.anchor} * at;
      }
      out.range = joint.range;
      out.target = joint.target;
      out.action = joint.action;
      out.place = joint.place;
      out.arm = 0.5 * reach;
      if (k + 1 < link.joints.size()) {
        from = out.j = light(body, out.anchor, reach);
        note(joint.place, "one of several joints of a link: a light body is put between them");
      }
      joint_number_.try_emplace(joint.name, plan_.joints.size());
      if (joint.follows) follows_.emplace_back(plan_.joints.size(), &*joint.follows);
      plan_.joints.push_back(std::move(out));
    }
  }

  void make_follow(std::size_t number, const RobotFollow& follow) {
    JointPlan& joint = plan_.joints[number];
    const auto leader = joint_number_.find(follow.joint);
    const bool known = leader != joint_number_.end() && leader->second != number;
    if (!known || joint.kind == RobotJointKind::ball ||
        plan_.joints[leader->second].kind == RobotJointKind::ball)
      return note(follow.place,
                  fmt::format("follows {}, which is no other joint that moves along one coordinate: "
                              "moves freely",
                              in_quotes(follow.joint)));
    if (follow.ratio == 0) return note(follow.place, "follows another joint with the ratio 0: moves freely");
    if (joint.target) note(joint.place, "equality of a joint that follows another: not taken");
    joint.target.reset();
    joint.follows = {static_cast<int>(leader->second), follow.ratio, follow.offset};
  }

  int light(const BodyPlan& body, const Vec3& anchor, double reach) {
    BodyPlan out;
    out.name = names_.take(fmt::format("{} between joints", body.name), "between joints");
    out.ghost = out.hidden = true;
    out.mass = std::max(kLight * body.mass, 1e-9);
    const double inertia = body.I.trace() / 3 + body.mass * (body.c - anchor).squaredNorm();
    out.I = Mat3::Identity() * (kLight * inertia);
    out.c = anchor;
    out.kind = GeomKind::sphere;
    out.size = Vec3(0.2 * reach, 0, 0);
    const int index = static_cast<int>(plan_.bodies.size());
    plan_.bodies.push_back(std::move(out));
    return index;
  }

  std::string unique_joint(std::string name) {
    return joint_names_.take(std::move(name), fmt::format("joint {}", plan_.joints.size()));
  }

  // What is fixed to the world: a body for each geom.
  void make_still(LinkGroup& group) {
    std::vector<const RobotGeom*> shown;
    for (const RobotGeom& geom : group.link.geoms) {
      if (touches(geom) || (geom.alone && seen_++ < kMostSeen))
        shown.push_back(&geom);
      else
        note(geom.place, "visual geometry that does not move: not drawn");
    }
    for (const RobotGeom* geom : shown) {
      BodyPlan body;
      body.name = names_.take(shown.size() == 1 || geom->kind != GeomKind::plane ? group.link.name : "ground",
                              "world");
      body.fixed = true;
      body.ghost = !touches(*geom);
      body.color = geom->color;
      body.type = geom->type;
      body.affinity = geom->affinity;
      body.tree = geom->tree;
      body.friction = geom->friction;
      body.c = group.pose * geom->at.t;
      body.R = group.pose.R * geom->at.R;
      body.kind = geom->kind == GeomKind::ellipsoid ? GeomKind::mesh : geom->kind;
      body.size = geom->size;
      body.parts = {corners_of(*geom)};
      group.bodies.push_back(static_cast<int>(plan_.bodies.size()));
      plan_.bodies.push_back(std::move(body));
    }
  }

  // What touches stands on the ground; where nothing does, what is seen; else what there is.
  void lower(const BodyPlan& body) {
    const int rank = body.hidden ? 1 : body.ghost ? 2 : 3;
    double radius = 0;
    for (const auto& part : body.parts) {
      for (const Vec3& corner : part) {
        const double z = (body.c + body.R * corner).z();
        if (rank > lowered_ || (rank == lowered_ && z < plan_.lowest)) plan_.lowest = z;
        lowered_ = std::max(lowered_, rank);
        radius = std::max(radius, corner.norm());
      }
    }
    if (!body.ghost) plan_.smallest = plan_.smallest > 0 ? std::min(plan_.smallest, radius) : radius;
  }

  const LinkGroup& group_with(int link) const {
    return links_[static_cast<std::size_t>(group_of_[static_cast<std::size_t>(link)])];
  }
  int body_of(int link) const {
    const LinkGroup& group = group_with(link);
    return group.still ? kNoBody : group.bodies.front();
  }

  void make_loop(const RobotLoop& loop) {
    if (group_with(loop.i).dropped || group_with(loop.j).dropped)
      return note(loop.place, "holds a link that was left out: left out");
    JointPlan out;
    out.weld = loop.weld;
    out.kind = RobotJointKind::ball;
    out.i = body_of(loop.i);
    out.j = body_of(loop.j);
    out.name = unique_joint("loop");
    if (out.i == out.j) return note(loop.place, "holds a body to itself: left out");
    // The anchor is told in the body's own frame, which may stand anywhere in its group.
    out.anchor = pose_of(loop.i) * loop.anchor;
    out.arm = 0.5 * std::max(reach_of(out.i), reach_of(out.j));
    plan_.joints.push_back(std::move(out));
  }

  double reach_of(int body) const {
    return body == kNoBody ? 1e-3
                           : std::max(1e-3, radius_of(plan_.bodies[static_cast<std::size_t>(body)].parts));
  }

  LinkPose pose_of(int link) const {
    const RobotLink& told = robot_.links[static_cast<std::size_t>(link)];
    const bool joined = told.parent != kNoLink && told.joints.empty() && !told.free;
    if (joined) return pose_of(told.parent) * told.at;
    return group_with(link).pose;
  }

  // Links come after their parents: from the last one on, masses go to the roots.
  void weigh_trees() {
    std::vector<double> mass(links_.size());
    for (std::size_t l = links_.size(); l-- > 0;) {
      const LinkGroup& group = links_[l];
      if (group.still || group.dropped) continue;
      mass[l] += group.link.inertia->mass;
      plan_.heaviest = std::max(plan_.heaviest, mass[l]);
      if (group.link.parent != kNoLink) mass[static_cast<std::size_t>(group.link.parent)] += mass[l];
    }
  }

  const Robot& robot_;
  ImportNotes& notes_;
  ScenePlan plan_;
  LinkGroups groups_;
  std::vector<LinkGroup>& links_;
  const std::vector<int>& group_of_;
  UniqueNames names_{std::set<std::string>{kGroundName}}, joint_names_;
  std::map<std::string, std::size_t> joint_number_;  // by their names in the file
  std::vector<std::pair<std::size_t, const RobotFollow*>> follows_;
  std::size_t seen_ = 0;  // still geoms that are only seen
  int lowered_ = 0;       // rank of the lowest
};

}  // namespace

ScenePlan assemble(const Robot& robot, ImportNotes& notes) { return Assembler(robot, notes).assemble(); }

}  // namespace pabd
