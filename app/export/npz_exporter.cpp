// SPDX-License-Identifier: MIT
// States as NumPy arrays: https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html, in a .zip without
// compression. Every array is an entry NAME.npy; about.json says what each is.
#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <exception>
#include <limits>
#include <memory>
#include <new>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/export/exporter.h"
#include "app/export/little_endian.h"
#include "app/export/motion.h"
#include "app/frames/frame_text.h"
#include "sim/base/atomic_file.h"
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

// A .zip that appears when it is whole, by libarchive. Its entries are not compressed, and the same entries give the
// same bytes.
class ZipFile {
 public:
  // Throws Error(file), as all of it does.
  explicit ZipFile(const std::string& path) : file_(path), path_(path), archive_(archive_write_new()) {
    if (archive_ == nullptr) throw std::bad_alloc();
    try {
      check(archive_write_set_format_zip(archive_));
      check(archive_write_zip_set_compression_store(archive_));
      check(archive_write_set_bytes_in_last_block(archive_, 1));  // no zeros behind the end
      check(archive_write_open(archive_, this, nullptr, put, nullptr));
    } catch (...) {
      archive_write_free(archive_);
      throw;
    }
  }
  ~ZipFile() {
    given_up_ = true;
    if (archive_ != nullptr) archive_write_free(archive_);
  }
  ZipFile(const ZipFile&) = delete;
  ZipFile& operator=(const ZipFile&) = delete;

  // An entry of two parts.
  void add(const std::string& name, std::string_view head, std::string_view rest = {}) {
    const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(archive_entry_new(),
                                                                         archive_entry_free);
    if (!entry) throw std::bad_alloc();
    archive_entry_set_pathname(entry.get(), name.c_str());
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(head.size() + rest.size()));
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    archive_entry_set_mtime(entry.get(), 0, 0);
    check(archive_write_header(archive_, entry.get()));
    for (std::string_view part : {head, rest}) {
      while (!part.empty()) {
        const la_ssize_t taken = archive_write_data(archive_, part.data(), part.size());
        check(static_cast<long>(taken));
        part.remove_prefix(static_cast<std::size_t>(taken));
      }
    }
  }

  void commit() {
    check(archive_write_close(archive_));
    archive_write_free(std::exchange(archive_, nullptr));
    file_.commit();
  }

 private:
  // Never says no: of an archive that failed libarchive (3.6) does not free the buffer. check() tells of the failure.
  static long put(::archive*, void* self, const void* data, std::size_t size) {
    auto& zip = *static_cast<ZipFile*>(self);
    try {
      if (!zip.failed_ && !zip.given_up_) zip.file_.write(data, size);
    } catch (...) {
      zip.failed_ = std::current_exception();
    }
    return static_cast<long>(size);
  }

  void check(long result) {
    if (failed_) std::rethrow_exception(failed_);
    if (result >= ARCHIVE_OK) return;
    const char* reason = archive_error_string(archive_);
    throw Error(ErrorKind::file, fmt::format("{}: the archive cannot be written: {}", path_,
                                             reason != nullptr ? reason : "unknown reason"));
  }

  AtomicFile file_;
  std::string path_;
  ::archive* archive_;
  bool given_up_ = false;
  std::exception_ptr failed_;  // in put(), which libarchive calls
};

// What an array has a row for.
enum class RowsOf { states, states_and_end, contacts, bodies };

// One array: rows of numbers that are added.
struct AnyColumn {
  const char* name;
  RowsOf rows;
  std::vector<std::size_t> tail;  // shape of what stands in a row
  const char* unit;
  const char* meaning;
  const char* type;
  std::string bytes = {};
};
template <class T>
struct Column : AnyColumn {
  void add(T value) { append_bytes(value, bytes); }
  void add(const Vec3& v) {
    for (int i = 0; i < 3; ++i) add(v[i]);
  }
  void add(const Mat3& m) {
    for (int i = 0; i < 3; ++i) add(Vec3(m.row(i)));
  }
  std::size_t size() const { return bytes.size() / sizeof(T); }
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
    if (rows_ > 0 && state.time <= last_time_) return;
    ++rows_;
    last_time_ = state.time;
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
    for (const auto& column : columns_) {
      arrays[column->name] = {
          {"shape", shape(*column)}, {"unit", column->unit}, {"meaning", column->meaning}};
    }
    about_["arrays"] = std::move(arrays);
    zip_.add("about.json", about_.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n");
    for (const auto& column : columns_)
      zip_.add(fmt::format("{}.npy", column->name), npy_header(column->type, shape(*column)), column->bytes);
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
    if (static_cast<double>(contact_a_.size() + contacts.size()) * kBytes > kMostNpzBytes) {
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
    contact_offset_.add(static_cast<std::int64_t>(contact_a_.size()));
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

  std::vector<std::size_t> shape(const AnyColumn& column) const {
    const std::size_t rows[] = {rows_, rows_ + 1, contact_a_.size(), bodies_};
    std::vector<std::size_t> out{rows[static_cast<std::size_t>(column.rows)]};
    out.insert(out.end(), column.tail.begin(), column.tail.end());
    return out;
  }

  // Columns are written in the order in which they are declared.
  template <class T>
  Column<T>& column(const char* name, RowsOf rows, std::vector<std::size_t> tail, const char* unit,
                    const char* meaning) {
    auto made =
        std::make_unique<Column<T>>(Column<T>{{name, rows, std::move(tail), unit, meaning, kType<T>}});
    Column<T>& out = *made;
    columns_.push_back(std::move(made));
    return out;
  }

  std::string out_;
  ZipFile zip_;
  std::shared_ptr<const Model> model_;
  std::size_t bodies_, joints_, rows_ = 0;
  double last_time_ = 0;
  OrderedJson about_;
  std::vector<Quat> last_;

  using Numbers = Column<double>;
  static constexpr RowsOf kStates = RowsOf::states, kContacts = RowsOf::contacts, kBodies = RowsOf::bodies;
  std::vector<std::unique_ptr<AnyColumn>> columns_;
  Numbers& time_ = column<double>("time", kStates, {}, "s", "of the state, since the start of the scene");
  Column<std::int64_t>& step_ =
      column<std::int64_t>("step", kStates, {}, "", "that led to the state; 0: none");
  Numbers& position_ = column<double>("position", kStates, {bodies_, 3}, "m", "centre of mass, world");
  Numbers& orientation_ =
      column<double>("orientation", kStates, {bodies_, 4}, "",
                     "body to world, w x y z, unit; from row to row the nearer of the two signs");
  Numbers& affine_ =
      column<double>("A", kStates, {bodies_, 3, 3}, "",
                     "linear part of [c A]: world = c + A r. A step ends on a rotation, exactly this one");
  Numbers& velocity_ =
      column<double>("velocity", kStates, {bodies_, 3}, "m/s", "of the centre of mass, world");
  Numbers& angular_velocity_ = column<double>("angular_velocity", kStates, {bodies_, 3}, "rad/s", "world");
  Numbers& kinetic_ = column<double>("kinetic", kStates, {}, "J", "kinetic energy");
  Numbers& potential_ = column<double>("potential", kStates, {}, "J", "of gravity");
  Numbers& elastic_ = column<double>("elastic", kStates, {}, "J", "in contacts and joints");
  Column<std::int32_t>& iterations_ =
      column<std::int32_t>("iterations", kStates, {}, "", "of the step that led to the state");
  Column<std::int64_t>& contact_offset_ = column<std::int64_t>(
      "contact_offset", RowsOf::states_and_end, {}, "",
      "contacts of state k are rows contact_offset[k] to contact_offset[k + 1] of contact_*");
  Column<std::int32_t>& contact_a_ =
      column<std::int32_t>("contact_a", kContacts, {}, "", "number of the body that owns the normal");
  Column<std::int32_t>& contact_b_ =
      column<std::int32_t>("contact_b", kContacts, {}, "", "number of the other body");
  Numbers& contact_point_a_ = column<double>("contact_point_a", kContacts, {3}, "m", "on body a, world");
  Numbers& contact_point_b_ = column<double>("contact_point_b", kContacts, {3}, "m", "on body b, world");
  Numbers& contact_normal_ = column<double>("contact_normal", kContacts, {3}, "", "unit, from a to b, world");
  Numbers& contact_gap_ = column<double>("contact_gap", kContacts, {}, "m",
                                         "d = (point_b - point_a) . normal; negative: overlap");
  Numbers& contact_normal_force_ =
      column<double>("contact_normal_force", kContacts, {}, "N", "on b along the normal");
  Numbers& contact_friction_ = column<double>("contact_friction", kContacts, {3}, "N", "on b, world");
  Column<std::uint8_t>& contact_sticking_ =
      column<std::uint8_t>("contact_sticking", kContacts, {}, "", "true: sticks; false: slides");
  Numbers& contact_mu_ =
      column<double>("contact_mu", kContacts, {}, "", "coefficient of friction of the step");
  Numbers& joint_force_ =
      column<double>("joint_force", kStates, {joints_, 3}, "N",
                     "of the joint's first body on its second, world; NaN: no step told of it");
  Numbers& joint_moment_ = column<double>("joint_moment", kStates, {joints_, 3}, "N m",
                                          "the same about the anchor on the first body, world");
  Numbers& mass_ = column<double>("mass", kBodies, {}, "kg", "of each body; 0: fixed");
  Column<std::uint8_t>& fixed_ = column<std::uint8_t>("fixed", kBodies, {}, "", "true: never moves");
};

}  // namespace

std::unique_ptr<Exporter> make_npz_exporter(const std::string& out, const Scene& scene,
                                            const FrameView& start, const ExportSetup&) {
  return std::make_unique<NpzExporter>(out, scene, start);
}

}  // namespace pabd
