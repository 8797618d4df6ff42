// SPDX-License-Identifier: MIT
// See write_scene.h.
#include "sim/scene/write_scene.h"

#include <fmt/format.h>

#include <unordered_set>

#include "sim/base/error.h"
#include "sim/scene/read_look.h"
#include "sim/scene/text.h"
#include "sim/scene/tuning.h"
#include "sim/scene/write_joint.h"

namespace pabd {
namespace {

OrderedJson json_of_body(const Model& model, const State& state, std::size_t i) {
  OrderedJson out{{"name", model.name[i]}, {"shape", json_of(model.shape[i])}};
  if (out["shape"].is_null()) {
    throw Error(ErrorKind::bad_input,
                fmt::format("the shape of {} comes from a mesh file, which cannot be written into a scene; "
                            "remove the body, or save only the parameters",
                            in_quotes(model.name[i])));
  }
  if (is_plane(model.shape[i])) return out;
  if (model.fixed[i]) {
    out["fixed"] = true;
  } else {
    out["mass"] = model.mass[i];
  }
  out["position"] = json_of(state.c[i]);
  if (state.R[i] != Mat3::Identity()) out["orientation"] = json_of_rotation(state.R[i]);
  if (!state.v[i].isZero(0)) out["velocity"] = json_of(state.v[i]);
  if (!state.omega[i].isZero(0)) out["angular_velocity"] = json_of(Vec3(state.omega[i] * (180 / kPi)));
  return out;
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
  OrderedJson out{{"bodies", OrderedJson::array({contact.pair >> 32, contact.pair & 0xffffffffu})},
                  {"feature", contact.feature},
                  {"stretch", json_of(contact.stretch)}};
  if (contact.sliding) out["sliding"] = true;
  if (contact.restless) out["restless"] = true;
  if (contact.recovers) out["recovers"] = true;
  return out;
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
  OrderedJson law = OrderedJson::object();
  add_law(joint_law, law);
  out += fmt::format(",\n  \"joints_default\": {}", law.dump());
  out += list("bodies", model.shape.size(), [&](std::size_t i) {
    OrderedJson body = json_of_body(model, state, i);
    if (const auto look = looks.find(model.name[i]); look != looks.end()) add_look(look->second, body);
    return body;
  });
  if (!model.joints.empty()) {
    const std::vector<std::string> names = joint_names(model);
    out += list("joints", model.joints.size(), [&](std::size_t k) {
      return json_of_joint(model, state, model.joints[k], names[k], joint_law);
    });
  }
  if (!state.contacts.empty()) {
    out += list("friction_anchors", state.contacts.size(),
                [&](std::size_t k) { return json_of_memory(state.contacts[k]); });
  }
  if (!state.joint_force.empty()) {
    out += list("joint_forces", state.joint_force.size(),
                [&](std::size_t k) { return json_of(state.joint_force[k]); });
  }
  if (camera) {
    const OrderedJson view{
        {"eye", json_of(camera->eye)}, {"target", json_of(camera->target)}, {"fov", camera->fov}};
    out += fmt::format(",\n  \"camera\": {}", view.dump());
  }
  if (duration) out += fmt::format(",\n  \"duration\": {}", OrderedJson(*duration).dump());
  out += "\n}\n";
  check_loads(out, table);
  return out;
}

}  // namespace pabd
