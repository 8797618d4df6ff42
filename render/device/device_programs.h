// SPDX-License-Identifier: MIT
// The compute shaders of a step, compiled for a model: only the pairs of shapes that it has.
#pragma once

#include <array>
#include <set>
#include <string>
#include <vector>

#include "render/device/compute_program.h"
#include "render/device/device_layout.h"
#include "render/device/device_solver.h"
#include "render/device/shape_table.h"

namespace pabd::device {

// What displacements and forces are computed in. twofold (double) is for comparison with the processor's solver.
enum class Precision { single, twofold };

inline constexpr unsigned kGroup = 256, kSweepGroup = 32, kCrowdGroup = 128,
                          kTouchGroup = 32;  // threads of a work group
// How many work groups of `size` threads that many items need; at least one.
constexpr std::uint32_t groups(std::size_t items, unsigned size) {
  return items == 0 ? 1 : static_cast<std::uint32_t>((items + size - 1) / size);
}

inline constexpr unsigned kScanned = 8 * kGroup;  // values a work group of a scan

struct Programs {
  struct Scan {
    ComputeProgram blocks, sums, add;
  };
  struct Colors {
    ComputeProgram check, take, round, sizes, starts, lists;
  };
  struct Sort {
    ComputeProgram count, starts, lists, again;
  };
  // Of two kinds of shapes: kDeviceShapes · lower + higher.
  struct Find {
    std::uint32_t kinds;
    ComputeProgram program;
    GLint list, round;  // places of uniforms: device_lists.glsl
    bool sifted;        // it looks at those that `near` found near each other
  };
  struct Touch {
    std::uint32_t kinds;
    ComputeProgram program;
    GLint list, late;  // places of uniforms: device_lists.glsl, device_look.glsl
    bool alone;        // there is no Find of these
  };
  ComputeProgram clear, fly, scatter, count_pairs, list_pairs;
  ComputeProgram reuse;
  Sort sort_pairs;
  std::vector<Find> near, find;
  ComputeProgram judge;
  std::vector<Touch> touch;  // one a pair of kinds of shapes
  ComputeProgram place, fill_ends, sort_ends;
  Scan scan;
  Colors colors;
  ComputeProgram start_bodies, start_contacts, between;
  ComputeProgram reports, tell, total_contacts, finish, total_bodies, keep_contacts, keep_pairs, move;
};

// How bodies are shared in a sweep, by how many contacts they have (SHARES of device_layout.glsl).
struct Sharing {
  unsigned few = 64, crowd = 64;  // contacts up to which a body is of share 0, and above which of share 2
  std::array<unsigned, kShares> team = {1, 8, kCrowdGroup};  // threads of a body
  unsigned group(std::uint32_t share) const { return share == 2 ? kCrowdGroup : kSweepGroup; }
};

bool any_round(const std::set<int>& shapes, const ShapeTable& table);

// For models that have these shapes, and bodies of these kinds of DeviceShape. Throws Error(no_context) where a shader
// is refused.
Programs make_programs(const ComputeFunctions& gl, Precision precision, const ShapeTable& table,
                       const std::set<int>& shapes, const Sharing& sharing);
// Of a share.
ComputeProgram make_sweep_program(const ComputeFunctions& gl, Precision precision, const ShapeTable& table,
                                  const std::set<int>& shapes, const Sharing& sharing, std::uint32_t share);
// The lists of contacts of bodies of share 2.
ComputeProgram make_crowd_sort_program(const ComputeFunctions& gl, Precision precision,
                                       const ShapeTable& table, const Sharing& sharing);

// That fills Slot::body_values; compiled only where somebody asks for it.
ComputeProgram make_values_program(const ComputeFunctions& gl, Precision precision, const ShapeTable& table,
                                   BodyQuantity quantity);

}  // namespace pabd::device
