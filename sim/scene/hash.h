// An older name of sim/base/hash.h.
#pragma once

#include "sim/base/hash.h"
