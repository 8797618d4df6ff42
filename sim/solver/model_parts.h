// SPDX-License-Identifier: MIT
// Some bodies of a model as a model of its own, where the others do not feel them in a step: those that hang on joints,
// which another device leaves to the processor, or islands that are solved again (halving.h). What is fixed belongs to
// every part.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/solver/params.h"
#include "sim/solver/report.h"

namespace pabd {

// Some bodies of a model as a model of its own, in the same order.
struct ModelPart {
  Model model;
  std::vector<Index> bodies;     // number in the whole of each
  std::vector<Index> joints;     // the same of its joints
  std::vector<Index> couplings;  // the same of its couplings, State::coupling
  std::vector<Index> place;      // number in the part of each body of the whole, −1: it is elsewhere

  bool holds(Index body) const { return place[body] >= 0; }
};

struct ModelParts {
  ModelPart jointed, free;
};

// 1 for each movable body that hangs on a joint, or is near such a one at `state`, or near one that is …: nobody else
// is within what the bodies of a step reach. Linear in the number of bodies, about.
std::vector<std::uint8_t> jointed_bodies(const Model& model, const Params& params, const State& state);

// The movable bodies i with chosen[i], what is fixed, and the joints of these. Memory of `out` is used again.
void take_bodies(const Model& model, const std::vector<std::uint8_t>& chosen, ModelPart& out);

// `jointed`: as jointed_bodies() gives it. All joints are in that part.
ModelParts split_model(const Model& model, const std::vector<std::uint8_t>& jointed);

// Two bodies of different parts that a step from `state` might bring together; none: the parts do not feel each other.
std::optional<std::pair<Index, Index>> coupling(const Model& model, const ModelParts& parts,
                                                const Params& params, const State& state);

// The part's bodies, what its contacts remember and the forces of its joints, and back: of the whole everything else stays.
void take_part(const ModelPart& part, const State& whole, State& out);
void put_part(const ModelPart& part, const State& state, State& whole);
// Contacts of the part in numbers of the whole; sorted by pair with those that are there.
void put_contacts(const ModelPart& part, const std::vector<ContactReport>& contacts,
                  std::vector<ContactReport>& whole);
// Of both: sums, the worst of each, contacts and islands by their numbers in the whole.
void add_report(const ModelPart& part, const StepReport& of_part, StepReport& whole);

}  // namespace pabd
