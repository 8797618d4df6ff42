// SPDX-License-Identifier: MIT
// States and reports as bytes: parts of a recording. Reading checks everything.
#pragma once

#include "app/session/byte_stream.h"
#include "sim/body/state.h"
#include "sim/solver/report.h"

namespace pabd {

inline constexpr std::string_view kRecordMagic = "pabd-rec";
inline constexpr std::uint32_t kRecordVersion = 7;
inline constexpr std::size_t kRecordHeadBytes = 8 + 4 + 8, kRecordChecksumBytes = 16;

enum RecordFlag : std::uint8_t {
  kRecordStart = 1,
  kRecordEdit = 2,
  kRecordPulls = 4,
  kRecordState = 8,
  kRecordHash = 16,
  kRecordDevice = 32,
  kRecordAllFlags = 63
};

void write_state(const State& state, ByteWriter& out);
// Throws Error(bad_input) when it is no state of so many bodies; of how many joints is not looked at.
State read_state(ByteReader& in, Index bodies);

void write_report(const StepSummary& report, ByteWriter& out);
StepSummary read_report(ByteReader& in);

}  // namespace pabd
