// SPDX-License-Identifier: MIT
// A function with PABD_EACH_LEVEL is compiled for AVX2 and AVX-512 as well, and the loader takes what the processor has (not with
// PABD_NATIVE=ON). For functions whose work is lanes of numbers.
//
// Each level gives the same bits: lanes are added and multiplied one by one wherever they lie, nothing is fused, and
// what Eigen does is as without AVX at each. Whatever such a function calls is inlined: a lane that is handed over by
// value lies elsewhere in functions of another level. Members of templates have no levels. What holds lanes in a
// std::vector says alignas: without AVX GCC aligns them less than functions with AVX expect.
#pragma once

// GCC's; with sanitizers the loader would choose before these are there.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__AVX2__) && \
    !defined(__SANITIZE_ADDRESS__)
#define PABD_EACH_LEVEL [[gnu::flatten, gnu::target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")]]
#else
#define PABD_EACH_LEVEL
#endif
