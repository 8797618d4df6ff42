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
  void ask(const Params& params);
  void take_oldest();
  void report(const Asked& asked_for, const Counters& c);

  DeviceStep step;
  std::deque<Asked> asked;
  StepSummary summary;  // of the last step that was made
  Counters last{};
  DeviceTimes times;
  double d_hat = 0;
  std::int64_t step_number = 0;
  double time = 0;
  int repeated = 0;
};

void DeviceSolver::Impl::ask(const Params& params) {
  step.enqueue(params, step_number == 0 && asked.empty(), times);
  Asked now{params, step.kappa(), GlBuffer(step.gl), {}};
  step.gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  step.gl.BindBuffer(GL_COPY_WRITE_BUFFER, now.copy.id());
  step.gl.BufferData(GL_COPY_WRITE_BUFFER, sizeof(Counters), nullptr, GL_STREAM_READ);
  step.gl.BindBuffer(GL_COPY_READ_BUFFER, step.buffers.id(Slot::counters));
  step.gl.CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, sizeof(Counters));
  now.done = GlFence(step.gl);
  step.gl.Flush();
  asked.push_back(std::move(now));
}

void DeviceSolver::Impl::report(const Asked& asked_for, const Counters& c) {
  const Params& params = asked_for.params;
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
  summary.kappa = asked_for.kappa;
  summary.contacts = static_cast<int>(c.pushing);
  summary.min_gap = c.min_gap != 0 ? static_cast<double>(from_ordered(~c.min_gap)) : INFINITY;
  summary.max_penetration = std::max(0.0, -summary.min_gap);
  summary.residual = static_cast<double>(std::bit_cast<float>(c.residual));
  summary.friction_excess =
      c.friction_excess != 0 ? std::max(0.0, static_cast<double>(from_ordered(c.friction_excess))) : 0;
  const bool settled =
      c.friction_error == 0 || from_ordered(c.friction_error) < static_cast<float>(2 * kFrictionTolerance);
  const bool done = c.done != 0 || c.contacts == 0 || summary.residual < least_tolerance(step.precision());
  summary.status = c.bad > 0 || gain_of(c).ran_away(params.h) ? StepStatus::non_finite
                   : done && settled                          ? StepStatus::converged
                                                              : StepStatus::iteration_limit;
  summary.times.detect = times.broad_phase + times.narrow_phase;
  summary.times.set_up = times.set_up;
  summary.times.solve = times.solve;
  summary.times.velocities = times.velocities;
  summary.times.total = times.total();
  d_hat = params.contact.d_hat;
  step.expect(c);
  last = c;
}

void DeviceSolver::Impl::take_oldest() {
  Asked oldest = std::move(asked.front());
  asked.pop_front();
  oldest.done.wait();
  Counters c;
  step.gl.BindBuffer(GL_COPY_WRITE_BUFFER, oldest.copy.id());
  step.gl.GetBufferSubData(GL_COPY_WRITE_BUFFER, 0, sizeof c, &c);
  if (c.overflow == 0) {
    step.clock.read();
    report(oldest, c);
    return;
  }
  // Neither this step was made nor those that were asked for after it: all again, with more room.
  std::vector<Params> repeat{oldest.params};
  for (const Asked& next : asked) repeat.push_back(next.params);
  asked.clear();
  step.make_room(c);
  repeated += static_cast<int>(repeat.size());
  for (const Params& params : repeat) {
    ask(params);
    if (asked.size() > 1) take_oldest();  // it may not fit either
  }
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
  m.ask(params);
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
