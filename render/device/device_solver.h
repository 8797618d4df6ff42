// SPDX-License-Identifier: MIT
// The solver of contacts on a GPU: a whole time step in compute shaders, in the OpenGL context that draws. It minimises
// the same E as `descent` (sim/solver/descent.h) and keeps the same memory of friction.
//
// The same GPU gives the same bits in every run: no sum depends on who comes first.
#pragma once

#include <memory>
#include <string>

#include "render/context/context.h"
#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/solver/params.h"
#include "sim/solver/report.h"

namespace pabd {

enum class DevicePrecision { single, twofold };  // float, or double for comparison with the processor

struct DeviceOptions {
  DevicePrecision precision = DevicePrecision::single;
  // Room at first, and more when a step needs it; 0: by the number of bodies.
  std::uint32_t pairs = 0, contacts = 0;
  bool time_phases = false;      // fills DeviceTimes
  bool report_contacts = false;  // for read_contacts()
  // Flat bodies that moved against each other by less than 0.05 d̂ since their contacts were found keep them: a point of
  // one over a plane of the other.
  bool keep_contacts = true;
  // Threads that share the contacts of a body in a sweep: 1, 2, 4 … 32; 0: by the number of bodies, more where there are
  // few. Sums are made in another order for each.
  int team = 0;
  int few = 0;    // a body with more contacts than that is shared by eight; 0: 12 where the team is smaller
  int crowd = 0;  // one with more than that, by a whole work group; 0: 64
};

// On the GPU's own clock; ms. Of the last step that was made.
struct DeviceTimes {
  double broad_phase = 0;   // free flight, grid, pairs
  double narrow_phase = 0;  // contact points
  double set_up = 0;        // memory of friction, lists, colors, first iterate
  double solve = 0;         // sweeps
  double velocities = 0;    // report, memory, velocities, poses
  double total() const { return broad_phase + narrow_phase + set_up + solve + velocities; }
};

// Of the bodies in touch in a step, as in sim/solver/runaway.h. Shaders judge it (device_unsolved.glsl).
struct DeviceGain {
  double gained = 0;   // kinetic energy beside that of free flight; J
  double width = 0;    // around where they started, and the widest opening of a contact there: L; m
  double fastest = 0;  // √(2K/m) of one that gained; m/s
};

// A number a body, to colour it by.
enum class BodyQuantity {
  speed,   // of the centre of mass; m/s
  energy,  // kinetic, and half of that of each of its contacts; J
};

// What a step tells of its contacts: GL names of buffers.
struct DeviceContacts {
  unsigned told = 0;      // device::ContactTold (device_layout.h); 0: there are none
  unsigned counters = 0;  // device::Counters
  std::size_t room = 0;   // of told, in contacts
};

class DeviceSolver {
 public:
  // `context` is current, and stays so in all calls. Precondition: why_not() is empty. Throws Error(no_context) where
  // the context cannot take it.
  DeviceSolver(GlContext& context, const Model& model, const State& start, const DeviceOptions& options = {});
  ~DeviceSolver();
  DeviceSolver(DeviceSolver&&) noexcept;

  // Why the GPU cannot take the scene, in one line with the remedy; empty: it can.
  static std::string why_not(const Model& model, const Params& params);

  void set_state(const State& state);

  // Starts a step and does not wait for it, but for the one two steps before. Where that one did not fit into its buffers,
  // or ended unsolved, it is made again first, with larger ones or in halves: nothing is dropped.
  void enqueue(const Params& params);
  // Waits for all steps; the report of the last one.
  const StepSummary& finish();
  const StepSummary& step(const Params& params) {
    enqueue(params);
    return finish();
  }

  // After finish(). `memory`: with what contacts remember, which the next step needs only where it is made elsewhere.
  void read_state(State& out, bool memory = true);
  // Of the last step, those with d < d̂, sorted by pair as the processor has them. Precondition:
  // options.report_contacts, and a step was made.
  void read_contacts(std::vector<ContactReport>& out);
  // The color of each body that touches another one, −1 of the others: those of one color were solved at once.
  void read_colors(std::vector<int>& out);

  const DeviceTimes& times() const;
  std::size_t bytes() const;         // of all buffers
  int colors() const;                // of the last step
  std::uint32_t pairs() const;       // of the last step
  std::uint32_t contacts() const;    // within reach
  std::uint32_t kept_pairs() const;  // whose contacts were kept in the last step
  DeviceGain gain() const;           // of the last step
  int repeated() const;              // steps that had to be made again with larger buffers
  int halved() const;                // in halves
  unsigned pose_buffer() const;      // GL name: a body's c (4 doubles), q (4 doubles: x, y, z, w)
  std::size_t pose_bytes() const;    // of it
  // GL name: a float a body, as the step that was asked for last leaves it, -infinity of bodies that do not move. Waits
  // for nothing; energies of contacts are 0 before the first step. Filled by each call, the same buffer for all.
  unsigned value_buffer(BodyQuantity quantity);
  // Of the step that was asked for last, for DeviceBodies::mark_contacts(); good until the next one is asked for.
  // Precondition: options.report_contacts.
  DeviceContacts contact_buffers() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pabd
