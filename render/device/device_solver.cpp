// SPDX-License-Identifier: MIT
// Steps under way on the GPU: what they told is looked at late, and those that did not fit are made again.
#include "render/device/device_solver.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <deque>
#include <utility>

#include "render/device/device_state.h"
#include "render/device/device_step.h"
#include "render/device/gl_fence.h"
#include "sim/solver/friction.h"
#include "sim/solver/halving.h"
#include "sim/solver/restitution.h"
#include "sim/solver/turn_friction.h"

namespace pabd {
namespace {

using namespace device;

constexpr int kLate = 2;  // steps that may be under way

// Steps over d̂ that are no longer than this are those of rounding: who asks for less gets all sweeps.
double least_tolerance(Precision precision) { return precision == Precision::single ? 2e-7 : 0; }

DeviceGain gain_of(const Counters& c) {
  DeviceGain out;
  if (c.width[3] == 0) return out;  // nothing touched
  Vec3 width;
  for (int axis = 0; axis < 3; ++axis)
    width[axis] = static_cast<double>(from_ordered(c.width[3 + axis])) -
                  static_cast<double>(from_ordered(~c.width[axis]));
  out.gained = c.gained;
  out.width = width.norm() + static_cast<double>(std::bit_cast<float>(c.opening));
  out.fastest = std::sqrt(static_cast<double>(std::bit_cast<float>(c.fastest)));
  return out;
}

}  // namespace

struct DeviceSolver::Impl {
  Impl(GlContext& context, const Model& model, const DeviceOptions& options)
      : step(context, model, options) {}

  struct Asked {
    Params params;
    double kappa;
    GlBuffer copy;  // of the counters, when the step is done
    GlFence done;
  };
  Asked ask(const Params& params, bool starts);
  Counters wait_for(Asked& asked_for);
  PhaseTimes spent();
  StepSummary told(const Asked& asked_for, const Counters& c);
  StepSummary ended(Asked asked_for, Counters c, bool starts);
  void take_oldest();
  void record(const StepSummary& made, double h);
  bool starts() const { return step_number == 0 && asked.empty(); }

  DeviceStep step;
  std::deque<Asked> asked;
  StepSummary summary;  // of the last step that was made
  Counters last{};
  DeviceTimes times;
  double d_hat = 0;
  std::int64_t step_number = 0;
  double time = 0;
  int repeated = 0, halved = 0;
};

auto DeviceSolver::Impl::ask(const Params& params, bool starts) -> Asked {
  step.enqueue(params, starts, times);
  Asked now{params, step.kappa(), GlBuffer(step.gl), {}};
  step.gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  step.gl.BindBuffer(GL_COPY_WRITE_BUFFER, now.copy.id());
  step.gl.BufferData(GL_COPY_WRITE_BUFFER, sizeof(Counters), nullptr, GL_STREAM_READ);
  step.gl.BindBuffer(GL_COPY_READ_BUFFER, step.buffers.id(Slot::counters));
  step.gl.CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, sizeof(Counters));
  now.done = GlFence(step.gl);
  step.gl.Flush();
  return now;
}

Counters DeviceSolver::Impl::wait_for(Asked& asked_for) {
  asked_for.done.wait();
  Counters c;
  step.gl.BindBuffer(GL_COPY_WRITE_BUFFER, asked_for.copy.id());
  step.gl.GetBufferSubData(GL_COPY_WRITE_BUFFER, 0, sizeof c, &c);
  return c;
}

// In the step that was waited for last.
PhaseTimes DeviceSolver::Impl::spent() {
  step.clock.read();
  PhaseTimes out;
  out.detect = times.broad_phase + times.narrow_phase;
  out.set_up = times.set_up;
  out.solve = times.solve;
  out.velocities = times.velocities;
  out.total = times.total();
  return out;
}

// Of a step that was made.
StepSummary DeviceSolver::Impl::told(const Asked& asked_for, const Counters& c) {
  StepSummary out;
  out.method = SolverMethod::descent;
  out.iterations = static_cast<int>(c.sweeps);
  out.kinetic = c.kinetic;
  out.potential = c.potential;
  out.elastic = c.elastic;
  out.kappa = asked_for.kappa;
  out.contacts = static_cast<int>(c.pushing);
  out.min_gap = c.min_gap != 0 ? static_cast<double>(from_ordered(~c.min_gap)) : INFINITY;
  out.max_penetration = std::max(0.0, -out.min_gap);
  out.max_normal_force = c.force != 0 ? static_cast<double>(from_ordered(c.force)) : 0;
  out.residual = static_cast<double>(std::bit_cast<float>(c.residual));
  out.friction_excess =
      c.friction_excess != 0 ? std::max(0.0, static_cast<double>(from_ordered(c.friction_excess))) : 0;
  const bool settled =
      c.friction_error == 0 || from_ordered(c.friction_error) < static_cast<float>(2 * kFrictionTolerance);
  const bool done = c.done != 0 || c.contacts == 0 || out.residual < least_tolerance(step.precision());
  out.status = c.bad > 0         ? StepStatus::non_finite
               : done && settled ? StepStatus::converged
                                 : StepStatus::iteration_limit;
  out.times = spent();
  d_hat = asked_for.params.contact.d_hat;
  step.expect(c);
  last = c;
  return out;
}

void DeviceSolver::Impl::record(const StepSummary& made, double h) {
  summary = made;
  summary.step = ++step_number;
  summary.time = time += h;
}

// A step that told c, once it is made: with more room until it fits, in halves where it ended unsolved.
StepSummary DeviceSolver::Impl::ended(Asked asked_for, Counters c, bool starts) {
  while (c.overflow != 0 && c.overflow != ended_unsolved) {
    step.make_room(c);
    ++repeated;
    asked_for = ask(asked_for.params, starts);
    c = wait_for(asked_for);
  }
  if (c.overflow == 0) return told(asked_for, c);
  const PhaseTimes in_vain = spent();
  step.make_room(c);
  const auto half = [&](bool first) {
    Asked now = ask(of_half(asked_for.params, asked_for.kappa), first && starts);
    const Counters counters = wait_for(now);
    return ended(std::move(now), counters, first && starts);
  };
  StepSummary out = half(true);
  if (out.status != StepStatus::non_finite) out = both(out, half(false));
  out.times += in_vain;
  ++halved;
  out.halved_bodies = step.movable();
  ++out.halvings;
  return out;
}

void DeviceSolver::Impl::take_oldest() {
  Asked oldest = std::move(asked.front());
  asked.pop_front();
  const Counters c = wait_for(oldest);
  std::deque<Asked> after;
  if (c.overflow != 0) after.swap(asked);  // they were not made either
  const double h = oldest.params.h;
  record(ended(std::move(oldest), c, starts()), h);
  for (const Asked& next : after) asked.push_back(ask(next.params, false));
}

DeviceSolver::DeviceSolver(GlContext& context, const Model& model, const State& start,
                           const DeviceOptions& options)
    : impl_(std::make_unique<Impl>(context, model, options)) {
  set_state(start);
}
DeviceSolver::~DeviceSolver() = default;
DeviceSolver::DeviceSolver(DeviceSolver&&) noexcept = default;

std::string DeviceSolver::why_not(const Model& model, const Params& params) {
  if (!model.joints.empty()) return "the scene has joints, which the GPU does not take: --device cpu";
  if (has_restitution(model, params.contact))
    return "the scene has restitution, which the GPU does not take: --device cpu";
  if (params.contact.damping > 0)
    return "the scene has contact.damping, which the GPU does not take: --device cpu";
  if (has_turn_friction(model, params.contact))
    return "the scene has torsional or rolling friction, which the GPU does not take: --device cpu";
  if (!model.surface_velocity.empty())
    return "surfaces of bodies move of themselves, which the GPU does not take: --device cpu";
  if (!model.external.empty()) return "forces act on bodies, which the GPU does not take: --device cpu";
  if (const BarrierKind kind = params.contact.barrier; !is_on_device(kind))
    return std::string("the ") + to_string(kind) +
           " barrier is not solved on the GPU: --device cpu, or another \"barrier\"";
  const std::string why = why_not_on_device(model);
  return why.empty() ? why : why + ": --device cpu";
}

void DeviceSolver::set_state(const State& state) {
  finish();
  Impl& m = *impl_;
  write_poses(state, m.step.precision(), m.step.buffers);
  write_memory(state, m.step.model(), m.step.precision(), m.step.buffers, m.last);
  m.step.buffers.clear(Slot::end_first);  // nobody knows of contacts before the next step
  m.step_number = state.step;
  m.time = state.time;
}

void DeviceSolver::enqueue(const Params& params) {
  Impl& m = *impl_;
  while (m.asked.size() >= kLate) m.take_oldest();
  m.asked.push_back(m.ask(params, m.starts()));
}

const StepSummary& DeviceSolver::finish() {
  while (!impl_->asked.empty()) impl_->take_oldest();
  return impl_->summary;
}

void DeviceSolver::read_state(State& out, bool memory) {
  finish();
  Impl& m = *impl_;
  read_poses(m.step.precision(), m.step.buffers, m.step.bodies(), out);
  out.contacts.clear();
  if (memory) read_memory(m.last.pairs, m.step.precision(), m.step.buffers, out);
  out.step = m.step_number;
  out.time = m.time;
  out.joint_force.clear();
  out.change.clear();
}

void DeviceSolver::read_contacts(std::vector<ContactReport>& out) {
  finish();
  device::read_contacts(impl_->last.contacts, impl_->d_hat, impl_->step.buffers, out);
}

void DeviceSolver::read_colors(std::vector<int>& out) {
  finish();
  device::read_colors(impl_->step.bodies(), impl_->step.buffers, out);
}

const DeviceTimes& DeviceSolver::times() const { return impl_->times; }
std::size_t DeviceSolver::bytes() const { return impl_->step.buffers.total(); }
int DeviceSolver::colors() const { return static_cast<int>(impl_->last.colors); }
std::uint32_t DeviceSolver::pairs() const { return impl_->last.pairs; }
std::uint32_t DeviceSolver::contacts() const { return impl_->last.contacts; }
std::uint32_t DeviceSolver::kept_pairs() const { return impl_->last.kept; }
DeviceGain DeviceSolver::gain() const { return gain_of(impl_->last); }
int DeviceSolver::repeated() const { return impl_->repeated; }
int DeviceSolver::halved() const { return impl_->halved; }
unsigned DeviceSolver::pose_buffer() const { return impl_->step.buffers.id(Slot::poses); }
std::size_t DeviceSolver::pose_bytes() const { return impl_->step.buffers.bytes(Slot::poses); }
DeviceContacts DeviceSolver::contact_buffers() const {
  const Buffers& buffers = impl_->step.buffers;
  return {buffers.id(Slot::told), buffers.id(Slot::counters),
          buffers.bytes(Slot::told) / sizeof(ContactTold)};
}
unsigned DeviceSolver::value_buffer(BodyQuantity quantity) {
  impl_->step.tell_values(quantity);
  return impl_->step.buffers.id(Slot::body_values);
}

}  // namespace pabd
