// SPDX-License-Identifier: MIT
// See device_programs.h.
#include "render/device/device_programs.h"

#include <fmt/format.h>

#include "render/device/device_layout.h"
#include "render/device/narrow_parts.h"
#include "render/device/shader_files.h"
#include "sim/potential/barrier.h"
#include "sim/solver/halving.h"
#include "sim/solver/second_order.h"

namespace pabd::device {
namespace {

// Of the bodies in touch, or of the contacts: as many may be left unsolved before all are made again in halves.
constexpr double kShareLeft = 1e-3;
// As kUnsettled, where no step goes on beyond its iterations: a hundredth would halve what twice the sweeps settle.
constexpr double kUnsettledSweeps = 0.5;
// Times the energy of a step: what it may rise by, where sums are of floats.
constexpr double kRiseOfFloats = 1e-4;

constexpr const char* kSingle =
    "#define real float\n#define lane float\n#define real3 vec3\n#define real4 vec4\n#define mat_real3 mat3\n"
    "#define EPSILON real(1.2e-7lf)\n";
constexpr const char* kTwofold =
    "#define real double\n#define lane double\n#define real3 dvec3\n#define real4 dvec4\n#define mat_real3 "
    "dmat3\n"
    "#define EPSILON real(2.2e-16lf)\n";

class Compiler {
 public:
  Compiler(const ComputeFunctions& gl, Precision precision, const ShapeTable& table, bool round,
           const Sharing& sharing = {})
      : gl_(gl) {
    const bool single = precision == Precision::single;
    common_ = std::string(single ? kSingle : kTwofold) + (single ? kWideIsFloat : kWideIsDouble);
    for (const BarrierKind kind : kDeviceBarriers)
      common_ += fmt::format("#define BARRIER_{} {}\n", to_string(kind), static_cast<int>(kind));
    common_ +=
        fmt::format("#define GEOMETRIC_MEAN {}\n#define AVERAGE {}\n#define MIN {}\n#define MAX {}\n",
                    static_cast<int>(FrictionRule::geometric_mean), static_cast<int>(FrictionRule::average),
                    static_cast<int>(FrictionRule::min), static_cast<int>(FrictionRule::max));
    common_ += fmt::format("#define FORM_BOX {}\n#define FORM_CAPSULE {}\n#define FORM_PLANE {}\n",
                           static_cast<int>(kDeviceBox), static_cast<int>(kDeviceCapsule),
                           static_cast<int>(kDevicePlane));
    common_ += fmt::format("#define SHAPES_BINDING {}\n#define HULLS_BINDING {}\n",
                           static_cast<unsigned>(Slot::shapes), static_cast<unsigned>(Slot::hulls));
    common_ += fmt::format("#define FEW {}u\n#define CROWD {}u\n", sharing.few, sharing.crowd);
    common_ += fmt::format("#define TOUCH_GROUP {}u\n", kTouchGroup);
    common_ += fmt::format("#define SHAPE_KINDS {}u\n#define TWO_KINDS {}u\n#define ROUNDS {}u\n",
                           static_cast<int>(kDeviceShapes), kTwoKinds, kRounds);
    common_ += fmt::format(
        "#define UNSOLVED real({}lf)\n#define UNSETTLED real({}lf)\n#define SHARE {}\n#define RISE {}lf\n",
        kUnsolved, kUnsettledSweeps, kShareLeft, single ? kRiseOfFloats : kRise);
    common_ += hull_sizes(table);
    if (round) common_ += "#define ROUND\n";
  }

  // `uses`: arrays of device_buffers.glsl; `more`: other macros, whole lines; `parts` come between those that all
  // programs have and `main`.
  ComputeProgram operator()(const char* name, std::initializer_list<const char*> uses, std::string more,
                            std::vector<ShaderPart> parts, const ShaderPart& main,
                            unsigned group = kGroup) const {
    std::string defines = common_ + fmt::format("#define GROUP {}u\n", group);
    for (const char* array : uses) defines += fmt::format("#define USES_{}\n", array);
    defines += more;
    std::vector<ShaderPart> all = {shaders::device_layout, shaders::device_buffers, shaders::device_rotation};
    all.insert(all.end(), parts.begin(), parts.end());
    all.push_back(main);
    return {gl_, name, defines, all};
  }

 private:
  const ComputeFunctions& gl_;
  std::string common_;
};

ComputeProgram lists_of_contacts(const Compiler& compile, const std::string& more) {
  return compile("lists of contacts",
                 {"COUNTERS", "KINDS", "CONTACTS", "END_FIRST", "ENDS", "COLORS", "CURSORS"}, more, {},
                 shaders::device_ends_comp);
}

std::vector<ShaderPart> with_touch(std::vector<ShaderPart> narrow) {
  using namespace shaders;
  narrow.insert(narrow.begin(), {device_kept, device_gap, device_lists});
  narrow.insert(narrow.end(), {device_look, device_touch});
  return narrow;
}

constexpr auto kOfPairs = {"COUNTERS", "KINDS",         "POSES",    "FLIGHTS",  "PAIRS",
                           "RAW",      "CONTACT_FIRST", "GEOMETRY", "TOUCHING", "OUTCOMES"};

// The others are looked at by their touch program alone: compounds have too many contacts, and facets that are turned in
// one program may be turned otherwise in another, where two ways are as good.
bool has_find(int second, bool solids) { return second < (solids ? kDeviceHull : kDeviceCompound); }

// Those that define may_touch().
bool has_near(int first, int second) {
  return second == kDeviceHull ? first == kDeviceBox || first == kDeviceHull
                               : first == kDeviceBox && second == kDeviceBox;
}

std::vector<Programs::Find> find_programs(const ComputeFunctions& gl, const Compiler& compile,
                                          const std::set<int>& shapes, bool solids, bool near) {
  using namespace shaders;
  std::vector<Programs::Find> out;
  for (const int first : shapes) {
    for (const int second : shapes) {
      std::vector<ShaderPart> parts = narrow_parts(first, second, solids);
      if (second < first || parts.empty() || !has_find(second, solids)) continue;
      if (near && !has_near(first, second)) continue;
      const auto two = static_cast<std::uint32_t>(kDeviceShapes * first + second);
      ComputeProgram program =
          compile(near ? "who is near" : "what touches", kOfPairs,
                  fmt::format("#define KINDS_HERE {}\n{}", two, near ? "#define NEAR\n" : ""),
                  with_touch(parts), device_find_comp, kTouchGroup);
      const GLint list = gl.GetUniformLocation(program.id(), "list_"),
                  round = gl.GetUniformLocation(program.id(), "round_");
      out.push_back({two, std::move(program), list, round, !near && has_near(first, second)});
    }
  }
  return out;
}

std::vector<Programs::Touch> touch_programs(const ComputeFunctions& gl, const Compiler& compile,
                                            const std::set<int>& shapes, bool solids) {
  std::vector<Programs::Touch> out;
  for (const int first : shapes) {
    for (const int second : shapes) {
      const std::vector<ShaderPart> narrow = narrow_parts(first, second, solids);
      if (second < first || narrow.empty()) continue;
      const auto two = static_cast<std::uint32_t>(kDeviceShapes * first + second);
      ComputeProgram program =
          compile("contacts of a pair",
                  {"COUNTERS", "KINDS", "POSES", "FLIGHTS", "PAIRS", "RAW", "CONTACT_FIRST", "GEOMETRY",
                   "TOUCHING", "OUTCOMES", "CONTACTS"},
                  fmt::format("#define KINDS_HERE {}\n#define MAY_BE_LATE\n", two), with_touch(narrow),
                  second == kDeviceCompound ? shaders::device_touch_parts_comp : shaders::device_touch_comp,
                  kTouchGroup);
      const GLint list = gl.GetUniformLocation(program.id(), "list_"),
                  late = gl.GetUniformLocation(program.id(), "late_");
      out.push_back({two, std::move(program), list, late, !has_find(second, solids)});
    }
  }
  return out;
}

}  // namespace

bool any_round(const std::set<int>& shapes, const ShapeTable& table) {
  return table.has_solids || shapes.contains(kDeviceSphere) || shapes.contains(kDeviceCapsule);
}

Programs make_programs(const ComputeFunctions& gl, Precision precision, const ShapeTable& table,
                       const std::set<int>& shapes, const Sharing& sharing) {
  using namespace shaders;
  const Compiler compile(gl, precision, table, any_round(shapes, table), sharing);
  // The same text whatever shares a body: a driver compiles it once.
  const Compiler unshared(gl, precision, table, any_round(shapes, table));
  std::string group_bodies = "#define GROUP_BODIES uint[SHARES](";
  for (std::uint32_t share = 0; share < kShares; ++share)
    group_bodies += fmt::format("{}{}u", share > 0 ? ", " : "", sharing.group(share) / sharing.team[share]);
  group_bodies += ")\n";
  const auto scan = [&](const char* pass) {
    return compile("sums", {"VALUES"}, std::string("#define PASS ") + pass + "\n", {}, device_scan_comp);
  };
  const auto color = [&](const char* pass) {
    return compile("colors", {"COUNTERS", "KINDS", "END_FIRST", "ENDS", "COLORS", "VALUES"},
                   group_bodies + "#define " + pass + "\n", {}, device_color_comp);
  };
  const auto sort = [&](const char* pass) {
    return compile("pairs by kinds", {"COUNTERS", "KINDS", "PAIRS", "ARGUMENTS", "TOUCHING"},
                   std::string("#define ") + pass + "\n", {device_lists}, device_sort_pairs_comp);
  };
  const auto pairs = [&](const char* more) {
    return compile("pairs", {"COUNTERS", "KINDS", "BOUNDS", "CELLS", "PAIR_FIRST", "PAIRS", "PLANES"}, more,
                   {device_cells}, device_pairs_comp);
  };
  const std::vector<ShaderPart> contact = {barrier_sums, device_barrier, device_contact};
  return {
      .clear = compile("zeros", {"VALUES"}, "", {}, device_clear_comp),
      .fly = compile("free flight",
                     {"COUNTERS", "KINDS", "POSES", "MOTIONS", "FLIGHTS", "BOUNDS", "CELLS", "PLANES"}, "",
                     {device_cells}, device_fly_comp),
      .scatter = compile("cells", {"COUNTERS", "BOUNDS", "CELLS", "CURSORS"}, "", {device_cells},
                         device_scatter_comp),
      .count_pairs = pairs(""),
      .list_pairs = pairs("#define EMIT\n"),
      .reuse = compile("contacts that last",
                       {"COUNTERS", "KINDS", "POSES", "FLIGHTS", "PAIRS", "RAW", "CONTACT_FIRST", "GEOMETRY",
                        "KEPT_PAIRS", "KEPT_FEATURE"},
                       "", {device_kept, device_memory, device_gap}, device_reuse_comp),
      .sort_pairs = {sort("COUNT"), sort("STARTS"), sort("LISTS"), sort("AGAIN")},
      .near = find_programs(gl, unshared, shapes, table.has_solids, true),
      .find = find_programs(gl, unshared, shapes, table.has_solids, false),
      .judge = unshared("contacts that count", kOfPairs, "",
                        with_touch({shape_table, narrow_common, pair_common, narrow_again, narrow_measured}),
                        device_judge_comp),
      .touch = touch_programs(gl, unshared, shapes, table.has_solids),
      .place = compile("contacts",
                       {"COUNTERS", "KINDS", "POSES", "FLIGHTS", "PAIRS", "RAW", "CONTACTS", "CONTACT_FIRST",
                        "END_FIRST", "KEPT_PAIRS", "KEPT_STRETCH", "KEPT_FEATURE"},
                       "", {barrier_sums, device_barrier, device_recovery, device_memory}, device_place_comp),
      .fill_ends = lists_of_contacts(compile, "#define PASS 0\n"),
      .sort_ends = lists_of_contacts(compile, "#define PASS 1\n"),
      .scan = {scan("0"), scan("1"), scan("2")},
      .colors = {color("CHECK"), color("TAKE"), color("ROUND_OF_COLORS"), color("SIZES"), color("STARTS"),
                 color("LISTS")},
      .start_bodies = compile("first iterate", {"COUNTERS", "KINDS", "FLIGHTS", "PLACES", "STEPS"},
                              "#define BODIES\n", {}, device_start_comp),
      .start_contacts =
          compile("first bounds", {"COUNTERS", "KINDS", "FLIGHTS", "PLACES", "CONTACTS", "GRIPS"}, "",
                  contact, device_start_comp),
      .between = compile("between sweeps", {"COUNTERS", "COLORS"}, "", {}, device_between_comp, 1),
      .reports = compile(
          "contact reports",
          {"COUNTERS", "KINDS", "POSES", "FLIGHTS", "PLACES", "CONTACTS", "GRIPS", "GEOMETRY", "TOLD"}, "",
          contact, device_reports_comp),
      .tell =
          compile("report", {"COUNTERS", "KINDS", "POSES", "FLIGHTS", "PLACES", "CONTACTS", "GRIPS", "PARTS"},
                  "", contact, device_tell_comp),
      .total_contacts = compile("totals", {"COUNTERS", "PARTS"}, "", {}, device_total_comp),
      .finish = compile("velocities",
                        {"COUNTERS", "KINDS", "POSES", "MOTIONS", "FLIGHTS", "PLACES", "END_FIRST", "ENDS",
                         "CONTACTS", "PARTS", "STEPS", "OUTCOMES"},
                        fmt::format("#define FELT real({}lf)\n", kFelt), {device_inertia, device_balance},
                        device_finish_comp),
      .total_bodies =
          compile("totals", {"COUNTERS", "PARTS"}, "#define BODIES\n", {device_unsolved}, device_total_comp),
      .keep_contacts = compile("memory of contacts",
                               {"COUNTERS", "CONTACTS", "GRIPS", "KEPT_STRETCH", "KEPT_FEATURE", "GEOMETRY"},
                               "#define CONTACTS\n", {}, device_keep_comp),
      .keep_pairs =
          compile("memory of pairs", {"COUNTERS", "PAIR_FIRST", "PAIRS", "CONTACTS", "GRIPS", "KEPT_PAIRS"},
                  "", {device_recovery}, device_keep_comp),
      .move =
          compile("moves", {"COUNTERS", "KINDS", "POSES", "MOTIONS", "OUTCOMES"}, "", {}, device_move_comp),
  };
}

ComputeProgram make_sweep_program(const ComputeFunctions& gl, Precision precision, const ShapeTable& table,
                                  const std::set<int>& shapes, const Sharing& sharing, std::uint32_t share) {
  using namespace shaders;
  const Compiler compile(gl, precision, table, any_round(shapes, table), sharing);
  const std::string threads =
      fmt::format("#define SWEEP_GROUP {}u\n#define TEAM {}u\n", sharing.group(share), sharing.team[share]);
  return compile(
      "sweep",
      {"COUNTERS", "KINDS", "FLIGHTS", "PLACES", "CONTACTS", "GRIPS", "END_FIRST", "ENDS", "COLORS", "STEPS"},
      threads + "#define ACCESS restrict\n", {barrier_sums, device_barrier, device_contact, device_inertia},
      device_sweep_comp, sharing.group(share));
}

ComputeProgram make_crowd_sort_program(const ComputeFunctions& gl, Precision precision,
                                       const ShapeTable& table, const Sharing& sharing) {
  return lists_of_contacts(Compiler(gl, precision, table, false, sharing),
                           "#define PASS 2\n#define ACCESS coherent\n");
}

ComputeProgram make_values_program(const ComputeFunctions& gl, Precision precision, const ShapeTable& table,
                                   BodyQuantity quantity) {
  const Compiler compile(gl, precision, table, false);
  return compile("values of bodies",
                 {"COUNTERS", "KINDS", "POSES", "MOTIONS", "GRIPS", "END_FIRST", "ENDS", "BODY_VALUES"},
                 quantity == BodyQuantity::energy ? "#define ENERGY\n" : "", {}, shaders::device_values_comp);
}

}  // namespace pabd::device
