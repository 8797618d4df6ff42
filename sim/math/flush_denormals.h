// SPDX-License-Identifier: MIT
// While an object of this class lives, denormal numbers are zero, as operands and as results, rounding is to nearest and nothing
// traps. The settings of the thread come back afterwards.
//
// Processors handle each number below 2e-308 in microcode: a chain that swings in a plane, where one coordinate decays to
// nothing, takes three times as long with them. And results must not depend on the settings of callers or threads.
#pragma once

#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace pabd {

class FlushDenormals {
 public:
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

#if defined(__SSE2__)
  // MXCSR: masks of all exceptions, round to nearest, flush to zero (bit 15), denormals are zero (bit 6).
  FlushDenormals() : before_(_mm_getcsr()) { _mm_setcsr(0x1f80u | 0x8000u | 0x0040u); }
  ~FlushDenormals() { _mm_setcsr(before_); }

 private:
  unsigned before_;
#elif defined(__aarch64__)
  // FPCR: flush to zero (bit 24), the rest at its default.
  FlushDenormals() {
    __asm__ volatile("mrs %0, fpcr" : "=r"(before_));
    set(std::uint64_t{1} << 24);
  }
  ~FlushDenormals() { set(before_); }

 private:
  static void set(std::uint64_t fpcr) { __asm__ volatile("msr fpcr, %0" : : "r"(fpcr)); }
  std::uint64_t before_;
#else
  FlushDenormals() {}  // denormals stay: slower, and other last digits
#endif
};

}  // namespace pabd
