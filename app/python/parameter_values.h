// SPDX-License-Identifier: MIT
// The table of parameters as Python has it.
#pragma once

#include <pybind11/pybind11.h>

#include "sim/solver/parameter_table.h"

namespace pabd::python {

// A float, int, bool, tuple of three floats, or a word; "auto" for an empty κ.
pybind11::object object_of(const ParameterValue& value);

// By its key. Throws KeyError.
pybind11::object parameter_value(const Params& params, const std::string& key);

// A dict: key, label, symbol, unit, help, expected, default, choices.
pybind11::dict description_of(const ParameterRow& row);

}  // namespace pabd::python
