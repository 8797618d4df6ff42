// SPDX-License-Identifier: MIT
// Edits as JSON objects, the form they have in script files. See model_edit.h.
#include <fmt/format.h>

#include "app/session/model_edit.h"
#include "sim/base/error.h"
#include "sim/body/shape_kind.h"
#include "sim/joint/joint_traits.h"
#include "sim/potential/barrier.h"
#include "sim/scene/read_body.h"
#include "sim/scene/read_joint.h"
#include "sim/scene/text.h"
#include "sim/scene/write_values.h"

namespace pabd {
namespace {

using Key = std::string_view;

constexpr std::array kNumberOfBody{Key("do"), Key("body")};
constexpr std::array kNumberOfJoint{Key("do"), Key("joint")};
constexpr std::array kJoint{Key("do"),          Key("name"),   Key("type"),   Key("bodies"),    Key("anchor"),
                            Key("axis"),        Key("points"), Key("length"), Key("potential"), Key("kappa"),
                            Key("second_axis"), Key("N"),      Key("d_hat")};

enum class Kind { add_body, remove_body, add_joint, remove_joint };
constexpr Choice kKinds[] = {{"add_body", static_cast<int>(Kind::add_body)},
                             {"remove_body", static_cast<int>(Kind::remove_body)},
                             {"add_joint", static_cast<int>(Kind::add_joint)},
                             {"remove_joint", static_cast<int>(Kind::remove_joint)}};
constexpr Choice kPotentials[] = {{"soft", static_cast<int>(BondPotential::soft)},
                                  {"hard", static_cast<int>(BondPotential::hard)}};

struct ToJson {
  OrderedJson operator()(const AddBody& body) const {
    OrderedJson out{{"do", "add_body"}};
    if (!body.name.empty()) out["name"] = body.name;
    out["shape"] = json_of(body.shape);
    if (body.fixed) out["fixed"] = true;
    if (body.mass) {
      out["mass"] = *body.mass;
    } else {
      out["density"] = body.density;
    }
    out["position"] = json_of(body.position);
    const Mat3& R = body.orientation;
    if ((R.transpose() * R - Mat3::Identity()).cwiseAbs().maxCoeff() >= 1e-6 || !(R.determinant() > 0))
      throw Error(ErrorKind::bad_input, "orientation: expected a rotation");
    if (body.orientation != Mat3::Identity()) out["orientation"] = json_of_rotation(body.orientation);
    if (!body.velocity.isZero(0)) out["velocity"] = json_of(body.velocity);
    if (!body.omega.isZero(0)) out["angular_velocity"] = json_of(Vec3(body.omega * (180 / kPi)));
    if (body.friction) out["friction"] = json_of(*body.friction);
    if (body.restitution) out["restitution"] = *body.restitution;
    return out;
  }
  OrderedJson operator()(const RemoveBody& edit) const {
    return {{"do", "remove_body"}, {"body", edit.body}};
  }
  OrderedJson operator()(const AddJoint& joint) const {
    OrderedJson out{{"do", "add_joint"}};
    if (!joint.name.empty()) out["name"] = joint.name;
    out["type"] = to_string(joint.type);
    out["bodies"] = OrderedJson::array();
    for (const Index end : {joint.i, joint.j})
      out["bodies"].push_back(end == kWorld ? OrderedJson() : OrderedJson(end));
    const JointTraits& traits = traits_of(joint.type);
    if (traits.points) {
      out["points"] = OrderedJson::array({json_of(joint.anchor), json_of(joint.anchor_j)});
      if (joint.length) out["length"] = *joint.length;
    } else {
      out["anchor"] = json_of(joint.anchor);
    }
    if (traits.axes > 0) out["axis"] = json_of(joint.axis);
    if (traits.axes > 1 && joint.second_axis) out["second_axis"] = json_of(*joint.second_axis);
    if (joint.law) add_law(*joint.law, out);
    return out;
  }
  OrderedJson operator()(const RemoveJoint& edit) const {
    return {{"do", "remove_joint"}, {"joint", edit.joint}};
  }
};

AddBody read_add_body(const Node& node) {
  const auto shape = node.value().find("shape");
  if (shape != node.value().end() && shape->is_object() && shape->contains("type")) {
    for (const ShapeKind* kind : shape_kinds()) {
      if (!kind->make && (*shape)["type"] == kind->name)
        Node(*shape, node, "shape").fail_expected(sized_shapes());
    }
  }
  for (const char* key : {"group", "center_of_mass", "surface_velocity", "force", "torque"})
    if (node.value().contains(key))
      Node(node.value().at(key), node, key).fail("a body that is added has none; remove this key");
  Json body = node.value();
  body.erase("do");
  MeshLibrary none{{}};
  BodySpec spec = read_body(Node(body, node.context()), 0, none);
  AddBody out;
  if (body.contains("name")) out.name = std::move(spec.name);
  out.shape = std::move(spec.shape);
  out.mass = spec.mass.mass;
  out.density = spec.mass.density;
  out.position = spec.c;
  out.orientation = spec.R;
  out.velocity = spec.v;
  out.omega = spec.omega;
  out.fixed = spec.fixed;
  out.friction = spec.touch.friction;
  out.restitution = spec.touch.restitution;
  return out;
}

Index read_end(const Node& node) {
  if (node.value().is_null()) return kWorld;
  if (!node.value().is_number_integer()) node.fail_expected("the number of a body, or null for the world");
  return static_cast<Index>(node.integer(0, kMostBodies - 1));
}

std::optional<BondLaw> read_law(const ObjectReader& in) {
  if (!in.has("kappa")) {
    for (const Key key : {"potential", "N", "d_hat"})
      if (in.has(key)) in.fail_key(key, "says how stiff the joint is only together with \"kappa\"; add it");
    return std::nullopt;
  }
  BondLaw law;
  law.potential =
      static_cast<BondPotential>(in.choice("potential", kPotentials, static_cast<int>(law.potential)));
  law.kappa = in.number("kappa", {1e-12, 1e18, law.potential == BondPotential::soft ? "N/m" : "J"});
  law.N = static_cast<int>(in.integer("N", 2, kMaxOrder, law.N));
  law.d_hat = in.number("d_hat", {1e-9, 1e3, "m"}, law.d_hat);
  return law;
}

void refuse_key(const ObjectReader& in, Key key, JointType type) {
  if (in.has(key)) in.fail_key(key, fmt::format("a {} joint has none; remove this key", to_string(type)));
}

AddJoint read_add_joint(const ObjectReader& in) {
  AddJoint out;
  out.name = in.name("name");
  in.require("type", one_of(joint_words()));
  out.type = kJointTypes[type_of_entry(in, joint_words())];
  const Node ends = in.require("bodies", "two numbers of bodies, null for the world");
  if (ends.array_size() != 2) ends.fail_expected("two numbers of bodies, null for the world");
  out.i = read_end(ends.element(0));
  out.j = read_end(ends.element(1));
  const JointTraits& traits = traits_of(out.type);
  if (traits.points) {
    refuse_key(in, "anchor", out.type);
    const Node points = in.require("points", "two points [a, b]");
    if (points.array_size() != 2) points.fail_expected("two points [a, b]");
    out.anchor = points.element(0).vec3(kPositionRange);
    out.anchor_j = points.element(1).vec3(kPositionRange);
    out.length = in.optional_number("length", {0, 1e6, "m"});
  } else {
    refuse_key(in, "points", out.type);
    refuse_key(in, "length", out.type);
    out.anchor = in.vec3("anchor", kPositionRange);
  }
  if (traits.axes > 0) {
    out.axis = in.require("axis", "the direction of the joint's axis").unit_vector();
  } else {
    refuse_key(in, "axis", out.type);
  }
  if (traits.axes < 2) {
    refuse_key(in, "second_axis", out.type);
  } else if (const auto second = in.find("second_axis")) {
    out.second_axis = second->unit_vector();
  }
  out.law = read_law(in);
  return out;
}

}  // namespace

std::string to_json(const ModelEdit& edit) { return std::visit(ToJson{}, edit).dump(); }

ModelEdit edit_from_json(const std::string& text, const std::string& source) {
  const Json document = parse_document(text, source);
  ReadContext context{source, {}, {}};
  const Node root(document, context);
  if (!document.is_object()) root.fail_expected("an object such as {\"do\": \"remove_body\", \"body\": 3}");
  const auto kind = document.find("do");
  if (kind == document.end())
    fail_at(context, "/do",
            "missing; expected \"add_body\", \"remove_body\", \"add_joint\" or \"remove_joint\"");
  switch (static_cast<Kind>(Node(*kind, root, "do").choice(kKinds))) {
    case Kind::add_body:
      return read_add_body(root);
    case Kind::remove_body:
      return RemoveBody{
          static_cast<Index>(ObjectReader(root, kNumberOfBody).integer("body", 0, kMostBodies - 1))};
    case Kind::add_joint:
      return read_add_joint(ObjectReader(root, kJoint));
    case Kind::remove_joint:
      break;
  }
  return RemoveJoint{
      static_cast<Index>(ObjectReader(root, kNumberOfJoint).integer("joint", 0, kMostJoints - 1))};
}

}  // namespace pabd
