// SPDX-License-Identifier: MIT
// A step's report as a dict of Python.
#pragma once

#include <pybind11/pybind11.h>

#include "sim/solver/report.h"

namespace pabd::python {

// The members of StepSummary by their names, "total" energy, "times" in ms, and "islands", a list of dicts.
pybind11::dict dict_of(const StepReport& report);

// "kinetic", "potential", "elastic" and "total"; J.
pybind11::dict energies_of(const StepSummary& step);

}  // namespace pabd::python
