// SPDX-License-Identifier: MIT
// Floating point as a step wants it, while an object of this class lives: denormal numbers are zero, both as
// operands and as results, rounding is to nearest and nothing traps. What the thread had before comes back
// afterwards.
//
// Numbers below 2e-308 mean nothing here, but a processor handles each of them in microcode: a chain that
// swings in a plane, where one coordinate of everything decays to nothing, takes three times as long with
// them. Part of determinism: the result of a step must not depend on what its caller or its threads were set
// to.
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
