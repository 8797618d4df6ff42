// SPDX-License-Identifier: MIT
// A State in the arrays of the GPU, there and back.
#pragma once

#include "render/device/device_buffers.h"
#include "render/device/device_programs.h"
#include "sim/body/model.h"
#include "sim/body/state.h"

namespace pabd::device {

void write_poses(const State& state, Precision precision, Buffers& buffers);
void read_poses(Precision precision, const Buffers& buffers, std::uint32_t bodies, State& out);

// What contacts remember.
void write_memory(const State& state, const Model& model, Precision precision, Buffers& buffers);
void read_memory(std::uint32_t pairs, std::uint32_t contacts, Precision precision, const Buffers& buffers,
                 State& out);

}  // namespace pabd::device
