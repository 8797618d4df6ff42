// SPDX-License-Identifier: MIT
// State → JSON. See README.md for the file and trace.h for the contract.
//
// A quaternion and degrees are what people read, but neither gives the same bits back. So each body also has
// "rotation" (R, row by row) and "omega" (rad/s), and these are what state_from_json reads.
#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "sim/trace/trace.h"

namespace pabd {

namespace {

class StateWriter {
 public:
  std::string write(const Model& model, const State& state) {
    text("{\n  \"format\": \"pabd-state\",\n  \"version\": 1,\n  \"time\": ");
    number(state.time);
    fmt::format_to(std::back_inserter(out_), ",\n  \"step\": {},\n  \"hash\": \"{}\",\n  \"bodies\": [",
                   state.step, state_hash(state));
    for (Index i = 0; i < model.size(); ++i) {
      text(i == 0 ? "\n    " : ",\n    ");
      body(model, state, static_cast<std::size_t>(i));
    }
    text("\n  ],\n  \"anchors\": [");
    bool first = true;
    for (const ContactMemory& contact : state.contacts) {
      fmt::format_to(std::back_inserter(out_),
                     "{}    {{ \"bodies\": [{}, {}], \"feature\": {}, \"stretch\": ", first ? "\n" : ",\n",
                     contact.pair >> 32, contact.pair & 0xffffffffu, contact.feature);
      numbers(contact.stretch);
      if (contact.sliding) text(", \"sliding\": true");
      if (contact.restless) text(", \"restless\": true");
      text(contact.recovers ? ", \"recovers\": true }" : " }");
      first = false;
    }
    text(first ? "]" : "\n  ]");
    if (!state.joint_force.empty()) {
      text(",\n  \"joint_forces\": [");
      for (std::size_t k = 0; k < state.joint_force.size(); ++k) {
        text(k == 0 ? "\n    " : ",\n    ");
        numbers(state.joint_force[k]);
      }
      text("\n  ]");
    }
    if (!state.change.empty()) {
      text(",\n  \"changes\": [");
      for (std::size_t i = 0; i < state.change.size(); ++i) {
        text(i == 0 ? "\n    " : ",\n    ");
        const StepChangeNumbers change = numbers_of(state.change[i]);
        numbers(Eigen::Map<const Eigen::Matrix<double, 8, 1>>(change.data()));
      }
      text("\n  ]");
    }
    if (!state.coupling.empty()) {
      text(",\n  \"couplings\": ");
      numbers(Eigen::Map<const Eigen::VectorXd>(state.coupling.data(), std::ssize(state.coupling)));
    }
    text("\n}\n");
    return fmt::to_string(out_);
  }

 private:
  void body(const Model& model, const State& state, std::size_t i) {
    Quat q(state.R[i]);
    q.normalize();
    if (q.w() < 0) q.coeffs() = -q.coeffs();
    text("{ \"name\": ");
    string(model.name[i]);
    text(", \"position\": ");
    numbers(state.c[i]);
    text(", \"orientation\": ");
    numbers(Vec4(q.w(), q.x(), q.y(), q.z()));
    text(", \"velocity\": ");
    numbers(state.v[i]);
    text(", \"angular_velocity\": ");
    numbers(state.omega[i] * (180 / kPi));
    text(", \"rotation\": ");
    const Mat3 rows = state.R[i].transpose();  // Eigen stores columns
    numbers(Eigen::Map<const Eigen::Matrix<double, 9, 1>>(rows.data()));
    text(", \"omega\": ");
    numbers(state.omega[i]);
    text(" }");
  }

  void text(std::string_view s) { out_.append(s.data(), s.data() + s.size()); }

  void number(double x) {
    if (x == 0 && std::signbit(x)) {
      text("-0.0");  // "-0" would be read as the whole number 0
    } else if (std::isfinite(x)) {
      fmt::format_to(std::back_inserter(out_), "{}", x);
    } else {
      text("null");  // JSON has no such number; the reader refuses it and names the place
    }
  }

  template <class Vector>
  void numbers(const Vector& v) {
    text("[");
    for (Eigen::Index k = 0; k < v.size(); ++k) {
      if (k > 0) text(", ");
      number(v[k]);
    }
    text("]");
  }

  void string(std::string_view s) {
    text("\"");
    for (const char c : s) {
      if (c == '"' || c == '\\') {
        out_.push_back('\\');
        out_.push_back(c);
      } else if (static_cast<unsigned char>(c) < 0x20) {
        fmt::format_to(std::back_inserter(out_), "\\u{:04x}", static_cast<int>(c));
      } else {
        out_.push_back(c);
      }
    }
    text("\"");
  }

  fmt::memory_buffer out_;
};

}  // namespace

std::string state_to_json(const Model& model, const State& state) {
  return StateWriter().write(model, state);
}

}  // namespace pabd
