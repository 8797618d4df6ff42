// SPDX-License-Identifier: MIT
// Parameters and the reports of steps as values of Python.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "sim/solver/parameter_table.h"
#include "sim/solver/report.h"

namespace pabd::python {

// By its key: a float, int, bool, tuple of three floats, or a word; "auto" for an empty κ. Throws KeyError.
pybind11::object parameter_value(const Params& params, const std::string& key);

// A dict: key, label, symbol, unit, help, expected, default, choices.
pybind11::dict description_of(const ParameterRow& row);

// The members of StepSummary by their names, "total" energy, "times" in ms, and "islands", a list of dicts.
pybind11::dict dict_of(const StepReport& report);

// "kinetic", "potential", "elastic" and "total"; J.
pybind11::dict energies_of(const StepSummary& step);

}  // namespace pabd::python
