// SPDX-License-Identifier: MIT
// See joint_schema.h.
#include "sim/scene/joint_schema.h"

#include "sim/joint/joint_traits.h"
#include "sim/potential/barrier.h"
#include "sim/scene/read_joint.h"

namespace pabd {
namespace {

OrderedJson number(const Range& range) {
  return {{"type", "number"}, {"minimum", range.lo}, {"maximum", range.hi}};
}

OrderedJson array_of(int count, const OrderedJson& items) {
  return {{"type", "array"}, {"items", items}, {"minItems", count}, {"maxItems", count}};
}

OrderedJson vector() { return array_of(3, number(kPositionRange)); }

OrderedJson described(OrderedJson schema, const char* description) {
  schema["description"] = description;
  return schema;
}

void add_name_and_bodies(const char* type, OrderedJson& out) {
  out["name"] = {
      {"type", "string"},
      {"minLength", 1},
      {"maxLength", 100},
      {"description", "Unique name. Default: \"joint 3\" for the entry with index 3, counted from 0."}};
  out["type"] = {{"const", type}};
  out["bodies"] = described(array_of(2, {{"type", {"string", "null"}}, {"maxLength", 100}}),
                            "The two bodies i and j by name; null is the world. At least one of them must be "
                            "movable.");
}

void add_points(OrderedJson& out) {
  out["points"] =
      described(array_of(2, vector()), "Point a on i and point b on j at the start in m, world frame.");
  out["length"] = described(number({0, 1e6}), "Distance at rest in m. Default: the distance at the start.");
}

void add_place(int axes, OrderedJson& out) {
  out["anchors"] =
      described(array_of(2, vector()),
                "In place of anchor, with frames: where the anchors on i and j stand at the start "
                "in m, world frame. Scenes that were saved in mid-run have it: there a joint is "
                "not at 0.");
  out["frames"] = described(array_of(2, {{"$ref", "#/$defs/body/properties/orientation"}}),
                            "In place of axis, with anchors: how the frames on i and j stand at the start, "
                            "as orientations of bodies; x is the axis. Angle and offset are 0 where the "
                            "frames coincide.");
  out["anchor"] = described(vector(), "Place of the joint at the start in m, world frame.");
  if (axes > 0)
    out["axis"] =
        described(vector(), "Direction of the axis at the start, world frame, of any length but zero.");
  if (axes > 1)
    out["second_axis"] = described(
        vector(),
        "Direction of the axis on j at the start, square to axis, which is that on i; world frame.");
}

void add_motion(const JointMeasure& measure, OrderedJson& out) {
  const bool angle = measure.of == JointMeasure::Of::angle;
  out["limits"] = described(
      array_of(2, number(angle ? kAngleRange : kPositionRange)),
      angle ? "Lowest and highest angle in degrees; 0, or start, lies between. Not together with drive."
            : "Lowest and highest offset in m; 0, or start, lies between. Not together with drive.");
  out["drive"] = {{"$ref", "#/$defs/drive"},
                  {"description", angle ? "Angle in degrees; may go round many times." : "Offset in m."}};
  out["start"] = described(
      number(angle ? kAngleRange : kPositionRange),
      angle ? "Angle in degrees at which the joint starts. Bodies, anchors and axes are told at 0; what "
              "hangs on the far side is turned with it. Limits include it in place of 0."
            : "Offset in m at which the joint starts. Bodies, anchors and axes are told at 0; what "
              "hangs on the far side is moved with it. Limits include it in place of 0.");
  out["motor"] = {{"$ref", angle ? "#/$defs/motor" : "#/$defs/linear_motor"},
                  {"description", "What moves j against i. Not together with drive."}};
  out["friction"] =
      described(number({0, 1e12}), angle ? "Dry friction in N m: holds up to so much, and brakes with it."
                                         : "Dry friction in N: holds up to so much, and brakes with it.");
  out["spring"] = {{"$ref", angle ? "#/$defs/spring" : "#/$defs/linear_spring"},
                   {"description", "What pulls j back. Not together with drive."}};
  out["follows"] = {{"$ref", "#/$defs/follows"},
                    {"description", "The joint that it goes along with. Not together with drive."}};
}

void add_damping(const JointTraits& traits, OrderedJson& out) {
  out["damping"] = described(number({0, 1e12}), acts_by_torque(traits)
                                                    ? "Viscous damping in N m s/rad. Not together with drive."
                                                    : "Viscous damping in N s/m. Not together with drive.");
}

void add_twist(Twist fallback, OrderedJson& out) {
  out["twist"] = {{"anyOf", {{{"enum", {"free", "locked"}}}, {{"$ref", "#/$defs/twist"}}}},
                  {"default", fallback == Twist::free ? "free" : "locked"},
                  {"description", "Whether j may turn about the axis."}};
}

void add_lead(OrderedJson& out) {
  out["lead"] = described(number({-1e6, 1e6}),
                          "Of a screw: how far j moves along the axis in a turn, in m; below 0, left-handed. "
                          "Not together with follows or drive.");
}

void add_turn(OrderedJson& out) {
  out["drive"] = {{"$ref", "#/$defs/drive"},
                  {"description",
                   "Rotation vector [rx, ry, rz] of j against i in degrees, about axes that are the world's "
                   "at the start and turn with i."}};
  out["axes"] = {{"enum", {"x", "y", "z", "xy", "xz", "yz", "xyz"}},
                 {"default", "xyz"},
                 {"description",
                  "Along which of those axes points of j are held by the drive: one leaves j free to turn "
                  "about it, two or three hold it entirely."}};
}

void add_arms(OrderedJson& out) {
  out["arm"] =
      described(number(kSizeRange),
                "Distance in m of the points beside the anchor that hold the rotation. Default: half "
                "the bounding radius of the smaller body, of a slider or cylindrical joint at least as far "
                "as the centre of mass of the body that hangs on it.");
  out["symmetric"] = {{"type", "boolean"},
                      {"default", true},
                      {"description",
                       "true: points on both sides of the anchor for every rotation that is held; false: on "
                       "one side only, which moves bodies asymmetrically."}};
}

void add_law(OrderedJson& out) {
  out["potential"] = {{"enum", {"soft", "hard"}},
                      {"description", "Potential of the joint's bonds. Default: that of joints_default."}};
  out["kappa"] = {{"anyOf", {{{"const", "auto"}}, number({1e-12, 1e18})}},
                  {"description",
                   "Stiffness in N/m (soft) or J (hard). Default: that of joints_default, or auto where the "
                   "potential is another."}};
  out["N"] = {{"type", "integer"},
              {"minimum", 2},
              {"maximum", kMaxOrder},
              {"description", "Highest order of the hard potential. Default: that of joints_default."}};
  out["d_hat"] = described(number({1e-9, 1e3}),
                           "Length scale of the hard potential in m. Default: that of joints_default.");
  out["collide"] = {{"type", "boolean"},
                    {"default", false},
                    {"description", "true: the two bodies also collide with each other."}};
}

}  // namespace

OrderedJson joint_schema(JointType type) {
  const JointTraits& traits = traits_of(type);
  OrderedJson properties = OrderedJson::object();
  add_name_and_bodies(to_string(type), properties);
  if (traits.points) {
    add_points(properties);
  } else {
    add_place(traits.axes, properties);
  }
  if (const JointMeasure* moved = moved_measure(traits)) add_motion(*moved, properties);
  if (measure_with(traits, &Joint::twist_limits)) add_twist(traits.twist, properties);
  if (turns_freely(traits)) add_lead(properties);
  if (traits.turn) add_turn(properties);
  if (may_be_damped(traits)) add_damping(traits, properties);
  if (!traits.points) add_arms(properties);
  add_law(properties);
  OrderedJson out{{"type", "object"},
                  {"description", traits.help},
                  {"additionalProperties", false},
                  {"properties", properties},
                  {"required", {"type", "bodies"}}};
  if (traits.points) {
    out["required"].push_back("points");
    return out;
  }
  OrderedJson place = OrderedJson::array({"anchor"});
  if (traits.axes > 0) place.push_back("axis");
  if (traits.axes > 1) place.push_back("second_axis");
  out["oneOf"] = {{{"required", place}}, {{"required", {"anchors", "frames"}}}};
  return out;
}

OrderedJson joint_schema_list() {
  OrderedJson list = OrderedJson::array();
  for (const JointType type : kJointTypes)
    list.push_back({{"$ref", std::string("#/$defs/") + to_string(type)}});
  return {{"oneOf", list}};
}

}  // namespace pabd
