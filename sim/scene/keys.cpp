// See keys.h.
#include "sim/scene/keys.h"

#include "sim/body/shape_kind.h"
#include "sim/joint/joint_traits.h"

namespace pabd {

namespace {

std::vector<std::string_view> keys_of(const JointTraits& joint) {
  std::vector<std::string_view> out{"name", "type", "bodies"};
  const auto add = [&out](bool has, std::initializer_list<std::string_view> some) {
    if (has) out.insert(out.end(), some);
  };
  add(joint.points, {"points", "length"});
  add(!joint.points, {"anchor"});
  add(joint.axes > 0, {"axis"});
  add(joint.axes > 1, {"second_axis"});
  add(measure_with(joint, &Joint::limits), {"limits", "drive"});
  add(measure_with(joint, &Joint::twist_limits), {"twist"});
  add(joint.turn, {"drive", "axes"});
  add(!joint.points, {"arm", "symmetric"});
  add(true, {"potential", "kappa", "N", "d_hat", "collide"});
  add(!joint.points, {"anchors", "frames"});
  return out;
}

}  // namespace

std::span<const std::string_view> joint_keys(JointType type) {
  static const auto kKeys = [] {
    std::array<std::vector<std::string_view>, kJointTypes.size()> keys;
    for (const JointType each : kJointTypes) keys[static_cast<std::size_t>(each)] = keys_of(traits_of(each));
    return keys;
  }();
  return kKeys[static_cast<std::size_t>(type)];
}

std::span<const KeyTable> key_tables() {
  static constexpr std::array kFixed{KeyTable{"scene", keys::scene},
                                     KeyTable{"solver", keys::solver},
                                     KeyTable{"contact", keys::contact},
                                     KeyTable{"friction", keys::friction},
                                     KeyTable{"joints_default", keys::joints_default},
                                     KeyTable{"camera", keys::camera},
                                     KeyTable{"body", keys::body},
                                     KeyTable{"stack", keys::stack},
                                     KeyTable{"wall", keys::wall},
                                     KeyTable{"pyramid", keys::pyramid},
                                     KeyTable{"pile", keys::pile},
                                     KeyTable{"chain", keys::chain},
                                     KeyTable{"net", keys::net},
                                     KeyTable{"drive", keys::drive},
                                     KeyTable{"twist", keys::twist},
                                     KeyTable{"friction_anchor", keys::friction_anchor}};
  static const auto kTables = [] {
    std::vector<KeyTable> tables(kFixed.begin(), kFixed.end());
    for (const ShapeKind* kind : shape_kinds()) {
      if (kind->name != tables.back().object) tables.push_back({kind->name, kind->keys});
    }
    for (const JointType type : kJointTypes) tables.push_back({to_string(type), joint_keys(type)});
    return tables;
  }();
  return kTables;
}

std::vector<std::string> scene_keys() {
  std::vector<std::string> out{"name", "description", "gravity", "time_step"};
  const auto add = [&out](const std::string& prefix, std::span<const std::string_view> table) {
    for (const std::string_view key : table) {
      if (key != "friction") out.push_back(prefix + std::string(key));
    }
  };
  add("solver.", keys::solver);
  add("contact.", keys::contact);
  add("contact.friction.", keys::friction);
  add("joints_default.", keys::joints_default);
  add("camera.", keys::camera);
  return out;
}

}  // namespace pabd
