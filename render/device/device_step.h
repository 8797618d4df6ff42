// SPDX-License-Identifier: MIT
// The memory and the commands of a step on the GPU. Nothing here waits for it.
#pragma once

#include <map>
#include <optional>
#include <set>

#include "render/device/body_kinds.h"
#include "render/device/device_buffers.h"
#include "render/device/device_programs.h"
#include "render/device/device_solver.h"
#include "render/device/phase_clock.h"
#include "sim/bond/contact_bond.h"

namespace pabd::device {

class DeviceStep {
 public:
  DeviceStep(GlContext& context, const Model& model, const DeviceOptions& options);

  // All commands of a step. `starts`: it is the first of a run. `times` is filled by clock.read(), later.
  void enqueue(const Params& params, bool starts, DeviceTimes& times);
  double kappa() const { return law_.barrier.kappa; }  // of the last one; J

  // Fills Slot::body_values.
  void tell_values(BodyQuantity quantity);

  // Larger buffers for what was too small in the step that these counters are of; steps are made again then.
  void make_room(const Counters& counters);
  // How many colors and rounds of coloring the next steps are dispatched for. Changes no result: with too few of
  // either the step is made again.
  void expect(const Counters& counters);

  const Model& model() const { return model_; }
  Precision precision() const { return precision_; }
  std::uint32_t bodies() const { return bodies_; }
  Index movable() const { return movable_; }

  ComputeFunctions gl;
  Buffers buffers;
  PhaseClock clock;

 private:
  struct Sweep {
    ComputeProgram program;
    GLint list, move_limits;  // its uniforms
  };
  std::size_t vec4() const { return 4 * (precision_ == Precision::single ? sizeof(float) : sizeof(double)); }
  std::size_t contact_bytes() const;
  void make_body_buffers();
  void make_pair_buffers(std::uint32_t room);
  void make_contact_buffers(std::uint32_t room);

  void set_params(const Params& params, bool starts);
  void dispatch(const ComputeProgram& program, std::uint32_t work_groups);
  void set(const ComputeProgram& program, const char* name, std::uint32_t value);
  void make_sweep(std::uint32_t share);
  void clear(Slot slot, std::size_t count);
  void scan(Slot slot, std::size_t count);
  void find_pairs();
  void find_contacts();
  void find(const std::vector<Programs::Find>& programs, std::uint32_t round);
  void touch(bool late);  // late: overlap where the step ends, that it has no contact for
  void list_ends();
  void color_bodies();
  void sweep(const Params& params);

  Model model_;
  DeviceOptions options_;
  Precision precision_;
  ShapeTable table_;
  BodyKinds kinds_;
  std::set<int> shapes_;
  Sharing sharing_;
  Programs programs_;
  std::map<std::uint32_t, Sweep> sweeps_;                  // by share: 0, and those of bodies that were met
  std::optional<ComputeProgram> crowd_sort_;               // beside that of share 2
  std::map<BodyQuantity, ComputeProgram> value_programs_;  // of those that were asked for
  Index movable_;
  double heaviest_;  // kg
  std::uint32_t bodies_, buckets_, pair_room_ = 0, contact_room_ = 0;
  std::uint32_t color_limit_ = 16, rounds_ = 24;
  ContactLaw law_{};
  std::optional<Params> law_of_;  // what it was made of: κ looks at every mass
};

}  // namespace pabd::device
