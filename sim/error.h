// An older name of sim/base/error.h.
#pragma once

#include "sim/base/error.h"

namespace pabd {
using ExitCode = ErrorKind;
}  // namespace pabd
