// SPDX-License-Identifier: MIT
// See parameter_values.h.
#include "app/python/parameter_values.h"

#include <type_traits>

namespace pabd::python {

namespace py = pybind11;
using namespace py::literals;

py::object object_of(const ParameterValue& value) {
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

}  // namespace pabd::python
