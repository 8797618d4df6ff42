// SPDX-License-Identifier: MIT
// Which exporter a name asks for, and whether it may and can be written.
#include "app/export/exporter.h"

#include <fmt/format.h>

#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr ExportFormat kFormats[] = {
    {".glb", "glTF 2.0 with animation", false, make_gltf_exporter},
    {".usda", "USD with time samples", false, make_usd_exporter},
    {".npz", "NumPy arrays of all states", true, make_npz_exporter},
};

// Of a body in .npz, whose arrays are in memory until the end.
constexpr double kNpzBytesAPose = 22 * sizeof(double);

}  // namespace

const ExportFormat& export_format(const std::string& out) {
  std::string names;
  for (const ExportFormat& format : kFormats) {
    if (out.size() > std::string_view(format.suffix).size() && out.ends_with(format.suffix)) return format;
    names += fmt::format("{}NAME{}", names.empty() ? "" : ", ", format.suffix);
  }
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: no format has this name; expected one of {}", out, names));
}

std::string export_help() {
  std::string help;
  for (const ExportFormat& format : kFormats)
    help += fmt::format("{}{}: {}", help.empty() ? "" : "; ", format.suffix, format.help);
  return help;
}

std::unique_ptr<Exporter> make_exporter(const std::string& out, const Scene& scene, const FrameView& start,
                                        const ExportSetup& setup) {
  const ExportFormat& format = export_format(out);
  const auto refuse = [&](const std::string& why) {
    throw Error(ErrorKind::bad_input, fmt::format("{}: {}", out, why));
  };
  if (!setup.trails.empty() && format.arrays)
    refuse("trails are for pictures of a run; leave out --trail and --trails");
  const double poses = static_cast<double>(setup.frames) * static_cast<double>(start.model->size());
  if (poses > kMostPoses)
    refuse(fmt::format("{} frames of {} bodies; at most {:.0e} poses: take fewer --fps or less --time",
                       setup.frames, start.model->size(), kMostPoses));
  if (format.arrays && poses * kNpzBytesAPose > kMostNpzBytes)
    refuse(fmt::format(
        "{:.1f} GB of poses; at most {:.1f}, contacts beside them: take fewer --fps or less --time",
        poses * kNpzBytesAPose / 1e9, kMostNpzBytes / 1e9));
  check_overwrite(out, out, {setup.force, &setup.inputs});
  return format.make(out, scene, start, setup);
}

}  // namespace pabd
