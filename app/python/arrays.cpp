// SPDX-License-Identifier: MIT
// See arrays.h.
#include "app/python/arrays.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>

#include "sim/solver/step_numbers.h"

namespace pabd::python {

namespace py = pybind11;
using Three = std::array<double, 3>;

// Plain rows: what NumPy reads. Units: report.h, where each member is described.
struct ContactRow {
  std::int32_t a, b;
  Three y_a, y_b, n;
  double d, normal_force;
  Three friction;
  bool sticking;
  double mu;
};

struct IterationRow {
  std::int32_t iteration;
  double energy, residual, max_penetration_before, max_penetration_after, min_gap_before, min_gap_after;
  double max_joint_error, projection_change;
};

struct JointRow {
  Three force, moment, axis;
  double coupling;
};

namespace {

constexpr auto kNumber = static_cast<py::ssize_t>(sizeof(double));
static_assert(sizeof(Vec3) == 3 * sizeof(double) && sizeof(Mat3) == 9 * sizeof(double));

py::array read_only(py::array array) {
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

py::ssize_t count(const auto& list) { return static_cast<py::ssize_t>(list.size()); }

Three three(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

// One row each, made by `row`.
template <class Row, class List, class Make>
py::array rows(const List& list, const Make& row) {
  py::array_t<Row> out(count(list));
  Row* to = out.mutable_data();
  for (const auto& entry : list) *to++ = row(entry);
  return out;
}

IterationRow row_of(const IterationRecord& r, std::int32_t iteration) {
  return {
      iteration,        r.energy,        r.residual,        r.max_penetration_before, r.max_penetration_after,
      r.min_gap_before, r.min_gap_after, r.max_joint_error, r.projection_change};
}

}  // namespace

py::array view_of(const std::vector<double>& numbers, py::handle owner) {
  return read_only(py::array_t<double>(count(numbers), numbers.data(), owner));
}

py::array view_of(const std::vector<Vec3>& vectors, py::handle owner) {
  return read_only(py::array_t<double>({count(vectors), py::ssize_t{3}}, {3 * kNumber, kNumber},
                                       reinterpret_cast<const double*>(vectors.data()), owner));
}

// Columns lie one after the other.
py::array view_of(const std::vector<Mat3>& matrices, py::handle owner) {
  return read_only(py::array_t<double>({count(matrices), py::ssize_t{3}, py::ssize_t{3}},
                                       {9 * kNumber, kNumber, 3 * kNumber},
                                       reinterpret_cast<const double*>(matrices.data()), owner));
}

py::array flags_of(const std::vector<std::uint8_t>& flags, py::handle owner) {
  return read_only(py::array(py::dtype::of<bool>(), {count(flags)}, {py::ssize_t{1}}, flags.data(), owner));
}

py::array contacts_of(const StepReport& report) {
  return rows<ContactRow>(report.contact_reports, [](const ContactReport& c) {
    return ContactRow{c.a,        c.b, three(c.y_a),   three(c.y_b),
                      three(c.n), c.d, c.normal_force, three(c.friction),
                      c.sticking, c.mu};
  });
}

py::array iterations_of(const StepReport& report) {
  const std::size_t n = report.records.size();
  py::array_t<IterationRow> out(n == 0 ? 0 : static_cast<py::ssize_t>(n) + 1);
  if (n == 0) return out;
  IterationRow* to = out.mutable_data();
  *to++ = row_of(report.first_iterate, 0);
  for (std::size_t k = 0; k < n; ++k) *to++ = row_of(report.records[k], static_cast<std::int32_t>(k + 1));
  return out;
}

py::array joints_of(const StepReport& report) {
  return rows<JointRow>(report.joint_reports, [](const JointReport& j) {
    return JointRow{three(j.force), three(j.moment), three(j.axis), j.coupling};
  });
}

// The numbers of a step in their order, then two that are none of the summary's.
py::array steps_of(const Reports& reports) {
  struct Column {
    const char* name;
    const char* format;
    std::size_t size;
    std::function<void(const StepSummary&, char*)> put;
  };
  std::vector<Column> columns;
  const auto add = [&]<class Value>(const char* name, const char* format, Value value) {
    using T = decltype(value(StepSummary()));
    columns.push_back({name, format, sizeof(T), [value](const StepSummary& s, char* to) {
                         const T x = value(s);
                         std::memcpy(to, &x, sizeof x);
                       }});
  };
  for (const StepNumber& number : step_numbers()) {
    const char* name = number.name.data();
    if (number.whole())
      add(name, "i8", [&number](const StepSummary& s) {
        return std::visit([&](const auto of) { return static_cast<std::int64_t>(s.*of); }, number.member);
      });
    else
      add(name, "f8", [&number](const StepSummary& s) { return number.value(s); });
  }
  add("converged", "?", [](const StepSummary& s) { return s.status == StepStatus::converged; });
  add("milliseconds", "f8", [](const StepSummary& s) { return s.times.total; });

  py::list names, formats, offsets;
  std::size_t row = 0;
  for (const Column& column : columns) {
    names.append(column.name);
    formats.append(column.format);
    offsets.append(row);
    row += column.size;
  }
  py::array out(py::dtype(names, formats, offsets, static_cast<py::ssize_t>(row)),
                std::vector<py::ssize_t>{count(reports)});
  char* to = static_cast<char*>(out.mutable_data());
  for (const StepSummary& step : reports) {
    for (const Column& column : columns) {
      column.put(step, to);
      to += column.size;
    }
  }
  return out;
}

py::array rgba_of(const Image& image) {
  py::array_t<std::uint8_t> out({image.height, image.width, 4});
  std::uint8_t* to = out.mutable_data();
  const std::size_t pixels = image.rgb.size() / 3;
  for (std::size_t k = 0; k < pixels; ++k) {
    to = std::copy_n(image.rgb.data() + 3 * k, 3, to);
    *to++ = image.alpha.empty() ? std::uint8_t{255} : image.alpha[k];
  }
  return out;
}

void register_rows() {
  PYBIND11_NUMPY_DTYPE(ContactRow, a, b, y_a, y_b, n, d, normal_force, friction, sticking, mu);
  PYBIND11_NUMPY_DTYPE(IterationRow, iteration, energy, residual, max_penetration_before,
                       max_penetration_after, min_gap_before, min_gap_after, max_joint_error,
                       projection_change);
  PYBIND11_NUMPY_DTYPE(JointRow, force, moment, axis, coupling);
}

}  // namespace pabd::python
