// SPDX-License-Identifier: MIT
// See write_scene.h.
#include "sim/scene/write_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <unordered_set>

#include "sim/base/error.h"
#include "sim/body/compound.h"
#include "sim/body/mass_properties.h"
#include "sim/scene/read_memory.h"
#include "sim/scene/text.h"
#include "sim/scene/tuning.h"
#include "sim/scene/write_joint.h"
#include "sim/solver/couplings.h"

namespace pabd {
namespace {

// Is the matter spread evenly over the shape, as a body without "inertia" has it?
bool is_even(const Shape& shape, double mass, const Mat3& J) {
  const Mat3 even = mass_properties(shape, mass / volume(shape)).J;
  return (J - even).norm() <= 1e-12 * even.norm();
}

// Pairs that never touch, but for those that joints alone keep apart.
std::vector<std::pair<Index, Index>> pairs_apart(const Model& model) {
  std::vector<std::pair<Index, Index>> joined, loose, out;
  for (const Joint& joint : model.joints)
    if (joint.i != kWorld && joint.j != kWorld && !joint.collide)
      joined.emplace_back(std::minmax(joint.i, joint.j));
  std::sort(joined.begin(), joined.end());
  const auto &all = model.no_collide, &stated = model.stated_apart;
  std::set_difference(all.begin(), all.end(), joined.begin(), joined.end(), std::back_inserter(loose));
  std::set_union(loose.begin(), loose.end(), stated.begin(), stated.end(), std::back_inserter(out));
  return out;
}

// Entries of "no_collide".
OrderedJson pairs_json(const Model& model) {
  OrderedJson out = OrderedJson::array();
  for (const auto& [i, j] : pairs_apart(model))
    out.push_back({model.name[static_cast<std::size_t>(i)], model.name[static_cast<std::size_t>(j)]});
  const CollisionGroups& groups = model.groups;
  const auto used = [&](std::size_t g) {  // a group that lost its last body is not there when it is read
    return std::any_of(groups.of_body.begin(), groups.of_body.end(),
                       [&](std::uint64_t bits) { return (bits >> g & 1) != 0; });
  };
  for (std::size_t g = 0; g < groups.name.size(); ++g) {
    for (std::size_t h = 0; h <= g; ++h) {
      if ((groups.apart[g] >> h & 1) == 0 || !used(g) || !used(h)) continue;
      OrderedJson pair = OrderedJson::array();
      for (const std::size_t side : {h, g}) pair.push_back(OrderedJson{{"group", groups.name[side]}});
      out.push_back(std::move(pair));
    }
  }
  return out;
}

OrderedJson json_of_body(const Model& model, const State& state, const BodyLooks& looks, std::size_t i) {
  const CompoundPart* part = off_centre(model.shape[i]);
  OrderedJson shape = json_of(part ? part->shape : model.shape[i]);
  if (shape.is_null()) {
    throw Error(ErrorKind::bad_input,
                fmt::format("the shape of {} comes from a mesh file, which cannot be written into a scene; "
                            "remove the body, or save only the parameters",
                            in_quotes(model.name[i])));
  }
  const auto own = [i](const auto& of_bodies) {
    return of_bodies.empty() ? typename std::decay_t<decltype(of_bodies)>::value_type() : of_bodies[i];
  };
  spec::Body out{.name = model.name[i],
                 .friction = own(model.friction),
                 .restitution = own(model.restitution),
                 .surface_velocity = own(model.surface_velocity)};
  const CollisionGroups& groups = model.groups;
  for (std::size_t g = 0; g < groups.name.size() && !groups.of_body.empty(); ++g)
    if ((groups.of_body[i] >> g & 1) != 0) out.groups.push_back(groups.name[g]);
  if (!is_plane(model.shape[i])) {
    out.fixed = model.fixed[i] != 0;
    if (!out.fixed) {
      out.mass = model.mass[i];
      if (const Mat3& J = model.J[i]; !is_even(model.shape[i], model.mass[i], J)) {
        const Mat3 I = inertia_tensor(J);
        out.inertia = {I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)};
      }
    }
    out.position = part ? Vec3(state.c[i] + state.R[i] * part->offset) : state.c[i];
    if (part) out.center_of_mass = -part->offset;
    if (state.R[i] != Mat3::Identity()) out.orientation = orientation_of(state.R[i]);
    if (!state.v[i].isZero(0)) out.velocity = state.v[i];
    if (!state.omega[i].isZero(0)) out.angular_velocity = state.omega[i] * (180 / kPi);
    if (const auto external = own(model.external)) {
      if (external->force) out.force = keys_from(state.time, *external->force, 1);
      if (external->torque) out.torque = keys_from(state.time, *external->torque, 1);
    }
    if (const auto look = looks.find(model.name[i]); look != looks.end()) {
      if (look->second.color) out.color = spec::Color{*look->second.color};
      if (look->second.opacity != 1 || look->second.checker)
        out.material = {look->second.opacity, look->second.checker};
    }
  }
  OrderedJson json = json_of_entry(out);
  json["shape"] = std::move(shape);
  return json;
}

// A name for each joint: those that have none get the first free "joint k".
std::vector<std::string> joint_names(const Model& model) {
  std::unordered_set<std::string> used;
  for (const Joint& joint : model.joints) used.insert(joint.name);
  std::vector<std::string> names;
  std::size_t next = 0;
  for (const Joint& joint : model.joints) {
    names.push_back(joint.name);
    while (names.back().empty()) {
      std::string made_up = fmt::format("joint {}", next++);
      if (used.insert(made_up).second) names.back() = std::move(made_up);
    }
  }
  return names;
}

OrderedJson json_of_memory(const ContactMemory& contact) {
  return json_of_entry(FrictionAnchor{{contact.pair >> 32, contact.pair & 0xffffffffu},
                                      contact.feature,
                                      contact.stretch,
                                      contact.sliding,
                                      contact.recovers,
                                      contact.restless});
}

// "key": [ … ] with one entry a line.
template <class EntryOf>
std::string list(const char* key, std::size_t count, const EntryOf& entry_of) {
  std::string out = fmt::format(",\n  \"{}\": [", key);
  for (std::size_t k = 0; k < count; ++k) {
    out += k == 0 ? "\n    " : ",\n    ";
    out += entry_of(k).dump();
  }
  return out + (count == 0 ? "]" : "\n  ]");
}

void check_loads(const std::string& text, ParameterTable table) {
  try {
    parse_scene(text, "the scene as it would be saved", {}, {}, table);
  } catch (const Error& error) {
    throw Error(error.kind(), std::string("not saved: ") + error.what());
  }
}

}  // namespace

std::string scene_to_json(const Model& model, const State& state, const Params& params,
                          const BondLaw& joint_law, const std::string& name,
                          const std::optional<CameraDesc>& camera, std::optional<double> duration,
                          ParameterTable table, const BodyLooks& looks) {
  std::string out = fmt::format("{{\n  \"format\": \"pabd-scene\",\n  \"version\": 1,\n  \"name\": {}",
                                OrderedJson(name).dump());
  const OrderedJson tunable = OrderedJson::parse(params_json(params, table));
  for (const auto& [key, value] : tunable.items()) out += fmt::format(",\n  \"{}\": {}", key, value.dump());
  out += fmt::format(",\n  \"joints_default\": {}", json_of_entry(entry_of(joint_law)).dump());
  out +=
      list("bodies", model.shape.size(), [&](std::size_t i) { return json_of_body(model, state, looks, i); });
  if (!model.joints.empty()) {
    const std::vector<std::string> names = joint_names(model);
    std::size_t coupling = 0;
    out += list("joints", model.joints.size(), [&](std::size_t k) {
      const Joint& joint = model.joints[k];
      spec::Joint entry = entry_of(model, state, joint, names[k], joint_law);
      if (joint.follows) {
        const double error =
            state.coupling.empty() ? coupling_error(model, state, joint) : state.coupling[coupling++];
        add_coupling(model, state, joint, error, names, entry);
      }
      return json_of_entry(entry);
    });
  }
  if (const OrderedJson apart = pairs_json(model); !apart.empty())
    out += list("no_collide", apart.size(), [&](std::size_t k) { return apart[k]; });
  if (!state.contacts.empty()) {
    out += list("friction_anchors", state.contacts.size(),
                [&](std::size_t k) { return json_of_memory(state.contacts[k]); });
  }
  if (!state.joint_force.empty()) {
    out += list("joint_forces", state.joint_force.size(),
                [&](std::size_t k) { return json_of(state.joint_force[k]); });
  }
  if (camera) {
    out += fmt::format(",\n  \"camera\": {}", json_of_entry(*camera).dump());
  }
  if (duration) out += fmt::format(",\n  \"duration\": {}", OrderedJson(*duration).dump());
  out += "\n}\n";
  check_loads(out, table);
  return out;
}

}  // namespace pabd
