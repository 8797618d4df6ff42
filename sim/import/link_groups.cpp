// SPDX-License-Identifier: MIT
// See link_groups.h.
#include "sim/import/link_groups.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "sim/base/error.h"
#include "sim/import/geometry.h"
#include "sim/scene/text.h"

namespace pabd {
namespace {

constexpr std::size_t kMostInARow = 20;  // joints, each of which follows the next

constexpr double kLeastMass = 1e-9;  // kg, that a body of a scene may have
constexpr double kDensity = 1000;    // kg/m³, of a moving link that says nothing of its mass

class Grouping {
 public:
  Grouping(const Robot& robot, ImportNotes& notes) : robot_(robot), notes_(notes) {}

  LinkGroups group() {
    merge();
    behind_.resize(out_.groups.size());
    for (std::size_t l = out_.groups.size(); l-- > 0;) {  // what is behind a link comes first
      weigh(l);
      const RobotLink& link = out_.groups[l].link;
      if (link.parent != kNoLink)
        behind_[static_cast<std::size_t>(link.parent)] += behind_[l] + link.inertia->mass;
    }
    place();
    return std::move(out_);
  }

 private:
  void note(const Place& place, const std::string& text) { notes_.add(text, place.file, place.line); }

  // Robots that stand in a world are trees of their own.
  int tree_of(std::size_t l) const {
    const int parent = robot_.links[l].parent;
    if (parent == kNoLink) return robot_.has_world ? kNoTree : static_cast<int>(l);
    const int above = tree_[static_cast<std::size_t>(parent)];
    return above == kNoTree ? static_cast<int>(l) : above;
  }

  // Every link's group, and where it stands in it.
  void merge() {
    std::vector<LinkPose> in_group;
    for (const RobotLink& link : robot_.links) {
      tree_.push_back(tree_of(tree_.size()));
      const bool root = link.parent == kNoLink;
      const bool joined = !root && link.joints.empty() && !link.free;
      LinkPose pose;
      if (joined) {
        out_.of.push_back(out_.of[static_cast<std::size_t>(link.parent)]);
        pose = in_group[static_cast<std::size_t>(link.parent)] * link.at;
      } else {
        out_.of.push_back(static_cast<int>(out_.groups.size()));
        LinkGroup group;
        group.link = link;
        group.link.geoms.clear();
        group.link.inertia.reset();
        group.still = root && !link.free;
        group.tree = tree_.back();
        if (!root) {
          const auto parent = static_cast<std::size_t>(link.parent);
          group.link.at = in_group[parent] * link.at;
          group.link.parent = out_.of[parent];
        }
        out_.groups.push_back(std::move(group));
      }
      in_group.push_back(pose);
      take(link, pose, out_.groups[static_cast<std::size_t>(out_.of.back())].link);
    }
  }

  void take(const RobotLink& link, const LinkPose& pose, RobotLink& into) {
    const bool touched = std::any_of(link.geoms.begin(), link.geoms.end(), touches);
    RobotInertia own = link.inertia ? moved(*link.inertia, pose) : RobotInertia{};
    for (RobotGeom geom : link.geoms) {
      geom.at = pose * geom.at;
      geom.tree = tree_.back();
      geom.alone = !touched && geom.kind != GeomKind::plane;
      if (!link.inertia && geom.kind != GeomKind::plane) own = together(own, inertia_of(geom));
      into.geoms.push_back(std::move(geom));
    }
    own.lifted = link.lifted * own.mass;
    into.inertia = together(into.inertia.value_or(RobotInertia{}), own);
  }

  // A mass for each moving group. What nobody gave one gets it from its geoms; a leaf with neither is dropped.
  void weigh(std::size_t l) {
    LinkGroup& group = out_.groups[l];
    RobotLink& link = group.link;
    if (group.still) return;
    RobotInertia& inertia = *link.inertia;
    if (inertia.mass > 0 && inertia.mass < kLeastMass) {
      note(link.place, "moves with less than 1e-09 kg: as if it had no mass");
      inertia = {};
    }
    if (!(inertia.mass > 0)) {
      for (const RobotGeom& geom : link.geoms)
        if (touches(geom) && geom.kind != GeomKind::plane)
          inertia = together(inertia, solid_of(geom, kDensity));
      if (inertia.mass > 0)
        note(link.place, "moves but has no mass: that of its geometry at 1000 kg/m³ is taken");
    }
    if (!(inertia.mass >= kLeastMass)) return weightless(l);
    if (inertia.mass < kLeastMass || inertia.mass > 1e12)
      refuse_link(link, "a mass outside of 1e-09 to 1e+12 kg");
    if (is_physical(inertia.I)) return;
    note(link.place, "no body has these moments of inertia; the least is raised until one has");
    if (!(inertia.I.trace() > 0)) inertia.I = Mat3::Identity() * (1e-4 * inertia.mass);  // a ball of 16 mm
    inertia.I = made_physical(inertia.I);
  }

  // A link without mass that carries others is light; one that carries none does nothing.
  void weightless(std::size_t l) {
    LinkGroup& group = out_.groups[l];
    const double above = behind_[l];
    if (!(above > 0)) {
      group.dropped = true;
      note(group.link.place,
           "moves but has neither mass nor shape nor a link with a mass behind it: left out");
      return;
    }
    note(group.link.place, "moves but has no mass: a thousandth of that of the links behind it is taken");
    const double r = 0.02;  // m
    const double mass = std::max(kLight * above, kLeastMass);
    group.link.inertia = RobotInertia{mass, Vec3::Zero(), Mat3::Identity() * (0.4 * mass * r * r)};
  }

  // Where joints start: at 0, or at the nearest in their range; what follows another joint, where that says.
  void find_starts() {
    std::map<std::string, const double*> start;  // of the first of that name
    std::vector<std::pair<RobotJoint*, double*>> following;
    for (LinkGroup& group : out_.groups) {
      group.start.resize(group.link.joints.size());
      for (std::size_t k = 0; k < group.start.size(); ++k) {
        RobotJoint& joint = group.link.joints[k];
        double& q = group.start[k];
        q = joint.start;
        if (joint.range) q = std::clamp(q, joint.range->first, joint.range->second);
        start.try_emplace(joint.name, &q);
        if (joint.follows) {
          following.emplace_back(&joint, &q);
        } else if (q != joint.start) {
          note(joint.place, joint.start == 0
                                ? "its range leaves out 0: it begins at the bound"
                                : "its range leaves out where it starts: it begins at the bound");
        }
      }
    }
    // One may follow another that follows a third.
    for (std::size_t round = 0; round < std::min(following.size(), kMostInARow); ++round)
      for (const auto& [joint, q] : following)
        if (const auto leader = start.find(joint->follows->joint); leader != start.end())
          *q = joint->follows->ratio * *leader->second + joint->follows->offset;
    for (const auto& [joint, q] : following) {
      if (!joint->range || (*q >= joint->range->first && *q <= joint->range->second)) continue;
      note(joint->place,
           "starts beyond its range, where the joint that it follows has it: the range is not held");
      joint->range.reset();
    }
  }

  // Forward kinematics at the start.
  void place() {
    find_starts();
    for (LinkGroup& group : out_.groups) {
      const RobotLink& link = group.link;
      group.pose = link.parent == kNoLink ? link.at
                                          : out_.groups[static_cast<std::size_t>(link.parent)].pose * link.at;
      for (std::size_t k = 0; k < link.joints.size(); ++k) {
        const RobotJoint& joint = link.joints[k];
        const double q = group.start[k];
        const Vec3 axis = group.pose.R * joint.axis, anchor = group.pose * joint.anchor;
        if (joint.kind == RobotJointKind::slide) group.pose.t += q * axis;
        if (joint.kind == RobotJointKind::hinge && q != 0) {
          const Mat3 turn = Eigen::AngleAxisd(q, axis).toRotationMatrix();
          group.pose = LinkPose{turn, anchor - turn * anchor} * group.pose;
        }
      }
    }
  }

  const Robot& robot_;
  ImportNotes& notes_;
  std::vector<int> tree_;       // of each link
  std::vector<double> behind_;  // mass behind each group; kg
  LinkGroups out_;
};

}  // namespace

void refuse_link(const RobotLink& link, std::string_view what) {
  throw Error(ErrorKind::bad_input, fmt::format("{}:{}", link.place.file, link.place.line),
              fmt::format("the link {} has {}", in_quotes(link.name), what));
}

LinkGroups group_links(const Robot& robot, ImportNotes& notes) { return Grouping(robot, notes).group(); }

}  // namespace pabd
