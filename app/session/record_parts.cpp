// SPDX-License-Identifier: MIT
// See record_parts.h.
#include "app/session/record_parts.h"

#include <cmath>
#include <type_traits>
#include <utility>
#include <variant>

#include "sim/solver/step_numbers.h"

namespace pabd {
namespace {

constexpr std::size_t kBodyBytes = 18 * 8, kMemoryBytes = 8 + 4 + 3 * 8 + 1;

}  // namespace

void write_state(const State& s, ByteWriter& out) {
  out.number(s.time);
  out.u64(static_cast<std::uint64_t>(s.step));
  out.u32(s.c.size());
  for (std::size_t i = 0; i < s.c.size(); ++i) {
    each_body_array([&](const auto& array) { out.matrix(array[i]); }, s);
  }
  out.u32(s.contacts.size());
  for (const ContactMemory& a : s.contacts) {
    out.u64(a.pair);
    out.u32(a.feature);
    out.matrix(a.stretch);
    out.u8(static_cast<std::uint8_t>(flags_of(a)));
  }
  out.u32(s.joint_force.size());
  for (const Vec3& force : s.joint_force) out.matrix(force);
  out.u32(s.change.size());
  for (const StepChange& change : s.change)
    for (const double x : numbers_of(change)) out.number(x);
  out.u32(s.coupling.size());
  for (const double error : s.coupling) out.number(error);
}

// Every number of the step, and of the times what plots show: a report that is read has detect and set_up as one.
void write_report(const StepSummary& r, ByteWriter& out) {
  out.u8(static_cast<std::uint8_t>(r.method));
  out.u8(static_cast<std::uint8_t>(r.status));
  for (const StepNumber& number : step_numbers()) out.number(number.value(r));
  for (const double x : {r.times.detect + r.times.set_up, r.times.solve, r.times.total}) out.number(x);
}

State read_state(ByteReader& in, Index bodies) {
  State s;
  s.time = in.finite();
  s.step = static_cast<std::int64_t>(in.u64());
  const std::size_t n = in.count(kBodyBytes);
  in.require(n == static_cast<std::size_t>(bodies), "a state has another number of bodies than its model");
  each_body_array([&](auto& array) { array.resize(n); }, s);
  for (std::size_t i = 0; i < n; ++i) {
    each_body_array([&](auto& array) { in.matrix(array[i]); }, s);
    const Mat3 off = s.R[i].transpose() * s.R[i] - Mat3::Identity();
    in.require(off.cwiseAbs().maxCoeff() < 1e-6 && s.R[i].determinant() > 0, "an orientation is no rotation");
  }
  s.contacts.resize(in.count(kMemoryBytes));
  const auto order = [](const ContactMemory& a) { return std::pair(a.pair, a.feature); };
  for (std::size_t k = 0; k < s.contacts.size(); ++k) {
    ContactMemory& a = s.contacts[k];
    a.pair = in.u64();
    a.feature = in.u32();
    in.matrix(a.stretch);
    const std::uint8_t flags = in.u8();
    in.require(flags <= kMemoryFlags, "a contact has a flag that is none");
    set_flags(flags, a);
    in.require(a.pair >> 32 < n && (a.pair & 0xffffffffu) < n, "a contact is of a body that is none");
    in.require(k == 0 || order(s.contacts[k - 1]) < order(a), "contacts are out of order");
  }
  s.joint_force.resize(in.count(sizeof(Vec3)));
  for (Vec3& force : s.joint_force) in.matrix(force);
  s.change.resize(in.count(sizeof(StepChange)));
  in.require(s.change.empty() || s.change.size() == n, "a state remembers other bodies than it has");
  for (StepChange& change : s.change) {
    StepChangeNumbers numbers;
    for (double& x : numbers) x = in.finite();
    change = step_change(numbers);
  }
  s.coupling.resize(in.count(sizeof(double)));
  for (double& error : s.coupling) error = in.finite();
  return s;
}

StepSummary read_report(ByteReader& in) {
  StepSummary r;
  const std::uint8_t method = in.u8(), status = in.u8();
  in.require(method <= static_cast<std::uint8_t>(SolverMethod::automatic) &&
                 status <= static_cast<std::uint8_t>(StepStatus::non_finite),
             "a solver or its outcome is unknown");
  r.method = static_cast<SolverMethod>(method);
  r.status = static_cast<StepStatus>(status);
  for (const StepNumber& number : step_numbers()) {
    const double x = in.number();
    const auto take = [&](auto member) {
      using Number = std::remove_reference_t<decltype(r.*member)>;
      if constexpr (std::is_integral_v<Number>) {
        const double most = sizeof(Number) == 4 ? 1 << 30 : 0x1p53;
        in.require(x >= 0 && x <= most && x == std::floor(x), "a count is none");
        r.*member = static_cast<Number>(x);
      } else {
        r.*member = x;
      }
    };
    std::visit(take, number.member);
  }
  in.require(std::isfinite(r.time), "a number is not finite");
  for (double* x : {&r.times.detect, &r.times.solve, &r.times.total}) *x = in.number();
  return r;
}

}  // namespace pabd
