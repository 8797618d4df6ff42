// SPDX-License-Identifier: MIT
// A step on the GPU, in the order of the algorithm: enqueue(). What each program does is said in its shader.
#include "render/device/device_step.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "sim/solver/contact_setup.h"
#include "sim/solver/friction.h"
#include "sim/solver/halving.h"
#include "sim/solver/second_order.h"

namespace pabd::device {
namespace {

constexpr std::uint32_t kMostRounds = 4096;  // of coloring that a step is dispatched for

constexpr std::uint32_t kCrowdGroups = 256;  // that sort lists of crowded bodies

// Few bodies leave a GPU idle, so that more threads a body cost nothing and wait less (tests/bench/README.md).
Sharing sharing_for(const Model& model, const DeviceOptions& options) {
  const auto or_usual = [](int given, unsigned usual) {
    return given > 0 ? static_cast<unsigned>(given) : usual;
  };
  Sharing out;
  out.team[0] = or_usual(options.team, model.size() < 50'000 ? 16 : model.size() < 500'000 ? 8 : 2);
  out.crowd = or_usual(options.crowd, 64);
  out.few = or_usual(options.few, out.team[0] < out.team[1] ? 12 : out.crowd);
  return out;
}

// Where a dispatch of a list of pairs has its arguments (shaders/device_lists.glsl).
GLintptr arguments_of_list(std::uint32_t list, std::uint32_t kinds) {
  return static_cast<GLintptr>(16 * (kSweepLists + list * kTwoKinds + kinds));
}

// Of bodies: their parts have rows too.
std::set<int> shapes_of(const ShapeTable& table) {
  std::set<int> out;
  for (const std::uint32_t row : table.of_body) out.insert(static_cast<int>(table.shapes[row].kind));
  return out;
}

}  // namespace

DeviceStep::DeviceStep(GlContext& context, const Model& model, const DeviceOptions& options)
    : gl(context),
      buffers(gl),
      clock(gl, options.time_phases),
      model_(model),
      options_(options),
      precision_(options.precision == DevicePrecision::single ? Precision::single : Precision::twofold),
      table_(make_shape_table(model)),
      kinds_(make_body_kinds(model, table_)),
      shapes_(shapes_of(table_)),
      sharing_(sharing_for(model, options)),
      programs_(make_programs(gl, precision_, table_, shapes_, sharing_)),
      movable_(static_cast<Index>(std::count(model.fixed.begin(), model.fixed.end(), 0))),
      heaviest_(movable_mass(model).heaviest),
      bodies_(static_cast<std::uint32_t>(model.size())),
      buckets_(std::bit_ceil(std::max(1024u, bodies_))) {
  make_body_buffers();
  make_pair_buffers(options.pairs > 0 ? options.pairs : 4 * bodies_ + 1024);
  make_contact_buffers(options.contacts > 0 ? options.contacts : 8 * bodies_ + 1024);
  make_sweep(0);
}

void DeviceStep::make_sweep(std::uint32_t share) {
  if (sweeps_.contains(share)) return;
  ComputeProgram program = make_sweep_program(gl, precision_, table_, shapes_, sharing_, share);
  const GLint list = gl.GetUniformLocation(program.id(), "list_"),
              move_limits = gl.GetUniformLocation(program.id(), "move_limits");
  sweeps_.emplace(share, Sweep{std::move(program), list, move_limits});
  if (share == 2) crowd_sort_.emplace(make_crowd_sort_program(gl, precision_, table_, sharing_));
}

void DeviceStep::expect(const Counters& counters) {
  rounds_ = std::clamp(counters.rounds + 2, 4u, kMostRounds);
  color_limit_ = std::min(counters.colors + 2, kColors);
}

void DeviceStep::set_params(const Params& params, bool starts) {
  if (!law_of_ || !(*law_of_ == params)) {  // κ looks at every mass
    law_ = contact_law(model_, params);
    law_of_ = params;
  }
  StepParams p{};
  std::copy_n(params.gravity.data(), 3, p.gravity);
  p.least_load = kLeastLoad * heaviest_ * weight_per_mass(params);
  p.weight_per_mass = weight_per_mass(params);
  p.least_share = kLeastLoad * p.weight_per_mass;
  p.h = params.h;
  p.d_hat = law_.barrier.d_hat;
  p.kappa = law_.barrier.kappa;
  p.k_t = law_.k_t;
  p.mu_static = params.contact.mu_static;
  p.mu_dynamic = params.contact.mu_dynamic;
  p.onset = law_.barrier.onset;
  p.recovery_speed = params.contact.recovery_speed;
  p.cell = 2 * (1.05 * kinds_.smallest_radius + law_.barrier.d_hat);
  p.N = law_.barrier.N;
  p.barrier = static_cast<std::int32_t>(law_.barrier.kind);
  p.first_step = starts;
  p.color_limit = static_cast<std::int32_t>(color_limit_);
  p.bodies = bodies_;
  p.buckets = buckets_;
  p.planes = static_cast<std::uint32_t>(kinds_.planes.size());
  p.skips = static_cast<std::uint32_t>(model_.no_collide.size());
  p.pair_room = pair_room_;
  p.contact_room = contact_room_;
  p.friction_rule = model_.friction.empty() ? -1 : static_cast<std::int32_t>(params.contact.friction_rule);
  p.groups = model_.groups.avoids.empty() ? 0 : 1;
  for (const auto& [share, sweep] : sweeps_) p.shares |= 1u << share;
  p.halves = may_halve(params.solver) ? 1 : 0;
  p.second_order = has_second_order(params.solver) ? 1 : 0;
  buffers.write(Slot::params, 0, std::as_bytes(std::span(&p, 1)));
}

void DeviceStep::dispatch(const ComputeProgram& program, std::uint32_t work_groups) {
  program.use();
  gl.DispatchCompute(work_groups, 1, 1);
  gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);  // some are cleared after
}

void DeviceStep::set(const ComputeProgram& program, const char* name, std::uint32_t value) {
  program.use();
  gl.Uniform1ui(gl.GetUniformLocation(program.id(), name), value);
}

// The first `count` numbers of 32 bits become 0.
void DeviceStep::clear(Slot slot, std::size_t count) {
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(Slot::values), buffers.id(slot));
  set(programs_.clear, "count", static_cast<std::uint32_t>(count));
  dispatch(programs_.clear, groups(count, kGroup));
  buffers.bind(Slot::values);
}

// values[k] becomes the sum of values[0 … k).
void DeviceStep::scan(Slot slot, std::size_t count) {
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(Slot::values), buffers.id(slot));
  const std::uint32_t blocks = groups(count, kScanned);
  for (const ComputeProgram* pass : {&programs_.scan.blocks, &programs_.scan.sums, &programs_.scan.add}) {
    set(*pass, "count", static_cast<std::uint32_t>(count));
    dispatch(*pass, pass == &programs_.scan.sums ? 1 : blocks);
  }
  buffers.bind(Slot::values);
}

void DeviceStep::find_pairs() {
  const std::uint32_t body_groups = groups(bodies_, kGroup);
  clear(Slot::cell_first, buckets_ + 1);
  clear(Slot::cursors, buckets_);
  dispatch(programs_.fly, body_groups);
  scan(Slot::cell_first, buckets_ + 1);
  dispatch(programs_.scatter, body_groups);
  buffers.clear(Slot::pair_first, bodies_ * sizeof(std::uint32_t), sizeof(std::uint32_t));
  dispatch(programs_.count_pairs, body_groups);
  scan(Slot::pair_first, bodies_ + 1);
  dispatch(programs_.list_pairs, body_groups);
}

void DeviceStep::find_contacts() {
  clear(Slot::contact_first, std::size_t{pair_room_} + 1);
  if (options_.keep_contacts) dispatch(programs_.reuse, groups(pair_room_, kGroup));
  dispatch(programs_.sort_pairs.count, groups(pair_room_, kGroup));
  dispatch(programs_.sort_pairs.starts, 1);
  dispatch(programs_.sort_pairs.lists, groups(pair_room_, kGroup));
  for (std::uint32_t round = 0; round < kRounds; ++round) {
    if (!programs_.near.empty()) {
      find(programs_.near, round);
      set(programs_.sort_pairs.again, "list_", kRounds + 1 + round);
      dispatch(programs_.sort_pairs.again, 1);
    }
    find(programs_.find, round);
    set(programs_.judge, "round_", round);
    dispatch(programs_.judge, groups(pair_room_, kGroup));
    set(programs_.sort_pairs.again, "list_", round + 1);
    dispatch(programs_.sort_pairs.again, 1);
  }
  touch(false);
}

void DeviceStep::find(const std::vector<Programs::Find>& programs, std::uint32_t round) {
  gl.BindBuffer(GL_DISPATCH_INDIRECT_BUFFER, buffers.id(Slot::arguments));
  gl.MemoryBarrier(GL_COMMAND_BARRIER_BIT);
  for (const Programs::Find& find : programs) {  // none sees what another one writes
    const std::uint32_t list = find.sifted ? kRounds + 1 + round : round;
    find.program.use();
    gl.Uniform1ui(find.list, list);
    gl.Uniform1ui(find.round, round);
    gl.DispatchComputeIndirect(arguments_of_list(list, find.kinds));
  }
  gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void DeviceStep::touch(bool late) {
  gl.BindBuffer(GL_DISPATCH_INDIRECT_BUFFER, buffers.id(Slot::arguments));
  gl.MemoryBarrier(GL_COMMAND_BARRIER_BIT);
  for (const Programs::Touch& touch : programs_.touch) {  // none sees what another one writes
    touch.program.use();
    const std::uint32_t list = late || touch.alone ? 0 : kRounds;
    gl.Uniform1ui(touch.list, list);
    gl.Uniform1ui(touch.late, late ? 1 : 0);
    gl.DispatchComputeIndirect(arguments_of_list(list, touch.kinds));
  }
  gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void DeviceStep::list_ends() {
  scan(Slot::contact_first, std::size_t{pair_room_} + 1);
  clear(Slot::end_first, bodies_ + 1);
  clear(Slot::cursors, bodies_);
  dispatch(programs_.place, groups(pair_room_, kGroup));
  scan(Slot::end_first, bodies_ + 1);
  dispatch(programs_.fill_ends, groups(contact_room_, kGroup));
  dispatch(programs_.sort_ends, groups(bodies_, kGroup));
  if (crowd_sort_) dispatch(*crowd_sort_, std::min(bodies_, kCrowdGroups));
}

void DeviceStep::color_bodies() {
  const std::uint32_t body_groups = groups(bodies_, kGroup);
  const Programs::Colors& colors = programs_.colors;
  dispatch(colors.check, body_groups);
  dispatch(colors.take, body_groups);
  for (std::uint32_t r = 1; r <= rounds_; ++r) {
    set(colors.round, "round_", r);
    dispatch(colors.round, body_groups);
  }
  dispatch(colors.sizes, body_groups);
  dispatch(colors.starts, 1);
  dispatch(colors.lists, body_groups);
}

void DeviceStep::sweep(const Params& params) {
  const GLuint between = programs_.between.id();
  const GLint last_place = gl.GetUniformLocation(between, "last_");
  programs_.between.use();
  gl.Uniform4f(gl.GetUniformLocation(between, "tolerance"), static_cast<float>(params.solver.tolerance),
               static_cast<float>(kFrictionTolerance), 0, 0);
  gl.BindBuffer(GL_DISPATCH_INDIRECT_BUFFER, buffers.id(Slot::arguments));
  gl.MemoryBarrier(GL_COMMAND_BARRIER_BIT);
  for (int k = 0; k < params.solver.iterations; ++k) {
    const bool move_limits = k > 0 && has_friction(model_, params.contact);
    for (std::uint32_t color = 0; color < color_limit_; ++color) {
      for (const auto& [share, sweep] : sweeps_) {  // of one color: none waits for another share
        const std::uint32_t list = share * kColors + color;
        sweep.program.use();
        gl.Uniform1ui(sweep.list, list);
        gl.Uniform1i(sweep.move_limits, move_limits);
        gl.DispatchComputeIndirect(static_cast<GLintptr>(16 * list));
      }
      gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    }
    programs_.between.use();
    gl.Uniform1i(last_place, k + 1 == params.solver.iterations);
    gl.DispatchCompute(1, 1, 1);
    gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
  }
}

void DeviceStep::enqueue(const Params& params, bool starts, DeviceTimes& times) {
  const std::uint32_t body_groups = groups(bodies_, kGroup), contact_groups = groups(contact_room_, kGroup);
  set_params(params, starts);
  constexpr std::size_t kKept = sizeof(Counters::overflow);
  buffers.clear(Slot::counters, kKept, sizeof(Counters) - kKept);
  clock.start();
  find_pairs();  // 1. free flight: Q*; who may touch whom
  clock.lap(times.broad_phase);
  find_contacts();  // 2. bonds of this step, S(17)
  clock.lap(times.narrow_phase);
  list_ends();
  color_bodies();
  dispatch(programs_.start_bodies, body_groups);
  dispatch(programs_.start_contacts, contact_groups);
  clock.lap(times.set_up);
  sweep(params);  // 3. minimise E
  clock.lap(times.solve);
  if (options_.report_contacts) dispatch(programs_.reports, contact_groups);
  dispatch(programs_.tell, contact_groups);
  set(programs_.total_contacts, "count", contact_groups);
  dispatch(programs_.total_contacts, 1);
  dispatch(programs_.finish, body_groups);  // 4. velocities
  if (may_halve(params.solver)) touch(true);
  set(programs_.total_bodies, "count", body_groups);
  dispatch(programs_.total_bodies, 1);
  // 5. Unless it ended unsolved, the step is made.
  dispatch(programs_.keep_contacts, contact_groups);
  dispatch(programs_.keep_pairs, groups(std::max(pair_room_, bodies_ + 1), kGroup));
  dispatch(programs_.move, body_groups);
  clock.lap(times.velocities);
}

void DeviceStep::tell_values(BodyQuantity quantity) {
  auto at = value_programs_.find(quantity);
  if (at == value_programs_.end()) {
    at = value_programs_.emplace(quantity, make_values_program(gl, precision_, table_, quantity)).first;
    if (buffers.bytes(Slot::body_values) == 0) buffers.make(Slot::body_values, bodies_ * sizeof(float));
  }
  set(at->second, "count", bodies_);
  dispatch(at->second, groups(bodies_, kGroup));
}

}  // namespace pabd::device
