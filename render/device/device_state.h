// SPDX-License-Identifier: MIT
// A State in the arrays of the GPU, there and back.
#pragma once

#include "render/device/device_buffers.h"
#include "render/device/device_programs.h"
#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/solver/report.h"

namespace pabd::device {

std::size_t pair_size(Precision precision);  // bytes of a Pair

void write_poses(const State& state, Precision precision, Buffers& buffers);
void read_poses(Precision precision, const Buffers& buffers, std::uint32_t bodies, State& out);

// What contacts remember; `counters` then has their number of pairs.
void write_memory(const State& state, const Model& model, Precision precision, Buffers& buffers,
                  Counters& counters);
void read_memory(std::uint32_t pairs, Precision precision, const Buffers& buffers, State& out);

// See DeviceSolver.
void read_contacts(std::uint32_t contacts, double d_hat, const Buffers& buffers,
                   std::vector<ContactReport>& out);
void read_colors(std::uint32_t bodies, const Buffers& buffers, std::vector<int>& out);

}  // namespace pabd::device
