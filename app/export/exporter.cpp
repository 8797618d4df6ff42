// SPDX-License-Identifier: MIT
// Which exporter a name asks for, and whether it may and can be written.
#include "app/export/exporter.h"

#include <fmt/format.h>

#include <filesystem>
#include <limits>

#include "render/output/frame_sink.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

// Of a body in .npz, whose arrays are in memory until the end.
constexpr double kNpzBytesAPose = 22 * sizeof(double);

void check_sizes(const std::string& out, ExportFormat format, const FrameView& start,
                 const ExportSetup& setup) {
  double bodies = static_cast<double>(start.model->size());
  const double frames = static_cast<double>(setup.frames);
  if (format == ExportFormat::obj && frames > std::numeric_limits<int>::max()) bodies = kMostPoses + 1;
  if (frames * bodies > kMostPoses) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format(
            "{}: {:.0f} frames of {:.0f} bodies; at most {:.0e} poses: take fewer --fps or less --time", out,
            frames, bodies, kMostPoses));
  }
  if (format == ExportFormat::npz && frames * bodies * kNpzBytesAPose > kMostNpzBytes) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: {:.1f} GB of poses; at most {:.1f}, contacts beside them: take fewer --fps or "
                    "less --time",
                    out, frames * bodies * kNpzBytesAPose / 1e9, kMostNpzBytes / 1e9));
  }
}

void check_existing(const std::string& out, const ExportSetup& setup) {
  if (!is_frame_template(out)) return check_overwrite(out, out, {setup.force, &setup.inputs});
  const int existing = setup.force ? -1 : first_existing_frame(out, 0);
  if (existing >= 0) refuse_existing(frame_path(out, existing).string(), "--force replaces it");
  static_cast<void>(frame_path(out, 0));  // of a template that is none it says why
}

}  // namespace

ExportFormat export_format(const std::string& out) {
  for (const auto& [suffix, format] : {std::pair{".glb", ExportFormat::gltf},
                                       {".usda", ExportFormat::usd},
                                       {".obj", ExportFormat::obj},
                                       {".npz", ExportFormat::npz}}) {
    if (out.size() > std::string_view(suffix).size() && out.ends_with(suffix)) return format;
  }
  throw Error(
      ErrorKind::bad_input,
      fmt::format("{}: no format has this name; expected NAME.glb, NAME.usda, NAME.npz, NAME.obj, or for "
                  "an .obj a frame NAME_%04d.obj or FOLDER/",
                  out));
}

std::string export_path(const std::string& out) {
  std::error_code none;
  if (out.ends_with('/') || std::filesystem::is_directory(out, none))
    return (std::filesystem::path(out) / "frame_{frame:04}.obj").string();
  const std::size_t percent = out.find('%');
  if (percent == std::string::npos || !out.ends_with(".obj")) return out;
  // "%d", "%04d"
  const std::size_t d = out.find('d', percent);
  const std::string digits = d == std::string::npos ? "?" : out.substr(percent + 1, d - percent - 1);
  const bool known =
      digits.empty() || (digits.size() == 2 && digits[0] == '0' && digits[1] >= '1' && digits[1] <= '9');
  if (!known) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: this number of a frame is not understood; expected %d, or %04d with 1 to 9 digits",
                    out));
  }
  const std::string field = digits.empty() ? "{frame}" : "{frame:" + digits + "}";
  return out.substr(0, percent) + field + out.substr(d + 1);
}

std::unique_ptr<Exporter> make_exporter(const std::string& out, const Scene& scene, const FrameView& start,
                                        const ExportSetup& setup) {
  const ExportFormat format = export_format(out);
  if (!setup.trails.empty() && (format == ExportFormat::obj || format == ExportFormat::npz)) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: trails are for .glb and .usda; leave out --trail and --trails", out));
  }
  if (is_frame_template(out) && format != ExportFormat::obj) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: only .obj has a file a frame; leave out the number", out));
  }
  check_sizes(out, format, start, setup);
  check_existing(out, setup);
  switch (format) {
    case ExportFormat::gltf:
      return make_gltf_exporter(out, scene, start, setup);
    case ExportFormat::usd:
      return make_usd_exporter(out, scene, start, setup);
    case ExportFormat::obj:
      return make_obj_exporter(out, scene, start, setup);
    case ExportFormat::npz:
      break;
  }
  return make_npz_exporter(out, scene, start, setup);
}

}  // namespace pabd
