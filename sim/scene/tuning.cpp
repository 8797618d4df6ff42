// See tuning.h. Everything goes through the reader of scene files, which checks it.
#include "sim/scene/tuning.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/error.h"
#include "sim/scene/keys.h"
#include "sim/scene/overrides.h"
#include "sim/scene/read_params.h"
#include "sim/scene/text.h"

namespace pabd {
namespace {

using OrderedJson = nlohmann::ordered_json;

template <class AnyJson>
AnyJson to_json(const Params& params) {
  const ContactParams& contact = params.contact;
  AnyJson kappa = "auto";
  if (contact.kappa) kappa = *contact.kappa;
  return {
      {"gravity", {params.gravity.x(), params.gravity.y(), params.gravity.z()}},
      {"time_step", params.h},
      {"solver",
       {{"method", to_string(params.solver.method)},
        {"iterations", params.solver.iterations},
        {"tolerance", params.solver.tolerance},
        {"relaxation", params.solver.relaxation},
        {"projection", to_string(params.solver.projection)}}},
      {"contact",
       {{"barrier", to_string(contact.barrier)},
        {"N", contact.N},
        {"d_hat", contact.d_hat},
        {"kappa", kappa},
        {"onset", contact.onset},
        {"recovery_speed", contact.recovery_speed},
        {"friction", {{"static", contact.mu_static}, {"dynamic", contact.mu_dynamic}}}}},
  };
}

constexpr std::string_view kSections[] = {"gravity", "time_step", "solver", "contact"};

Params read(const Json& document, ReadContext& context) {
  const Node root(document, context);
  return read_params(ObjectReader(root, kSections));
}

template <class AnyJson>
const AnyJson& at(const AnyJson& document, std::string_view key) {
  const AnyJson* place = &document;
  for (std::size_t from = 0; from <= key.size();) {
    const std::size_t dot = std::min(key.find('.', from), key.size());
    place = &place->at(std::string(key.substr(from, dot - from)));
    from = dot + 1;
  }
  return *place;
}

void put(OrderedJson& document, std::string_view key, const OrderedJson& value) {
  OrderedJson* place = &document;
  for (std::size_t from = 0; from <= key.size();) {
    const std::size_t dot = std::min(key.find('.', from), key.size());
    OrderedJson& next = (*place)[std::string(key.substr(from, dot - from))];
    // "friction": 0.5 stands for both coefficients.
    if (dot < key.size() && next.is_number()) next = {{"static", next}, {"dynamic", next}};
    place = &next;
    from = dot + 1;
  }
  *place = value;
}

void check_key(const std::string& set) {
  const std::string key = set.substr(0, set.find('='));
  const auto& keys = tunable_keys();
  if (key == "contact.friction" || std::find(keys.begin(), keys.end(), key) != keys.end()) return;
  if (key.starts_with("gravity.")) return;
  const std::vector<std::string_view> views(keys.begin(), keys.end());
  throw Error(ExitCode::bad_input,
              fmt::format("{}: no parameter that can be tuned{}", printable(key), did_you_mean(key, views)));
}

}  // namespace

const std::vector<std::string>& tunable_keys() {
  static const std::vector<std::string> keys = {"gravity",
                                                "time_step",
                                                "solver.method",
                                                "solver.iterations",
                                                "solver.tolerance",
                                                "solver.relaxation",
                                                "solver.projection",
                                                "contact.barrier",
                                                "contact.N",
                                                "contact.d_hat",
                                                "contact.kappa",
                                                "contact.onset",
                                                "contact.recovery_speed",
                                                "contact.friction.static",
                                                "contact.friction.dynamic"};
  return keys;
}

Params tuned(const Params& params, const std::vector<std::string>& sets) {
  for (const std::string& set : sets) check_key(set);
  Json document = to_json<Json>(params);
  ReadContext context{"parameters", {}, {}};
  context.overrides = apply_overrides(document, sets, context.source);
  return read(document, context);
}

Params patched(const Params& params, const std::string& patch, const std::string& source) {
  const Json changes = parse_document(patch, source);
  ReadContext context{source, {}, {}};
  const Node root(changes, context);
  if (!changes.is_object())
    root.fail_expected("an object of scene keys, for example {\"contact\": {\"kappa\": 50}}");
  const ObjectReader known(root, kSections);  // refuses other keys at the place where they stand
  if (const auto node = known.find("solver")) ObjectReader(*node, keys::solver);
  if (const auto node = known.find("contact")) ObjectReader(*node, keys::contact);
  Json document = to_json<Json>(params);
  document.merge_patch(changes);
  return read(document, context);
}

std::string tuned_value(const Params& params, std::string_view key) {
  check_key(std::string(key));
  const Json document = to_json<Json>(params);
  const Json& value = at(document, key);
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::vector<std::pair<std::string, std::string>> differences(const Params& from, const Params& to) {
  std::vector<std::pair<std::string, std::string>> out;
  for (const std::string& key : tunable_keys()) {
    std::string value = tuned_value(to, key);
    if (tuned_value(from, key) != value) out.emplace_back(key, std::move(value));
  }
  return out;
}

std::string patch_json(const Params& from, const Params& to) {
  const OrderedJson document = to_json<OrderedJson>(to);
  OrderedJson patch = OrderedJson::object();
  for (const auto& [key, value] : differences(from, to)) put(patch, key, at(document, key));
  return patch.dump(2) + "\n";
}

std::string params_json(const Params& params) { return to_json<OrderedJson>(params).dump(); }

std::string tuned_scene_text(const std::string& scene, const std::string& source,
                             const std::vector<std::string>& overrides, const Params& params) {
  Json checked = parse_document(scene, source);
  OrderedJson document = OrderedJson::parse(scene);
  ReadContext context{source, {}, {}};
  if (!overrides.empty()) {
    context.overrides = apply_overrides(checked, overrides, source);
    document = OrderedJson::parse(checked.dump());
  }
  const Node root(checked, context);
  const OrderedJson values = to_json<OrderedJson>(params);
  for (const auto& [key, value] : differences(read_params(ObjectReader(root, keys::scene)), params)) {
    put(document, key, at(values, key));
  }
  return document.dump(2) + "\n";
}

}  // namespace pabd
