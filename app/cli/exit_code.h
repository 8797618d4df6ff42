// SPDX-License-Identifier: MIT
// What the program tells whoever started it. Nothing else knows these numbers; scripts of users rely on them.
#pragma once

#include "sim/base/error.h"

namespace pabd::cli {

inline constexpr int kDone = 0;
// Stopped on request, with a checkpoint: the same command goes on (EX_TEMPFAIL of sysexits.h; schedulers requeue).
inline constexpr int kCheckpointed = 75;

constexpr int exit_code(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::defect:
      return 1;
    case ErrorKind::bad_input:
    case ErrorKind::exists:
      return 2;
    case ErrorKind::file:
      return 3;
    case ErrorKind::no_context:
      return 4;
    case ErrorKind::diverged:
      return 5;
    case ErrorKind::encoder:
      return 6;
    case ErrorKind::images_differ:
      return 7;
  }
  return 1;
}

}  // namespace pabd::cli
