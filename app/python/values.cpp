// SPDX-License-Identifier: MIT
// See values.h. Units: sim/solver/report.h.
#include "app/python/values.h"

#include <type_traits>

#include "sim/solver/step_numbers.h"

namespace pabd::python {

namespace py = pybind11;
using namespace py::literals;

static py::object object_of(const ParameterValue& value) {
  return std::visit(
      [&]<class Type>(const Type& x) -> py::object {
        if constexpr (std::is_same_v<Type, Vec3>) {
          return py::make_tuple(x.x(), x.y(), x.z());
        } else if constexpr (std::is_same_v<Type, std::optional<double>>) {
          return x ? py::object(py::float_(*x)) : py::object(py::str("auto"));
        } else if constexpr (std::is_enum_v<Type>) {
          return py::str(word_of(value));
        } else {
          return py::cast(x);
        }
      },
      value);
}

py::object parameter_value(const Params& params, const std::string& key) {
  const ParameterRow* row = find_parameter(key);
  if (row == nullptr) throw py::key_error(key);
  return object_of(value_of(*row, params));
}

py::dict description_of(const ParameterRow& row) {
  py::list words;
  for (const ParameterChoice& choice : choices_of(row)) words.append(choice.word);
  return py::dict("key"_a = row.key, "label"_a = row.label, "symbol"_a = row.symbol, "unit"_a = row.unit,
                  "help"_a = row.help, "expected"_a = expected_of(row),
                  "default"_a = object_of(value_of(row, Params{})), "choices"_a = words);
}

py::dict energies_of(const StepSummary& step) {
  return py::dict("kinetic"_a = step.kinetic, "potential"_a = step.potential, "elastic"_a = step.elastic,
                  "total"_a = step.kinetic + step.potential + step.elastic);
}

namespace {

py::dict dict_of(const PhaseTimes& times) {
  return py::dict("detect"_a = times.detect, "set_up"_a = times.set_up, "solve"_a = times.solve,
                  "velocities"_a = times.velocities, "total"_a = times.total);
}

py::dict dict_of(const IslandReport& island) {
  return py::dict("first_body"_a = island.first_body, "bodies"_a = island.bodies,
                  "manifolds"_a = island.manifolds, "joints"_a = island.joints,
                  "solver"_a = to_string(island.solver), "status"_a = to_string(island.status),
                  "iterations"_a = island.iterations, "residual"_a = island.residual);
}

}  // namespace

py::dict dict_of(const StepReport& report) {
  py::list islands;
  for (const IslandReport& island : report.islands) islands.append(dict_of(island));
  py::dict out = energies_of(report);
  for (const StepNumber& number : step_numbers())
    std::visit([&](const auto member) { out[py::str(std::string(number.name))] = report.*member; },
               number.member);
  out["method"] = to_string(report.method);
  out["status"] = to_string(report.status);
  out["times"] = dict_of(report.times);
  out["islands"] = islands;
  return out;
}

}  // namespace pabd::python
