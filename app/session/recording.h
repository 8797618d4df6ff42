// SPDX-License-Identifier: MIT
// A run as a file: what every step was made with, its report, and its exact state every so many steps; states between
// are computed again, to the same bits. Of steps that a device made the file has all states that were kept.
//
//   "pabd-rec", version (u32), size of the rest without the checksum (u64)
//   scene       hash, name, number of bodies: a recording belongs to one scene
//   tables      parameters (JSON), edits (JSON; of forgotten moments with their state), hands
//   moments     start, edit, made by a device, parameters, hands, report, hash of the state, state
//   checksum    16 hex digits over everything before it
//
// Integers and numbers are little endian, texts have their length (u32) before them.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "app/session/run.h"

namespace pabd {

// The whole timeline of a run, without the future that a branch left. Precondition: Run::complete() was called. `out` gets
// the bytes in parts: a recording may be larger than the memory.
void write_recording(const Run& run, const std::function<void(std::string_view)>& out);
std::string encode_recording(const Run& run);

// The timeline of a recording of this scene, with `memory` bytes for states. Throws Error(bad_input) in one
// line that names `source`, when it is no recording or one of another version, of another scene, cut off,
// damaged, or says what no run can.
Timeline decode_recording(const std::string& bytes, const std::string& source,
                          const std::shared_ptr<const Scene>& scene, std::size_t memory);

// The same from a file, read in parts. Throws Error(file) when it cannot be read.
Timeline read_recording(const std::string& path, const std::shared_ptr<const Scene>& scene,
                        std::size_t memory);

// Computes the last steps again: the first whose state differs from the recorded one; none when all agree. Another build
// or machine may round differently.
std::optional<std::int64_t> first_difference(const Timeline& recorded, int threads);

}  // namespace pabd
