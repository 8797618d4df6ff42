// SPDX-License-Identifier: MIT
// See scene_schema.h.
#include "sim/scene/scene_schema.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "sim/body/collision_groups.h"
#include "sim/body/shape_kind.h"
#include "sim/joint/joint_traits.h"
#include "sim/scene/fields.h"
#include "sim/scene/generators.h"
#include "sim/scene/include_library.h"
#include "sim/scene/parameter_docs.h"
#include "sim/scene/read_memory.h"

namespace pabd {
namespace {

OrderedJson number(const Range& range, const char* type = "number") {
  OrderedJson out{{"type", type}};
  if (std::isfinite(range.lo)) out[range.open ? "exclusiveMinimum" : "minimum"] = range.lo;
  if (std::isfinite(range.hi)) out[range.open ? "exclusiveMaximum" : "maximum"] = range.hi;
  return out;
}

OrderedJson array_of(const OrderedJson& items, std::size_t least, std::size_t most) {
  OrderedJson out{{"type", "array"}, {"items", items}};
  if (least > 0) out["minItems"] = least;
  if (most > 0) out["maxItems"] = most;
  return out;
}

OrderedJson name(std::size_t longest = 100) {
  return {{"type", "string"}, {"minLength", 1}, {"maxLength", longest}};
}

OrderedJson reference(std::string_view definition) {
  return {{"$ref", fmt::format("#/$defs/{}", definition)}};
}

OrderedJson any_of(std::initializer_list<OrderedJson> all) {
  return {{"anyOf", OrderedJson(OrderedJson::array_t(all))}};
}

OrderedJson required(std::string_view key) { return {{"required", OrderedJson::array({key})}}; }

OrderedJson enumeration(std::span<const std::string_view> words) {
  OrderedJson out = OrderedJson::array();
  for (const std::string_view word : words) out.push_back(word);
  return {{"enum", out}};
}

std::string sentences(const Field& field) {
  std::string out = fmt::format("{}.", field.help);
  if (!field.range.unit.empty() && !field.may_be_auto) out += fmt::format(" Unit: {}.", field.range.unit);
  if (!field.otherwise.empty()) out += fmt::format(" Default: {}.", field.otherwise);
  return out;
}

// Collects the properties of an entry.
class SchemaMaker {
 public:
  template <class Member, class... Default>
  void operator()(const Field& field, const Member&, const Default&... fallback) {
    using Value = typename OfOptional<Member>::type;
    if (!field.of_type) return;
    OrderedJson& out = put(field, form(field, Value{}));
    if (field.otherwise.empty()) (set_default(out, Value{}, fallback), ...);
  }
  void operator()(const Field& field, const std::string&, const std::string&) {
    put(field, array_of({{"type", OrderedJson::array({"string", "null"})}, {"maxLength", 100}}, 2, 2));
  }
  void operator()(const Field& field, const std::optional<Twist>&, const std::optional<spec::Limits>&,
                  Twist fallback) {
    if (!field.of_type) return;
    const OrderedJson limited{{"type", "object"},
                              {"description", "A twist within limits."},
                              {"additionalProperties", false},
                              {"properties",
                               {{"limits",
                                 {{"type", "array"},
                                  {"items", number(field.range)},
                                  {"minItems", 2},
                                  {"maxItems", 2},
                                  {"description", "Lowest and highest angle in degrees; 0 lies between."}}}}},
                              {"required", OrderedJson::array({"limits"})}};
    OrderedJson& out = put(field, any_of({{{"enum", OrderedJson::array({"free", "locked"})}}, limited}));
    out["default"] = fallback == Twist::free ? "free" : "locked";
  }
  void either(std::string_view a, std::string_view b) {
    one_of_ = OrderedJson::array({required(a), required(b)});
  }
  void not_both(std::string_view a, std::string_view b) { not_ = {{"required", OrderedJson::array({a, b})}}; }
  void one_of(OrderedJson alternatives) { one_of_ = std::move(alternatives); }
  void constant(const char* key, std::string_view value) {
    properties_[key] = {{"const", value}};
    required_.push_back(key);
  }
  OrderedJson& put(const Field& field, OrderedJson schema) {
    if (field.required) required_.push_back(field.key);
    schema["description"] = sentences(field);
    return properties_[std::string(field.key)] = std::move(schema);
  }

  void adopt(const std::string& key, const OrderedJson& schema) { properties_[key] = schema; }

  OrderedJson object(std::string_view help) const {
    OrderedJson out{{"type", "object"},
                    {"description", fmt::format("{}.", help)},
                    {"additionalProperties", false},
                    {"properties", properties_}};
    if (!required_.empty()) out["required"] = required_;
    if (!one_of_.is_null()) out["oneOf"] = one_of_;
    if (!not_.is_null()) out["not"] = not_;
    return out;
  }

 private:
  template <class Value, class Default>
  static void set_default(OrderedJson& out, const Value&, const Default& fallback) {
    if constexpr (!ComputedDefault<Default>) {
      const bool is_auto = std::is_same_v<Value, double> && out.contains("anyOf");
      out["default"] = is_auto ? OrderedJson("auto") : json_of(fallback);
    }
  }

  OrderedJson form(const Field& field, double) const {
    return field.may_be_auto ? any_of({{{"const", "auto"}}, number(field.range)}) : number(field.range);
  }
  OrderedJson form(const Field& field, std::int64_t) const {
    return number({std::floor(field.range.lo), std::floor(field.range.hi)}, "integer");
  }
  OrderedJson form(const Field& field, int) const { return form(field, std::int64_t{}); }
  OrderedJson form(const Field&, bool) const { return {{"type", "boolean"}}; }
  OrderedJson form(const Field& field, const std::string&) const {
    if (!field.words.empty()) return enumeration(field.words);
    return name(field.file.empty() ? 100 : 1000);
  }
  OrderedJson form(const Field& field, const Vec3&) const { return array_of(number(field.range), 3, 3); }
  OrderedJson form(const Field& field, const spec::Color&) const {
    return any_of({{{"type", "string"}, {"pattern", "^#[0-9a-fA-F]{6}$"}}, form(field, Vec3())});
  }
  OrderedJson form(const Field& field, const std::array<double, 6>&) const {
    return array_of(number(field.range), 6, 6);
  }
  OrderedJson form(const Field& field, const spec::Limits&) const {
    return array_of(number(field.range), 2, 2);
  }
  OrderedJson form(const Field&, const std::pair<std::int64_t, std::int64_t>&) const {
    return array_of({{"type", "integer"}, {"minimum", 0}}, 2, 2);
  }
  OrderedJson form(const Field&, const SurfaceFriction&) const {
    return any_of({number({0, 100}),
                   {{"allOf", OrderedJson::array({reference("friction")})},
                    {"required", OrderedJson::array({"static"})}}});
  }
  OrderedJson form(const Field&, const spec::Orientation&) const { return reference("orientation"); }
  OrderedJson form(const Field& field, JointType) const { return enumeration(field.words); }
  OrderedJson form(const Field&, BondPotential) const {
    return {{"enum", OrderedJson::array({"soft", "hard"})}};
  }
  template <class Value>
  OrderedJson form(const Field& field, const Keyed<Value>&) const {
    const OrderedJson value = form(field, Value{});
    OrderedJson stays = value;
    stays["description"] = "The value at all times.";
    const OrderedJson pair{{"type", "array"},
                           {"prefixItems", OrderedJson::array({number({0, 1e9}), value})},
                           {"minItems", 2},
                           {"maxItems", 2}};
    OrderedJson keys = array_of(pair, 1, 0);
    keys["description"] =
        "Pairs [time in s, value] with rising times, with straight lines between them; before the first and "
        "after the last the value stays.";
    const OrderedJson object{{"type", "object"},
                             {"additionalProperties", false},
                             {"properties", {{"value", stays}, {"keys", keys}}},
                             {"oneOf", OrderedJson::array({required("value"), required("keys")})}};
    return field.or_constant ? any_of({value, object}) : object;
  }
  OrderedJson form(const Field& field, const std::vector<std::string>&) const {
    const OrderedJson one = form(field, std::string());
    OrderedJson several = array_of(one, 1, field.file.empty() ? kMostGroups : kMostParts);
    if (field.file.empty()) several["uniqueItems"] = true;
    return any_of({one, several});
  }
  OrderedJson form(const Field& field, const std::vector<double>&) const {
    return array_of(number(field.range), 1, 0);
  }
  OrderedJson form(const Field& field, const std::vector<Vec3>&) const {
    return array_of(form(field, Vec3()), 2, 2);
  }
  OrderedJson form(const Field& field, const std::vector<std::vector<Vec3>>&) const {
    return array_of(array_of(form(field, Vec3()), 4, 4096), 1, kMostParts);
  }
  OrderedJson form(const Field&, const std::vector<spec::Orientation>&) const {
    return array_of(reference("orientation"), 2, 2);
  }
  OrderedJson form(const Field&, const std::vector<std::pair<double, double>>&) const {
    return array_of(array_of(number({}), 2, 2), 2, 10000);
  }
  OrderedJson form(const Field&, const std::variant<Shape, spec::Mesh>&) const {
    OrderedJson kinds = OrderedJson::array();
    for (const ShapeKind* kind : shape_kinds())
      if (kinds.empty() || kinds.back() != reference(kind->name)) kinds.push_back(reference(kind->name));
    return {{"oneOf", kinds}};
  }
  template <Entry T>
  OrderedJson form(const Field& field, const T&) const {
    if constexpr (requires { T::object; }) return {{"allOf", OrderedJson::array({reference(T::object)})}};
    SchemaMaker inner;
    T entry{};
    visit_fields(entry, inner, field.turns);
    return inner.object(T::help);
  }

  OrderedJson properties_ = OrderedJson::object(), required_ = OrderedJson::array(), one_of_, not_;
};

// What is said of shapes that are given by their sizes, beside the table of sim/body.
struct ShapeWords {
  std::string_view help, sizes[2];
};
const std::map<std::string_view, ShapeWords> kShapeWords{
    {"box", {"A box", {"Edge lengths along x, y and z"}}},
    {"sphere", {"A ball", {"Radius"}}},
    {"capsule",
     {"A cylinder along y with a half ball at each end",
      {"Radius", "Length of the straight part, without the caps"}}},
    {"cylinder", {"A cylinder along y. Contacts see a prism of 32 sides", {"Radius", "Height"}}},
    {"cone",
     {"A cone along y, its base below: the centre of mass is a quarter up. Contacts see a pyramid of 32 "
      "sides",
      {"Radius of the base", "Height of the tip above the base"}}}};

class SceneSchema {
 public:
  OrderedJson make() {
    OrderedJson parameters = OrderedJson::parse(parameter_schema());
    definitions_ = parameters["$defs"];
    SchemaMaker scene;
    for (const Field& field : kSceneKeys) {
      scene.put(field, form_of_scene_key(field));
      if (field.key != "description") continue;
      for (const auto& [key, schema] : parameters["properties"].items()) scene.adopt(key, schema);
    }
    add_definitions();
    OrderedJson out{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "pabd scene"}};
    out.update(scene.object(
        "A scene of pabd. SI units, y up, right-handed; angles in degrees; quaternions [w, x, y, z]"));
    out["$defs"] = definitions_;
    return out;
  }

 private:
  OrderedJson form_of_scene_key(const Field& field) {
    const std::string_view key = field.key;
    if (key == "format") return {{"const", "pabd-scene"}};
    if (key == "version") return {{"const", 1}};
    if (key == "name") return name();
    if (key == "duration") return number(field.range);
    if (key == "bodies") return array_of(reference("body"), 0, kMostBodies);
    if (key == "joints") return array_of(one_of(kJointTypes), 0, kMostJoints);
    if (key == "includes") return array_of(reference("include"), 0, kMostIncludes);
    if (key == "friction_anchors") return array_of(reference("friction_anchor"), 0, 0);
    if (key == "joint_forces") return array_of(array_of(number({}), 3, 3), 0, 0);
    if (key == "joints_default" || key == "camera") return reference(key);
    if (key == "no_collide")
      return array_of(array_of({{"oneOf", OrderedJson::array({name(), reference("group")})}}, 2, 2), 0,
                      kMostJoints);
    if (key == "generate") {
      OrderedJson types = OrderedJson::array();
      for_each_generator([&](const auto& entry) { types.push_back(reference(entry.type)); });
      return array_of({{"oneOf", types}}, 0, 0);
    }
    return {{"type", "string"}, {"maxLength", 1000}};
  }

  static OrderedJson one_of(std::span<const JointType> types) {
    OrderedJson out = OrderedJson::array();
    for (const JointType type : types) out.push_back(reference(to_string(type)));
    return {{"oneOf", out}};
  }

  template <class T>
  void define(T entry, bool turns = false) {
    SchemaMaker maker;
    visit_fields(entry, maker, turns);
    definitions_[T::object] = maker.object(T::help);
  }

  void add_definitions() {
    define(spec::Law{});
    define(CameraDesc{});
    define(spec::Material{});
    define(spec::Body{});
    for (const ShapeKind* kind : shape_kinds()) add_shape(*kind);
    for_each_generator([this](auto entry) {
      SchemaMaker maker;
      maker.constant("type", entry.type);
      entry.fields(maker);
      definitions_[entry.type] = maker.object(entry.help);
    });
    for (const JointType type : kJointTypes) add_joint(type);
    definitions_["orientation"] = {
        {"description", fmt::format("{}.", spec::kOrientation.help)},
        {"oneOf",
         OrderedJson::array({array_of(number({}), 4, 4), reference("axis_angle"), reference("euler")})},
        {"default", {1, 0, 0, 0}}};
    define(spec::AxisAngle{});
    define(spec::Euler{});
    define(spec::Group{});
    define(spec::Include{});
    define(FrictionAnchor{});
  }

  void add_shape(const ShapeKind& kind) {
    SchemaMaker maker;
    maker.constant("type", kind.name);
    const auto words = kShapeWords.find(kind.name);
    std::string_view help = words == kShapeWords.end() ? kind.name : words->second.help;
    for (std::size_t k = 0; k < kind.sizes.size(); ++k) {
      const ShapeSize& size = kind.sizes[k];
      const Field field =
          need(size.key, words == kShapeWords.end() ? size.help : words->second.sizes[k], kSizeRange);
      if (size.count == 1) {
        maker(field, 0.0);
      } else {
        maker(field, Vec3());
      }
    }
    if (kind.name == "plane") {
      help = "Everything below a plane; always fixed";
      spec::PlaneKeys{}.fields(maker);
    } else if (kind.name == "mesh") {
      help = spec::Mesh::help;
      spec::Mesh{}.fields(maker);
      OrderedJson parts = required("parts");
      parts["not"] = required("scale");
      maker.one_of(OrderedJson::array({required("file"), parts}));
    }
    definitions_[std::string(kind.name)] = maker.object(help);
  }

  void add_joint(JointType type) {
    SchemaMaker maker;
    maker.constant("type", to_string(type));
    spec::Joint entry{.type = type};
    entry.fields(maker);
    const JointKeys has = joint_keys(type);
    OrderedJson place = OrderedJson::array({has.points ? "points" : "anchor"});
    if (has.axes > 0) place.push_back("axis");
    if (has.axes > 1) place.push_back("second_axis");
    OrderedJson either = OrderedJson::array({{{"required", place}}});
    if (!has.points) either.push_back({{"required", {"anchors", "frames"}}});
    maker.one_of(either);
    std::string_view help = traits_of(type).help;
    if (help.ends_with('.')) help.remove_suffix(1);
    definitions_[to_string(type)] = maker.object(help);
  }

  OrderedJson definitions_;
};

// JSON with one line for what fits into a line.
std::string printed(const OrderedJson& json, std::size_t indent) {
  constexpr std::size_t kWidth = 110;
  const std::string line = json.dump();
  if (!json.is_structured() || indent + line.size() <= kWidth) return line;
  std::string out(1, json.is_object() ? '{' : '[');
  for (auto item = json.begin(); item != json.end(); ++item) {
    out += (item == json.begin() ? "\n" : ",\n") + std::string(indent + 2, ' ');
    if (json.is_object()) out += OrderedJson(item.key()).dump() + ": ";
    out += printed(*item, indent + 2);
  }
  return out + '\n' + std::string(indent, ' ') + (json.is_object() ? '}' : ']');
}

}  // namespace

std::string scene_schema() { return printed(SceneSchema().make(), 0) + "\n"; }

}  // namespace pabd
