// SPDX-License-Identifier: MIT
// What the program tells whoever started it. Nothing else knows these numbers; scripts of users rely on them.
#pragma once

#include "sim/base/error.h"

namespace pabd::cli {

inline constexpr int kDone = 0;
// Stopped on request, with a checkpoint: the same command goes on (EX_TEMPFAIL of sysexits.h; schedulers requeue).
inline constexpr int kCheckpointed = 75;

struct ErrorWord {
  ErrorKind kind;
  int code;
  const char* word;  // in Python
};
inline constexpr ErrorWord kErrorWords[] = {
    {ErrorKind::defect, 1, "defect"},         {ErrorKind::bad_input, 2, "bad_input"},
    {ErrorKind::exists, 2, "exists"},         {ErrorKind::file, 3, "file"},
    {ErrorKind::no_context, 4, "no_context"}, {ErrorKind::diverged, 5, "diverged"},
    {ErrorKind::encoder, 6, "encoder"},       {ErrorKind::images_differ, 7, "images_differ"}};

constexpr const ErrorWord& word_of(ErrorKind kind) {
  for (const ErrorWord& row : kErrorWords)
    if (row.kind == kind) return row;
  return kErrorWords[0];
}

constexpr int exit_code(ErrorKind kind) { return word_of(kind).code; }

}  // namespace pabd::cli
