// See keys.h.
#include "sim/scene/keys.h"

#include "sim/body/shape_kind.h"

namespace pabd {

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
                                     KeyTable{"spherical", keys::spherical},
                                     KeyTable{"hinge", keys::hinge},
                                     KeyTable{"slider", keys::slider},
                                     KeyTable{"fixed", keys::fixed},
                                     KeyTable{"distance", keys::distance},
                                     KeyTable{"drive", keys::drive},
                                     KeyTable{"twist", keys::twist},
                                     KeyTable{"friction_anchor", keys::friction_anchor}};
  static const auto kTables = [] {
    std::vector<KeyTable> tables(kFixed.begin(), kFixed.end());
    for (const ShapeKind* kind : shape_kinds()) {
      if (kind->name != tables.back().object) tables.push_back({kind->name, kind->keys});
    }
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
