// SPDX-License-Identifier: MIT
// See builder_json.h. One line a key; what is empty is left out.
#include "sim/scene/builder_json.h"

#include "sim/joint/joint_traits.h"

namespace pabd {
namespace {

Json value_of(double x) { return x; }
Json value_of(bool x) { return x; }
Json value_of(int x) { return x; }
Json value_of(std::int64_t x) { return x; }
Json value_of(const Vec3& v) { return Json::array({v.x(), v.y(), v.z()}); }
Json value_of(const std::array<double, 4>& q) { return q; }
Json value_of(const spec::AxisAngle& turn) { return {{"axis", value_of(turn.axis)}, {"angle", turn.angle}}; }
Json value_of(const spec::Euler& turn) { return {{"euler", value_of(turn.angles)}, {"order", turn.order}}; }
Json value_of(const spec::Orientation& orientation) {
  return std::visit([](const auto& way) { return value_of(way); }, orientation);
}
Json value_of(const SurfaceFriction& friction) {
  Json out = {{"static", friction.mu_static}, {"dynamic", friction.mu_dynamic}};
  if (friction.torsional > 0) out["torsional"] = friction.torsional;
  if (friction.rolling > 0) out["rolling"] = friction.rolling;
  return out;
}
Json value_of(const spec::BodyOrGroup& side) {
  const auto* group = std::get_if<spec::Group>(&side);
  if (!group) return std::get<std::string>(side);
  return {{"group", group->name}};
}
Json value_of(const spec::Limits& limits) { return Json::array({limits.first, limits.second}); }
Json value_of(JointType type) { return to_string(type); }
Json value_of(BondPotential potential) { return potential == BondPotential::soft ? "soft" : "hard"; }

template <class Value>
Json value_of(const Keyed<Value>& profile) {
  Json keys = Json::array();
  for (const auto& [time, value] : profile.keys) keys.push_back(Json::array({time, value_of(value)}));
  return {{"keys", keys}};
}

template <class T>
void put(Json& out, const char* key, const std::optional<T>& value) {
  if (value) out[key] = value_of(*value);
}
void put(Json& out, const char* key, const std::string& text) {
  if (!text.empty()) out[key] = text;
}

void put_law(Json& out, const spec::Law& law) {
  put(out, "potential", law.potential);
  put(out, "kappa", law.kappa);
  if (law.kappa == kAutoKappa) out["kappa"] = "auto";
  put(out, "N", law.N);
  put(out, "d_hat", law.d_hat);
}

// What several entries have.
template <class Entry>
Json with_mass(const Entry& entry) {
  Json out = Json::object();
  put(out, "name", entry.name);
  put(out, "mass", entry.mass);
  put(out, "density", entry.density);
  put(out, "position", entry.position);
  return out;
}

template <class Entry>
void put_touch(Json& out, const Entry& entry) {
  put(out, "friction", entry.friction);
  put(out, "restitution", entry.restitution);
  if (!entry.groups.empty()) out["group"] = entry.groups;
}

template <class Entry>
Json with_size(const Entry& entry) {
  Json out = with_mass(entry);
  put_touch(out, entry);
  put(out, "size", entry.size);
  return out;
}

Json of_bricks(const spec::Bricks& bricks) {
  Json out = with_size(bricks);
  put(out, "gap", bricks.gap);
  return out;
}

Json end_of(const std::string& body) { return body.empty() ? Json() : Json(body); }

void put_motor(Json& out, const spec::Joint& joint) {
  if (!joint.motor) return;
  const bool turns = acts_by_torque(traits_of(joint.type));
  Json motor = Json::object();
  put(motor, turns ? "torque" : "force", joint.motor->force);
  put(motor, "speed", joint.motor->speed);
  put(motor, turns ? "max_torque" : "max_force", joint.motor->most);
  put(motor, "gain", joint.motor->gain);
  out["motor"] = std::move(motor);
}

void put_spring(Json& out, const spec::Joint& joint) {
  if (!joint.spring) return;
  if (joint.spring->table.empty()) {
    out["spring"] = {{"stiffness", joint.spring->stiffness}};
  } else {
    Json table = Json::array();
    for (const auto& [x, force] : joint.spring->table) table.push_back({x, force});
    out["spring"] = {{"table", std::move(table)}};
  }
  put(out["spring"], "rest", joint.spring->rest);
}

void put_twist(Json& out, const spec::Joint& joint) {
  if (joint.twist == Twist::free) out["twist"] = "free";
  if (joint.twist == Twist::locked) out["twist"] = "locked";
  if (joint.twist == Twist::limited) out["twist"] = Json::object();
  if (joint.twist_limits) out["twist"] = {{"limits", value_of(*joint.twist_limits)}};
}

}  // namespace

Json json_of(const spec::Law& law) {
  Json out = Json::object();
  put_law(out, law);
  return out;
}

Json json_of(const spec::Mesh& mesh) {
  const Json file = mesh.files.size() == 1 ? Json(mesh.files[0]) : Json(mesh.files);
  return {{"type", "mesh"}, {"file", file}, {"scale", mesh.scale}};
}

Json json_of(const spec::Body& body) {
  Json out = with_mass(body);
  if (body.fixed) out["fixed"] = true;
  put(out, "orientation", body.orientation);
  put(out, "center_of_mass", body.center_of_mass);
  put(out, "velocity", body.velocity);
  put(out, "angular_velocity", body.angular_velocity);
  put(out, "surface_velocity", body.surface_velocity);
  put(out, "force", body.force);
  put(out, "torque", body.torque);
  put_touch(out, body);
  return out;
}

Json json_of(const spec::Joint& joint) {
  Json out{{"type", value_of(joint.type)}, {"bodies", Json::array({end_of(joint.i), end_of(joint.j)})}};
  put(out, "name", joint.name);
  put(out, "anchor", joint.anchor);
  put(out, "axis", joint.axis);
  for (const Vec3& point : joint.points) out["points"].push_back(value_of(point));
  put(out, "length", joint.length);
  put(out, "arm", joint.arm);
  put(out, "symmetric", joint.symmetric);
  put(out, "limits", joint.limits);
  put(out, "drive", joint.drive);
  put(out, "drive", joint.turn);
  put(out, "axes", joint.axes);
  put(out, "start", joint.start);
  put_motor(out, joint);
  put(out, "damping", joint.damping);
  put(out, "friction", joint.friction);
  put_spring(out, joint);
  if (joint.follows) {
    out["follows"] = {{"joint", joint.follows->joint}, {"ratio", joint.follows->ratio}};
    put(out["follows"], "offset", joint.follows->offset);
  }
  put(out, "lead", joint.lead);
  put_twist(out, joint);
  put_law(out, joint.law);
  if (joint.collide) out["collide"] = true;
  return out;
}

Json json_of(const spec::NoCollide& pair) { return Json::array({value_of(pair.i), value_of(pair.j)}); }

Json json_of(const spec::Include& include) {
  Json out{{"scene", include.scene}};
  put(out, "prefix", include.prefix);
  put(out, "position", include.position);
  put(out, "orientation", include.orientation);
  return out;
}

Json json_of(const spec::Stack& stack) {
  Json out = of_bricks(stack.bricks);
  out["count"] = stack.count;
  if (!stack.masses.empty()) out["masses"] = stack.masses;
  put(out, "rotate", stack.rotate);
  return out;
}

Json json_of(const spec::Wall& wall) {
  Json out = of_bricks(wall.bricks);
  out["columns"] = wall.columns;
  out["rows"] = wall.rows;
  put(out, "spacing", wall.spacing);
  put(out, "half_blocks", wall.half_blocks);
  return out;
}

Json json_of(const spec::Pyramid& pyramid) {
  Json out = of_bricks(pyramid.bricks);
  out["base"] = pyramid.base;
  put(out, "spacing", pyramid.spacing);
  return out;
}

Json json_of(const spec::Pile& pile) {
  Json out = with_size(pile);
  out["count"] = pile.count;
  put(out, "shape", pile.shape);
  put(out, "vary", pile.vary);
  put(out, "columns", pile.columns);
  put(out, "spacing", pile.spacing);
  put(out, "seed", pile.seed);
  return out;
}

Json json_of(const spec::Chain& chain) {
  Json out = with_size(chain);
  out["links"] = chain.links;
  put(out, "shape", chain.shape);
  put(out, "gap", chain.gap);
  put(out, "direction", chain.direction);
  put(out, "joint", chain.joint);
  put(out, "axis", chain.axis);
  put(out, "fixed", chain.fixed);
  put(out, "end_mass", chain.end_mass);
  put(out, "collide", chain.collide);
  return out;
}

Json json_of(const spec::Net& net) {
  Json out = with_size(net);
  out["rows"] = net.rows;
  out["columns"] = net.columns;
  put(out, "shape", net.shape);
  put(out, "gap", net.gap);
  put(out, "upright", net.upright);
  put(out, "joint", net.joint);
  put(out, "fixed", net.fixed);
  put(out, "collide", net.collide);
  return out;
}

Json json_of(const CameraDesc& camera) {
  return {{"eye", value_of(camera.eye)}, {"target", value_of(camera.target)}, {"fov", camera.fov}};
}

}  // namespace pabd
