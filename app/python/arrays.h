// SPDX-License-Identifier: MIT
// Data of a simulation as NumPy arrays: views of what stays where it is, copies of the rest.
#pragma once

#include <pybind11/numpy.h>

#include <vector>

#include "app/session/reports.h"
#include "render/output/image.h"
#include "sim/body/model.h"
#include "sim/solver/report.h"

namespace pabd::python {

// Views, read-only; they keep `owner` alive, which must keep the numbers where they are.
pybind11::array view_of(const std::vector<double>& numbers, pybind11::handle owner);       // (n,)
pybind11::array view_of(const std::vector<Vec3>& vectors, pybind11::handle owner);         // (n, 3)
pybind11::array view_of(const std::vector<Mat3>& matrices, pybind11::handle owner);        // (n, 3, 3)
pybind11::array flags_of(const std::vector<std::uint8_t>& flags, pybind11::handle owner);  // (n,), bool

// Copies as structured arrays; the fields have the names of the structs' members.
pybind11::array contacts_of(const StepReport& report);
pybind11::array iterations_of(const StepReport& report);  // the first iterate first
pybind11::array joints_of(const StepReport& report);
pybind11::array steps_of(const Reports& reports);

pybind11::array rgba_of(const Image& image);  // (h, w, 4), uint8

// Needed before the above.
void register_rows();

}  // namespace pabd::python
