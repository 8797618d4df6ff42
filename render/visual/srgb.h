// An older name of sim/base/srgb.h.
#pragma once

#include "sim/base/srgb.h"
