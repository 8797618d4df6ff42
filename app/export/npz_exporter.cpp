// SPDX-License-Identifier: MIT
// States as NumPy arrays: https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html, in a .zip without
// compression. Every array is an entry NAME.npy; about.json says what each is.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/export/exporter.h"
#include "app/export/little_endian.h"
#include "app/export/motion.h"
#include "app/export/zip_file.h"
#include "app/frames/frame_text.h"
#include "sim/base/error.h"
#include "sim/base/ordered_json.h"
#include "sim/body/shape_kind.h"

namespace pabd {
namespace {

template <class T>
constexpr const char* kType = nullptr;
template <>
constexpr const char* kType<double> = "<f8";
template <>
constexpr const char* kType<std::int64_t> = "<i8";
template <>
constexpr const char* kType<std::int32_t> = "<i4";
template <>
constexpr const char* kType<std::uint8_t> = "|b1";

// What an .npy file has before its numbers, filled up so that these begin at a multiple of 64 bytes.
std::string npy_header(const char* type, const std::vector<std::size_t>& shape) {
  std::string dims;
  for (const std::size_t n : shape) dims += fmt::format("{},", n);
  std::string text = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", type, dims);
  constexpr std::size_t kBefore = 10;
  text.append(63 - (kBefore + text.size()) % 64, ' ');
  text += '\n';
  std::string out("\x93NUMPY\x01\x00", 8);
  append_bytes(static_cast<std::uint16_t>(text.size()), out);
  return out + text;
}

// One array: rows of numbers that are added, of `tail` numbers each.
template <class T>
struct Column {
  const char* name;
  std::vector<std::size_t> tail;  // shape of what stands in a row
  const char* unit;
  const char* meaning;
  std::vector<T> values = {};

  std::size_t width() const {
    std::size_t n = 1;
    for (const std::size_t k : tail) n *= k;
    return n;
  }
  void add(T value) { values.push_back(value); }
  void add(const Vec3& v) { values.insert(values.end(), v.data(), v.data() + 3); }
  void add(const Mat3& m) {
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) values.push_back(m(i, k));
  }

  std::vector<std::size_t> shape(std::size_t rows) const {
    std::vector<std::size_t> out{rows};
    out.insert(out.end(), tail.begin(), tail.end());
    return out;
  }
  void write(std::size_t rows, ZipFile& zip) const {
    const std::string header = npy_header(kType<T>, shape(rows));
    const std::string_view bytes = bytes_of(std::span<const T>(values));
    zip.begin(fmt::format("{}.npy", name), header.size() + bytes.size());
    zip.write(header);
    zip.write(bytes);
  }
};

class NpzExporter : public Exporter {
 public:
  NpzExporter(const std::string& out, const Scene& scene, const FrameView& start)
      : out_(out),
        zip_(out),
        model_(start.model),
        bodies_(start.model->name.size()),
        joints_(start.model->joints.size()),
        about_({{"format", "pabd-states"},
                {"version", 1},
                {"program", "pabd " PABD_VERSION},
                {"scene", scene.name},
                {"scene_hash", scene.hash},
                {"parameters", OrderedJson::parse(parameters_json(start.params, start.kappa))},
                {"axes", "right-handed, y up"},
                {"quaternions", "w, x, y, z"}}) {
    describe();
    for (const double mass : model_->mass) mass_.add(mass);
    for (const auto fixed : model_->fixed) fixed_.add(fixed);
    contact_offset_.add(0);
  }

  void add(std::int64_t, const FrameView& view) override {
    check_same_bodies(*model_, view);
    const State& state = *view.state;
    if (rows_ > 0 && state.time <= time_.values.back()) return;
    ++rows_;
    time_.add(state.time);
    step_.add(state.step);
    for (std::size_t i = 0; i < bodies_; ++i) {
      position_.add(state.c[i]);
      if (last_.size() <= i) last_.emplace_back(0, 0, 0, 0);
      last_[i] = continued(state.R[i], last_[i]);
      for (const double x : {last_[i].w(), last_[i].x(), last_[i].y(), last_[i].z()}) orientation_.add(x);
      affine_.add(state.R[i]);
      velocity_.add(state.v[i]);
      angular_velocity_.add(state.omega[i]);
    }
    add_contacts(view.report.contact_reports);
    add_joints(view);
    kinetic_.add(view.report.kinetic);
    potential_.add(view.report.potential);
    elastic_.add(view.report.elastic);
    iterations_.add(view.report.iterations);
  }

  void finish() override {
    OrderedJson arrays = OrderedJson::object();
    const auto tell = [&](const auto& column, std::size_t rows) {
      arrays[column.name] = {
          {"shape", column.shape(rows)}, {"unit", column.unit}, {"meaning", column.meaning}};
    };
    for_each(tell);
    about_["arrays"] = std::move(arrays);
    const std::string text = about_.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
    zip_.begin("about.json", text.size());
    zip_.write(text);
    for_each([&](const auto& column, std::size_t rows) { column.write(rows, zip_); });
    zip_.commit();
  }

 private:
  void describe() {
    OrderedJson bodies = OrderedJson::array(), joints = OrderedJson::array();
    const auto end = [&](Index body) -> OrderedJson {
      if (body == kWorld) return nullptr;
      return model_->name[static_cast<std::size_t>(body)];
    };
    for (std::size_t i = 0; i < bodies_; ++i)
      bodies.push_back({{"name", model_->name[i]}, {"shape", text_of(model_->shape[i])}});
    for (const Joint& joint : model_->joints) {
      joints.push_back({{"name", joint.name},
                        {"type", to_string(joint.type)},
                        {"bodies", OrderedJson::array({end(joint.i), end(joint.j)})}});
    }
    about_["bodies"] = std::move(bodies);
    about_["joints"] = std::move(joints);
  }

  void add_contacts(const std::vector<ContactReport>& contacts) {
    constexpr double kBytes = 15 * sizeof(double) + 2 * sizeof(std::int32_t) + 1;  // of a contact
    if (static_cast<double>(contact_a_.values.size() + contacts.size()) * kBytes > kMostNpzBytes) {
      throw Error(
          ErrorKind::bad_input,
          fmt::format("{}: more than {:.1f} GB of contacts after {} frames: take fewer --fps or less --time",
                      out_, kMostNpzBytes / 1e9, rows_));
    }
    for (const ContactReport& contact : contacts) {
      contact_a_.add(contact.a);
      contact_b_.add(contact.b);
      contact_point_a_.add(contact.y_a);
      contact_point_b_.add(contact.y_b);
      contact_normal_.add(contact.n);
      contact_gap_.add(contact.d);
      contact_normal_force_.add(contact.normal_force);
      contact_friction_.add(contact.friction);
      contact_sticking_.add(contact.sticking ? 1 : 0);
      contact_mu_.add(contact.mu);
    }
    contact_offset_.add(static_cast<std::int64_t>(contact_a_.values.size()));
  }

  // A recording keeps the forces only.
  void add_joints(const FrameView& view) {
    const std::vector<JointReport>& joints = view.report.joint_reports;
    const std::vector<Vec3>& forces = view.state->joint_force;
    static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t k = 0; k < joints_; ++k) {
      const bool told = joints.size() == joints_, kept = forces.size() == joints_;
      const Vec3 none = Vec3::Constant(kNone);
      joint_force_.add(told ? joints[k].force : kept ? forces[k] : none);
      joint_moment_.add(told ? joints[k].moment : none);
    }
  }

  // Every array, with its number of rows.
  template <class Visit>
  void for_each(const Visit& visit) const {
    visit(time_, rows_);
    visit(step_, rows_);
    visit(position_, rows_);
    visit(orientation_, rows_);
    visit(affine_, rows_);
    visit(velocity_, rows_);
    visit(angular_velocity_, rows_);
    visit(kinetic_, rows_);
    visit(potential_, rows_);
    visit(elastic_, rows_);
    visit(iterations_, rows_);
    visit(contact_offset_, rows_ + 1);
    const std::size_t contacts = contact_a_.values.size();
    visit(contact_a_, contacts);
    visit(contact_b_, contacts);
    visit(contact_point_a_, contacts);
    visit(contact_point_b_, contacts);
    visit(contact_normal_, contacts);
    visit(contact_gap_, contacts);
    visit(contact_normal_force_, contacts);
    visit(contact_friction_, contacts);
    visit(contact_sticking_, contacts);
    visit(contact_mu_, contacts);
    visit(joint_force_, rows_);
    visit(joint_moment_, rows_);
    visit(mass_, bodies_);
    visit(fixed_, bodies_);
  }

  std::string out_;
  ZipFile zip_;
  std::shared_ptr<const Model> model_;
  std::size_t bodies_, joints_, rows_ = 0;
  OrderedJson about_;
  std::vector<Quat> last_;

  Column<double> time_{"time", {}, "s", "of the state, since the start of the scene"};
  Column<std::int64_t> step_{"step", {}, "", "that led to the state; 0: none"};
  Column<double> position_{"position", {bodies_, 3}, "m", "centre of mass, world"};
  Column<double> orientation_{"orientation",
                              {bodies_, 4},
                              "",
                              "body to world, w x y z, unit; from row to row the nearer of the two signs"};
  Column<double> affine_{
      "A",
      {bodies_, 3, 3},
      "",
      "linear part of [c A]: world = c + A r. A step ends on a rotation, exactly this one"};
  Column<double> velocity_{"velocity", {bodies_, 3}, "m/s", "of the centre of mass, world"};
  Column<double> angular_velocity_{"angular_velocity", {bodies_, 3}, "rad/s", "world"};
  Column<double> kinetic_{"kinetic", {}, "J", "kinetic energy"};
  Column<double> potential_{"potential", {}, "J", "of gravity"};
  Column<double> elastic_{"elastic", {}, "J", "in contacts and joints"};
  Column<std::int32_t> iterations_{"iterations", {}, "", "of the step that led to the state"};
  Column<std::int64_t> contact_offset_{
      "contact_offset",
      {},
      "",
      "contacts of state k are rows contact_offset[k] to contact_offset[k + 1] of contact_*"};
  Column<std::int32_t> contact_a_{"contact_a", {}, "", "number of the body that owns the normal"};
  Column<std::int32_t> contact_b_{"contact_b", {}, "", "number of the other body"};
  Column<double> contact_point_a_{"contact_point_a", {3}, "m", "on body a, world"};
  Column<double> contact_point_b_{"contact_point_b", {3}, "m", "on body b, world"};
  Column<double> contact_normal_{"contact_normal", {3}, "", "unit, from a to b, world"};
  Column<double> contact_gap_{"contact_gap", {}, "m", "d = (point_b - point_a) . normal; negative: overlap"};
  Column<double> contact_normal_force_{"contact_normal_force", {}, "N", "on b along the normal"};
  Column<double> contact_friction_{"contact_friction", {3}, "N", "on b, world"};
  Column<std::uint8_t> contact_sticking_{"contact_sticking", {}, "", "true: sticks; false: slides"};
  Column<double> contact_mu_{"contact_mu", {}, "", "coefficient of friction of the step"};
  Column<double> joint_force_{"joint_force",
                              {joints_, 3},
                              "N",
                              "of the joint's first body on its second, world; NaN: no step told of it"};
  Column<double> joint_moment_{
      "joint_moment", {joints_, 3}, "N m", "the same about the anchor on the first body, world"};
  Column<double> mass_{"mass", {}, "kg", "of each body; 0: fixed"};
  Column<std::uint8_t> fixed_{"fixed", {}, "", "true: never moves"};
};

}  // namespace

std::unique_ptr<Exporter> make_npz_exporter(const std::string& out, const Scene& scene,
                                            const FrameView& start, const ExportSetup&) {
  return std::make_unique<NpzExporter>(out, scene, start);
}

}  // namespace pabd
