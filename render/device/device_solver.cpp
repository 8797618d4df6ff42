// SPDX-License-Identifier: MIT
// A step on the GPU, in the order of the algorithm: make_step. What each program does is said in its shader.
#include "render/device/device_solver.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <deque>
#include <optional>
#include <utility>

#include "render/device/body_kinds.h"
#include "render/device/device_buffers.h"
#include "render/device/device_programs.h"
#include "render/device/device_state.h"
#include "render/device/phase_clock.h"
#include "sim/base/error.h"
#include "sim/solver/contact_setup.h"
#include "sim/solver/friction.h"
#include "sim/solver/time_step.h"

namespace pabd {
namespace {

using namespace device;

constexpr int kLate = 2;  // steps that may be under way
constexpr std::uint32_t kMaxColors = kColors;
constexpr unsigned kFirstRounds = 24;  // of coloring, until a step has told how many it takes
constexpr double kMoreRoom = 1.3;      // than a step needed

// The floats that shaders keep in the order of their values.
float from_ordered(std::uint32_t bits) {
  return std::bit_cast<float>((bits & 0x80000000u) != 0 ? bits & 0x7fffffffu : ~bits);
}

std::uint32_t groups(std::size_t items, unsigned size) {
  return static_cast<std::uint32_t>(std::max<std::size_t>(1, (items + size - 1) / size));
}

// Shorter steps over d̂ are those of rounding.
double least_tolerance(Precision precision) { return precision == Precision::single ? 1e-6 : 0; }

std::set<int> shapes_of(const ShapeTable& table) {
  std::set<int> out;
  for (const ShapeRecord& shape : table.shapes) out.insert(static_cast<int>(shape.kind));
  return out;
}

}  // namespace

struct DeviceSolver::Impl {
  Impl(GlContext& context, const Model& m, const DeviceOptions& o)
      : gl(context),
        buffers(gl),
        model(m),
        options(o),
        precision(o.precision == DevicePrecision::single ? Precision::single : Precision::twofold),
        table(make_shape_table(m)),
        kinds(make_body_kinds(m, table)),
        shapes(shapes_of(table)),
        programs(make_programs(gl, precision, shapes)),
        clock(gl, o.time_phases) {
    bodies = static_cast<std::uint32_t>(m.size());
    buckets = std::bit_ceil(std::max(1024u, bodies));
    real_bytes = precision == Precision::single ? 4 : 8;
    make_body_buffers();
    make_pair_buffers(std::max(o.pairs, o.pairs > 0 ? 1u : 4 * bodies + 1024));
    make_contact_buffers(std::max(o.contacts, o.contacts > 0 ? 1u : 8 * bodies + 1024));
  }

  std::size_t vec4() const { return 4 * real_bytes; }
  std::size_t pair_bytes() const { return pair_size(precision); }
  std::size_t contact_bytes() const {  // of struct Contact
    const std::size_t head = precision == Precision::single ? 16 : 32;
    return head + (any_round(shapes) ? 5 : 4) * vec4();
  }

  void make_body_buffers();
  void make_pair_buffers(std::uint32_t room);
  void make_contact_buffers(std::uint32_t room);
  void set_params(const Params& params);

  void dispatch(const ComputeProgram& program, std::uint32_t work_groups);
  void set(const ComputeProgram& program, const char* name, std::uint32_t value);
  void scan(Slot slot, std::size_t count);
  void find_pairs();
  void find_contacts();
  void list_ends();
  void color_bodies();
  void sweep(const Params& params);
  void make_step(const Params& params);

  struct Asked {
    Params params;
    double kappa;
    GlBuffer copy;  // of the counters, when the step is done
    GLsync done;
  };
  void ask(const Params& params);
  void take_oldest();
  void make_room(const Counters& late);
  void report(const Asked& step, const Counters& late);

  ComputeFunctions gl;
  Buffers buffers;
  Model model;
  DeviceOptions options;
  Precision precision;
  ShapeTable table;
  BodyKinds kinds;
  std::set<int> shapes;
  Programs programs;
  PhaseClock clock;
  std::uint32_t bodies = 0, buckets = 0, pair_room = 0, contact_room = 0;
  std::size_t real_bytes = 4;
  std::uint32_t color_limit = 16, rounds = kFirstRounds;
  std::deque<Asked> asked;
  std::vector<Params> again;  // of steps that were not made
  StepSummary summary;
  Counters last{};
  DeviceTimes times;
  ContactLaw law{};
  std::optional<Params> law_of;
  double d_hat = 0;  // of the last step
  std::int64_t step_number = 0;
  double time = 0;
  int repeated = 0;
};

// --- memory ----------------------------------------------------------------------------------------------

void DeviceSolver::Impl::make_body_buffers() {
  const std::size_t n = bodies;
  buffers.make(Slot::params, sizeof(StepParams));
  buffers.make(Slot::counters, sizeof(Counters));
  buffers.make(Slot::kinds, kinds.kinds);
  buffers.make(Slot::kind_of, kinds.of_body);
  buffers.make(Slot::poses, n * sizeof(device::Pose));
  buffers.make(Slot::motions, n * 2 * vec4());
  buffers.make(Slot::flights, n * 7 * vec4());
  buffers.make(Slot::places, n * 2 * vec4());
  buffers.make(Slot::bounds, n * 2 * 16);
  buffers.make(Slot::cell_first, (buckets + 1) * sizeof(std::uint32_t));
  buffers.make(Slot::cell_bodies, n * 16);
  buffers.make(Slot::pair_first, (n + 1) * sizeof(std::uint32_t));
  buffers.make(Slot::end_first, (n + 1) * sizeof(std::uint32_t));
  buffers.make(Slot::color_of, n * sizeof(std::uint32_t));
  buffers.make(Slot::order, n * sizeof(std::uint32_t));
  buffers.make(Slot::arguments, kColors * 16);
  buffers.make(Slot::cursors, std::max<std::size_t>(n, buckets) * sizeof(std::uint32_t));
  buffers.make(Slot::steps, n * 2 * vec4());
  buffers.make(Slot::kept_first, (n + 1) * sizeof(std::uint32_t));
  buffers.make(Slot::values, n * sizeof(std::uint32_t));
  buffers.make(Slot::shapes, table.shapes);
  buffers.make(Slot::hulls, table.hulls);
  buffers.make(Slot::plane_bodies, kinds.planes);
  std::vector<std::uint32_t> skips;
  for (const auto& [a, b] : model.no_collide) {
    skips.push_back(static_cast<std::uint32_t>(a));
    skips.push_back(static_cast<std::uint32_t>(b));
  }
  buffers.make(Slot::skips, skips);
  buffers.make(Slot::huge, n * sizeof(std::uint32_t));
}

void DeviceSolver::Impl::make_pair_buffers(std::uint32_t room) {
  pair_room = room;
  buffers.make(Slot::pairs, room * pair_bytes());
  buffers.make(Slot::contact_first, (std::size_t{room} + 1) * sizeof(std::uint32_t));
  buffers.make(
      Slot::sums,
      (groups(std::max({std::size_t{room}, std::size_t{bodies}, std::size_t{buckets}}) + 1, kScanned) + 1) *
          sizeof(std::uint32_t));
  buffers.grow(Slot::kept_pairs, room * pair_bytes());
}

void DeviceSolver::Impl::make_contact_buffers(std::uint32_t room) {
  contact_room = room;
  buffers.make(Slot::raw, room * contact_bytes());
  buffers.make(Slot::contacts, room * contact_bytes());
  buffers.make(Slot::raw_geometry, room * 2 * vec4());
  buffers.make(Slot::grips, room * vec4());
  buffers.make(Slot::ends, std::size_t{room} * 2 * sizeof(std::uint32_t));
  buffers.make(Slot::parts, std::size_t{groups(std::max(room, bodies), kGroup)} * 4 * sizeof(double));
  if (options.report_contacts) buffers.make(Slot::told, room * sizeof(ContactTold));
  buffers.grow(Slot::kept_stretch, room * vec4());
  buffers.grow(Slot::kept_geometry, room * 2 * vec4());
  buffers.grow(Slot::kept_feature, room * sizeof(std::uint32_t));
}

// --- one step --------------------------------------------------------------------------------------------

void DeviceSolver::Impl::set_params(const Params& params) {
  if (!law_of || !(*law_of == params)) {  // κ looks at every mass
    law = contact_law(model, params);
    law_of = params;
  }
  StepParams p{};
  std::copy_n(params.gravity.data(), 3, p.gravity);
  p.least_load = kLeastLoad * kinds.heaviest * weight_per_mass(params);
  p.least_share = kLeastLoad * weight_per_mass(params);
  p.h = params.h;
  p.d_hat = law.barrier.d_hat;
  p.kappa = law.barrier.kappa;
  p.k_t = law.k_t;
  p.mu_static = law.mu_static;
  p.mu_dynamic = law.mu_dynamic;
  p.onset = law.barrier.onset;
  p.recovery_speed = params.contact.recovery_speed;
  p.cell = 2 * (1.05 * kinds.smallest_radius + law.barrier.d_hat);
  p.N = law.barrier.N;
  p.barrier = static_cast<std::int32_t>(law.barrier.kind);
  p.first_step = step_number == 0 && asked.empty();
  p.color_limit = static_cast<std::int32_t>(color_limit);
  p.bodies = bodies;
  p.buckets = buckets;
  p.planes = static_cast<std::uint32_t>(kinds.planes.size());
  p.skips = static_cast<std::uint32_t>(model.no_collide.size());
  p.pair_room = pair_room;
  p.contact_room = contact_room;
  buffers.write(Slot::params, 0, std::as_bytes(std::span(&p, 1)));
}

void DeviceSolver::Impl::dispatch(const ComputeProgram& program, std::uint32_t work_groups) {
  program.use();
  gl.DispatchCompute(work_groups, 1, 1);
  gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void DeviceSolver::Impl::set(const ComputeProgram& program, const char* name, std::uint32_t value) {
  program.use();
  gl.Uniform1ui(gl.GetUniformLocation(program.id(), name), value);
}

// values[k] becomes the sum of values[0 … k).
void DeviceSolver::Impl::scan(Slot slot, std::size_t count) {
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(Slot::values), buffers.id(slot));
  const std::uint32_t blocks = groups(count, kScanned);
  for (const ComputeProgram* pass : {&programs.scan.blocks, &programs.scan.sums, &programs.scan.add}) {
    set(*pass, "count", static_cast<std::uint32_t>(count));
    dispatch(*pass, pass == &programs.scan.sums ? 1 : blocks);
  }
  buffers.bind(Slot::values);
}

void DeviceSolver::Impl::find_pairs() {
  const std::uint32_t body_groups = groups(bodies, kGroup);
  buffers.clear(Slot::cell_first);
  buffers.clear(Slot::cursors);
  dispatch(programs.fly, body_groups);
  scan(Slot::cell_first, buckets + 1);
  dispatch(programs.scatter, body_groups);
  buffers.clear(Slot::pair_first, bodies * sizeof(std::uint32_t), sizeof(std::uint32_t));
  dispatch(programs.count_pairs, body_groups);
  scan(Slot::pair_first, bodies + 1);
  dispatch(programs.list_pairs, body_groups);
}

void DeviceSolver::Impl::find_contacts() {
  buffers.clear(Slot::contact_first);
  if (options.keep_contacts) dispatch(programs.reuse, groups(pair_room, kGroup));
  for (const ComputeProgram& touch : programs.touch) dispatch(touch, groups(pair_room, 64));
}

void DeviceSolver::Impl::list_ends() {
  scan(Slot::contact_first, std::size_t{pair_room} + 1);
  buffers.clear(Slot::end_first);
  buffers.clear(Slot::cursors);
  dispatch(programs.place, groups(pair_room, kGroup));
  scan(Slot::end_first, bodies + 1);
  dispatch(programs.fill_ends, groups(contact_room, kGroup));
  dispatch(programs.sort_ends, groups(bodies, kGroup));
}

void DeviceSolver::Impl::color_bodies() {
  const std::uint32_t body_groups = groups(bodies, kGroup);
  const Programs::Colors& colors = programs.colors;
  dispatch(colors.check, body_groups);
  dispatch(colors.take, body_groups);
  for (std::uint32_t r = 1; r <= rounds; ++r) {
    set(colors.round, "round_", r);
    dispatch(colors.round, body_groups);
  }
  set(colors.rest, "round_", rounds + 1);
  dispatch(colors.rest, 1);
  dispatch(colors.sizes, body_groups);
  dispatch(colors.starts, 1);
  dispatch(colors.lists, body_groups);
}

void DeviceSolver::Impl::sweep(const Params& params) {
  const GLuint sweeping = programs.sweep.id(), between = programs.between.id();
  const GLint color = gl.GetUniformLocation(sweeping, "color_"),
              limits = gl.GetUniformLocation(sweeping, "move_limits");
  const GLint last_place = gl.GetUniformLocation(between, "last_");
  programs.between.use();
  gl.Uniform4f(gl.GetUniformLocation(between, "tolerance"),
               static_cast<float>(std::max(params.solver.tolerance, least_tolerance(precision))),
               static_cast<float>(kFrictionTolerance), 0, 0);
  gl.BindBuffer(GL_DISPATCH_INDIRECT_BUFFER, buffers.id(Slot::arguments));
  gl.MemoryBarrier(GL_COMMAND_BARRIER_BIT);
  for (int k = 0; k < params.solver.iterations; ++k) {
    programs.sweep.use();
    gl.Uniform1i(limits, k > 0 && params.contact.mu_static > 0);
    for (std::uint32_t c = 0; c < color_limit; ++c) {
      gl.Uniform1ui(color, c);
      gl.DispatchComputeIndirect(static_cast<GLintptr>(16 * c));
      gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    }
    programs.between.use();
    gl.Uniform1i(last_place, k + 1 == params.solver.iterations);
    gl.DispatchCompute(1, 1, 1);
    gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
  }
}

void DeviceSolver::Impl::make_step(const Params& params) {
  const std::uint32_t body_groups = groups(bodies, kGroup), contact_groups = groups(contact_room, kGroup);
  set_params(params);
  constexpr std::size_t kKept = sizeof(Counters::overflow);
  buffers.clear(Slot::counters, kKept, sizeof(Counters) - kKept);
  clock.start();
  find_pairs();  // 1. free flight: Q*; who may touch whom
  clock.lap(times.broad_phase);
  find_contacts();  // 2. bonds of this step, S(17)
  clock.lap(times.narrow_phase);
  list_ends();
  color_bodies();
  dispatch(programs.start_bodies, body_groups);
  dispatch(programs.start_contacts, contact_groups);
  clock.lap(times.set_up);
  sweep(params);  // 3. minimise E
  clock.lap(times.solve);
  dispatch(programs.tell, contact_groups);
  if (options.report_contacts) dispatch(programs.reports, contact_groups);
  set(programs.total_contacts, "count", contact_groups);
  dispatch(programs.total_contacts, 1);
  dispatch(programs.keep, groups(std::max(pair_room, bodies + 1), kGroup));
  dispatch(programs.finish, body_groups);  // 4. velocities
  set(programs.total_bodies, "count", body_groups);
  dispatch(programs.total_bodies, 1);
  clock.lap(times.velocities);
}

// --- steps under way -------------------------------------------------------------------------------------

void DeviceSolver::Impl::ask(const Params& params) {
  make_step(params);
  Asked now{params, law.barrier.kappa, GlBuffer(gl), nullptr};
  gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  gl.BindBuffer(GL_COPY_WRITE_BUFFER, now.copy.id());
  gl.BufferData(GL_COPY_WRITE_BUFFER, sizeof(Counters), nullptr, GL_STREAM_READ);
  gl.BindBuffer(GL_COPY_READ_BUFFER, buffers.id(Slot::counters));
  gl.CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, sizeof(Counters));
  now.done = gl.FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.Flush();
  asked.push_back(std::move(now));
}

void DeviceSolver::Impl::report(const Asked& step, const Counters& c) {
  const Params& params = step.params;
  ++step_number;
  time += params.h;
  summary = {};
  summary.step = step_number;
  summary.time = time;
  summary.method = SolverMethod::descent;
  summary.iterations = static_cast<int>(c.sweeps);
  summary.kinetic = c.kinetic;
  summary.potential = c.potential;
  summary.elastic = c.elastic;
  summary.kappa = step.kappa;
  summary.contacts = static_cast<int>(c.pushing);
  summary.min_gap = c.min_gap != 0 ? static_cast<double>(from_ordered(~c.min_gap)) : INFINITY;
  summary.max_penetration = std::max(0.0, -summary.min_gap);
  summary.residual = static_cast<double>(std::bit_cast<float>(c.residual));
  summary.friction_excess =
      c.friction_excess != 0 ? std::max(0.0, static_cast<double>(from_ordered(c.friction_excess))) : 0;
  const bool settled =
      c.friction_error == 0 || from_ordered(c.friction_error) < static_cast<float>(2 * kFrictionTolerance);
  const bool done = c.done != 0 || c.contacts == 0;
  summary.status = c.bad > 0         ? StepStatus::non_finite
                   : done && settled ? StepStatus::converged
                                     : StepStatus::iteration_limit;
  summary.times.detect = times.broad_phase + times.narrow_phase;
  summary.times.set_up = times.set_up;
  summary.times.solve = times.solve;
  summary.times.velocities = times.velocities;
  summary.times.total = times.total();
  d_hat = params.contact.d_hat;
  // Neither changes a result: of too few colors the step is made again, too few rounds are followed by others.
  rounds = std::clamp(c.rounds + 2, 4u, 64u);
  color_limit = std::min(c.colors + 2, kMaxColors);
  last = c;
}

// Larger buffers for what was too small; the GPU may go on then.
void DeviceSolver::Impl::make_room(const Counters& c) {
  const auto more = [](std::uint32_t needed, std::uint32_t room) {
    return static_cast<std::uint32_t>(kMoreRoom * std::max(needed, room / 2)) + 1024;
  };
  if ((c.overflow & too_many_pairs) != 0) make_pair_buffers(std::max(pair_room, more(c.pairs, pair_room)));
  if ((c.overflow & too_many_contacts) != 0)
    make_contact_buffers(std::max(contact_room, more(c.raw, contact_room)));
  if ((c.overflow & too_many_colors) != 0) {
    if (color_limit == kMaxColors) {
      throw Error(ErrorKind::no_context, "the bodies that touch each other need more than " +
                                             std::to_string(kMaxColors) + " colors: --device cpu");
    }
    color_limit = kMaxColors;
  }
  buffers.clear(Slot::counters, 0, sizeof(Counters::overflow));
}

void DeviceSolver::Impl::take_oldest() {
  Asked oldest = std::move(asked.front());
  asked.pop_front();
  while (true) {
    const GLenum state = gl.ClientWaitSync(oldest.done, GL_SYNC_FLUSH_COMMANDS_BIT, 100'000'000);
    if (state == GL_ALREADY_SIGNALED || state == GL_CONDITION_SATISFIED) break;
    if (state == GL_WAIT_FAILED) throw Error(ErrorKind::no_context, "the GPU was lost: --device cpu");
  }
  gl.DeleteSync(oldest.done);
  Counters c;
  gl.BindBuffer(GL_COPY_WRITE_BUFFER, oldest.copy.id());
  gl.GetBufferSubData(GL_COPY_WRITE_BUFFER, 0, sizeof c, &c);
  if (c.overflow == 0) {
    clock.read();
    report(oldest, c);
    return;
  }
  // Neither this step was made nor those that were asked for after it: all again, with more room.
  std::vector<Params> repeat{oldest.params};
  for (Asked& next : asked) {
    gl.DeleteSync(next.done);
    repeat.push_back(next.params);
  }
  asked.clear();
  make_room(c);
  repeated += static_cast<int>(repeat.size());
  for (const Params& params : repeat) {
    ask(params);
    if (asked.size() > 1) take_oldest();  // it may not fit either
  }
}

// --- from outside ----------------------------------------------------------------------------------------

DeviceSolver::DeviceSolver(GlContext& context, const Model& model, const State& start,
                           const DeviceOptions& options)
    : impl_(std::make_unique<Impl>(context, model, options)) {
  set_state(start);
}
DeviceSolver::~DeviceSolver() = default;
DeviceSolver::DeviceSolver(DeviceSolver&&) noexcept = default;

std::string DeviceSolver::why_not(const Model& model, const Params& params) {
  if (!model.joints.empty()) return "the scene has joints, which the GPU does not take: --device cpu";
  if (params.contact.barrier == BarrierKind::log)
    return "the log barrier is not solved on the GPU: --device cpu, or another \"barrier\"";
  return why_not_on_device(model);
}

void DeviceSolver::set_state(const State& state) {
  finish();
  Impl& m = *impl_;
  write_poses(state, m.precision, m.buffers);
  write_memory(state, m.model, m.precision, m.buffers, m.last);
  m.step_number = state.step;
  m.time = state.time;
}

void DeviceSolver::enqueue(const Params& params) {
  Impl& m = *impl_;
  while (m.asked.size() >= kLate) m.take_oldest();
  m.ask(params);
}

const StepSummary& DeviceSolver::finish() {
  while (!impl_->asked.empty()) impl_->take_oldest();
  return impl_->summary;
}

void DeviceSolver::read_state(State& out, bool memory) {
  finish();
  Impl& m = *impl_;
  read_poses(m.precision, m.buffers, m.bodies, out);
  out.contacts.clear();
  if (memory) read_memory(m.last.pairs, m.precision, m.buffers, out);
  out.step = m.step_number;
  out.time = m.time;
  out.joint_force.clear();
}

void DeviceSolver::read_contacts(std::vector<ContactReport>& out) {
  finish();
  device::read_contacts(impl_->last.contacts, impl_->d_hat, impl_->buffers, out);
}

void DeviceSolver::read_colors(std::vector<int>& out) {
  finish();
  device::read_colors(impl_->bodies, impl_->buffers, out);
}

const DeviceTimes& DeviceSolver::times() const { return impl_->times; }
std::size_t DeviceSolver::bytes() const { return impl_->buffers.total(); }
int DeviceSolver::colors() const { return static_cast<int>(impl_->last.colors); }
std::uint32_t DeviceSolver::pairs() const { return impl_->last.pairs; }
std::uint32_t DeviceSolver::contacts() const { return impl_->last.contacts; }
std::uint32_t DeviceSolver::kept_pairs() const { return impl_->last.kept; }
int DeviceSolver::repeated() const { return impl_->repeated; }
unsigned DeviceSolver::pose_buffer() const { return impl_->buffers.id(Slot::poses); }

}  // namespace pabd
