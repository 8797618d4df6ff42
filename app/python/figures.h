// SPDX-License-Identifier: MIT
// The project's plots as objects of Python, which a notebook shows as SVG.
#pragma once

#include <pybind11/pybind11.h>

namespace pabd::python {

void bind_figures(pybind11::module_& module);

}  // namespace pabd::python
