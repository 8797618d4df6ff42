// SPDX-License-Identifier: MIT
// A model in two parts that do not feel each other: what hangs together by joints with all that is near it, and the
// rest. Each can be solved by somebody else in the same step; what is fixed belongs to both.
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
  std::vector<Index> bodies;  // number in the whole of each
  std::vector<Index> place;   // number in the part of each of the whole, −1: it is elsewhere

  bool holds(Index body) const { return place[static_cast<std::size_t>(body)] >= 0; }
};

struct ModelParts {
  ModelPart jointed, free;
};

// 1 for each movable body that hangs on a joint, or is near such a one at `state`, or near one that is …: nobody else
// is within what the bodies of a step reach. Linear in the number of bodies, about.
std::vector<std::uint8_t> jointed_bodies(const Model& model, const Params& params, const State& state);

// `jointed`: as jointed_bodies() gives it. All joints are in that part.
ModelParts split_model(const Model& model, const std::vector<std::uint8_t>& jointed);

// Two bodies of different parts that a step from `state` might bring together; none: the parts do not feel each other.
std::optional<std::pair<Index, Index>> coupling(const Model& model, const ModelParts& parts,
                                                const Params& params, const State& state);

// The part's bodies and what its contacts remember, and back: of the whole everything else stays. Joint forces go with
// `joints`.
void take_part(const ModelPart& part, const State& whole, bool joints, State& out);
void put_part(const ModelPart& part, const State& state, bool joints, State& whole);
// Contacts of the part in numbers of the whole; sorted by pair with those that are there.
void put_contacts(const ModelPart& part, const std::vector<ContactReport>& contacts,
                  std::vector<ContactReport>& whole);

}  // namespace pabd
