// SPDX-License-Identifier: MIT
// JSON → State, checked against the model it is for. See state_writer.cpp for what is in the file.
#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>

#include "sim/base/counted.h"
#include "sim/base/error.h"
#include "sim/scene/read_memory.h"
#include "sim/scene/reader.h"
#include "sim/scene/text.h"
#include "sim/trace/trace.h"

namespace pabd {

namespace {

using Key = std::string_view;
constexpr std::array kStateKeys{Key("format"),  Key("version"),  Key("time"),    Key("step"),
                                Key("hash"),    Key("bodies"),   Key("anchors"), Key("joint_forces"),
                                Key("changes"), Key("couplings")};
constexpr std::array kBodyKeys{Key("name"),     Key("position"),         Key("orientation"), Key("rotation"),
                               Key("velocity"), Key("angular_velocity"), Key("omega")};

constexpr double kTolerance = 1e-6;  // of a rotation's entries, and between the two ways to write one
constexpr Range kAny{};

Mat3 read_rotation(const ObjectReader& in) {
  const auto orientation = in.find("orientation");
  const auto rotation = in.find("rotation");
  if (!rotation) return in.require("orientation", "a unit quaternion [w, x, y, z]").rotation();
  Mat3 rows;
  rotation->numbers(std::span<double>(rows.data(), 9), {-2, 2});
  const Mat3 R = rows.transpose();
  const double error = (R.transpose() * R - Mat3::Identity()).cwiseAbs().maxCoeff();
  if (!(error <= kTolerance) || R.determinant() < 0) rotation->fail_expected("a rotation matrix, row by row");
  if (orientation && !((orientation->rotation() - R).cwiseAbs().maxCoeff() <= kTolerance)) {
    orientation->fail("differs from \"rotation\"; to change it by hand, remove \"rotation\" and \"hash\"");
  }
  return R;
}

Vec3 read_omega(const ObjectReader& in) {
  const auto degrees = in.find("angular_velocity");
  const auto omega = in.find("omega");
  if (!omega) return in.vec3("angular_velocity", kAny) * (kPi / 180);
  const Vec3 w = omega->vec3(kAny);
  if (degrees) {
    const Vec3 other = degrees->vec3(kAny) * (kPi / 180);
    if (!((other - w).norm() <= kTolerance * (1 + w.norm()))) {
      degrees->fail("differs from \"omega\"; to change it by hand, remove \"omega\" and \"hash\"");
    }
  }
  return w;
}

void read_body(const Node& node, const Model& model, std::size_t i, State& state) {
  const ObjectReader in(node, kBodyKeys);
  const std::string name = in.name("name");
  if (name != model.name[i]) {
    in.fail_key("name", fmt::format("expected {}, got {}; the state belongs to another scene",
                                    in_quotes(model.name[i]), in_quotes(name)));
  }
  state.c.push_back(in.vec3("position", kAny));
  state.R.push_back(read_rotation(in));
  state.v.push_back(in.vec3("velocity", kAny));
  state.omega.push_back(read_omega(in));
  if (model.fixed[i] != 0 && !(state.v.back().isZero(0) && state.omega.back().isZero(0))) {
    in.fail("the body is fixed in the scene; expected zero velocities");
  }
}

void read_changes(const Node& list, std::size_t count, std::vector<StepChange>& out) {
  if (list.array_size() != count)
    list.fail(fmt::format("expected one a body, {}, got {}", count, list.array_size()));
  for (std::size_t i = 0; i < count; ++i) {
    StepChangeNumbers numbers{};
    list.element(i).numbers(numbers, kAny);
    if (numbers[0] < 0) list.element(i).fail_expected("8 numbers, the first of them a time step");
    out.push_back(step_change(numbers));
  }
}

}  // namespace

// Generous: a body takes about 700 bytes and 35 values, a contact 130 and 10.
std::size_t most_state_bytes(const Model& model) {
  return DocumentLimits{}.bytes + (std::size_t{16} << 10) * static_cast<std::size_t>(model.size());
}

State state_from_json(const Model& model, const std::string& text, const std::string& source) {
  const DocumentLimits usual;
  const Json document = parse_document(
      text, source,
      {most_state_bytes(model), usual.values + 1024 * static_cast<std::size_t>(model.size()), usual.depth});
  ReadContext context{source, {}, {}};
  const ObjectReader in(Node(document, context), kStateKeys);
  const Node format = in.require("format", "\"pabd-state\"");
  if (!format.is_word("pabd-state")) format.fail_expected("\"pabd-state\"");
  in.integer("version", 1, 1);

  State state;
  state.time = in.number("time", {0, std::numeric_limits<double>::infinity(), "s"});
  state.step = in.integer("step", 0, std::int64_t{1} << 53, 0);
  const Node bodies = in.require("bodies", "an array of bodies");
  const auto count = static_cast<std::size_t>(model.size());
  if (bodies.array_size() != count) {
    bodies.fail(fmt::format("expected {}, got {}; the state belongs to another scene",
                            counted(count, "body", "bodies"), bodies.array_size()));
  }
  state.c.reserve(count);
  state.R.reserve(count);
  state.v.reserve(count);
  state.omega.reserve(count);
  for (std::size_t i = 0; i < count; ++i) read_body(bodies.element(i), model, i, state);
  if (const auto anchors = in.find("anchors"))
    read_memory_of_contacts(*anchors, model.size(), state.contacts);

  if (const auto forces = in.find("joint_forces"))
    read_joint_forces(*forces, model.joints.size(), state.joint_force);

  if (const auto changes = in.find("changes")) read_changes(*changes, count, state.change);

  if (const auto couplings = in.find("couplings")) {
    const auto following = static_cast<std::size_t>(std::count_if(
        model.joints.begin(), model.joints.end(), [](const Joint& j) { return j.follows.has_value(); }));
    if (couplings->array_size() != following)
      couplings->fail(fmt::format("expected one a joint that follows another, {}, got {}", following,
                                  couplings->array_size()));
    state.coupling.resize(following);
    couplings->numbers(state.coupling, kAny);
  }

  if (const auto hash = in.find("hash")) {
    const std::string expected = state_hash(state);
    if (!hash->is_word(expected)) {
      hash->fail(fmt::format(
          "the numbers give {}: the file was changed or damaged; if that was on purpose, remove \"hash\"",
          expected));
    }
  }
  return state;
}

}  // namespace pabd
