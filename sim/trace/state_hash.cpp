// SPDX-License-Identifier: MIT
// A number that tells two states apart, bit by bit. See trace.h.
#include "sim/base/hash.h"
#include "sim/trace/trace.h"

namespace pabd {

namespace {

template <class Matrix>
void add(Hash64& hash, const Matrix& m) {
  for (Eigen::Index i = 0; i < m.size(); ++i) hash.add_number(m.data()[i]);
}

}  // namespace

std::string state_hash(const State& state) {
  Hash64 hash;
  hash.add_number(state.time);
  hash.add_word(static_cast<std::uint64_t>(state.step));
  hash.add_word(state.c.size());
  for (std::size_t i = 0; i < state.c.size(); ++i) {
    each_body_array([&](const auto& array) { add(hash, array[i]); }, state);
  }
  hash.add_word(state.contacts.size());
  for (const ContactMemory& contact : state.contacts) {
    hash.add_word(contact.pair);
    hash.add_word(contact.feature);
    add(hash, contact.stretch);
    hash.add_word(flags_of(contact));
  }
  for (const Vec3& force : state.joint_force) add(hash, force);
  for (const StepChange& change : state.change)
    for (const double x : numbers_of(change)) hash.add_number(x);
  for (const double error : state.coupling) hash.add_number(error);
  return hash.hex();
}

}  // namespace pabd
