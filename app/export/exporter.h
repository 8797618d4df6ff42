// SPDX-License-Identifier: MIT
// A run as a file for other programs: glTF, USD or NumPy arrays, by the suffix of its name. README.md has the formats.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/session/frame_view.h"
#include "sim/base/output_path.h"
#include "sim/scene/scene.h"

namespace pabd {

// Poses (bodies × frames) that one export may have, and bytes of a .glb, whose length has 32 bits.
inline constexpr double kMostPoses = 50e6;
inline constexpr double kMostGlbBytes = 4294967295.0;
// Of the poses of an .npz, and as much again of its contacts.
inline constexpr double kMostNpzBytes = 2147483648.0;

struct ExportSetup {
  double fps = 30;          // frames a second, > 0
  std::int64_t frames = 0;  // that are to come: to refuse what would be too large
  int segments = 48;        // around round bodies: one of kSegments (render/visual/primitive_mesh.h)
  std::vector<TrailPoint> trails = {};  // .glb and .usda
  bool force = false;                   // overwrite what exists
  InputFiles inputs = {};               // that are never overwritten
};

// Takes the frames of one run in order, and writes them.
class Exporter {
 public:
  virtual ~Exporter() = default;  // without finish(): nothing is left under the final name
  // `frame`: number, from 0. Throws Error(bad_input) when other bodies are there than in the first frame,
  // Error(file) when something cannot be written.
  virtual void add(std::int64_t frame, const FrameView& view) = 0;
  virtual void finish() = 0;  // publishes; once
};

// A row of the table of formats. `scene` may go before the exporter does.
struct ExportFormat {
  const char* suffix;  // ".glb"
  const char* help;
  bool arrays;  // all states with contacts and joints, in memory until the end; no trails
  std::unique_ptr<Exporter> (*make)(const std::string& out, const Scene& scene, const FrameView& start,
                                    const ExportSetup& setup);
};
// By the suffix. Throws Error(bad_input) for another one.
const ExportFormat& export_format(const std::string& out);
std::string export_help();  // ".glb: …; .usda: …"

// `start`: what frame 0 shows. Throws Error(bad_input) for a name that is none of an export, what would be too large,
// or an existing output without `force`, Error(file) for a folder that cannot be written: all of it before the first
// frame.
std::unique_ptr<Exporter> make_exporter(const std::string& out, const Scene& scene, const FrameView& start,
                                        const ExportSetup& setup);

// Each kind, in its own file; make_exporter() checks names and sizes first.
std::unique_ptr<Exporter> make_gltf_exporter(const std::string& out, const Scene& scene,
                                             const FrameView& start, const ExportSetup& setup);
std::unique_ptr<Exporter> make_usd_exporter(const std::string& out, const Scene& scene,
                                            const FrameView& start, const ExportSetup& setup);
std::unique_ptr<Exporter> make_npz_exporter(const std::string& out, const Scene& scene,
                                            const FrameView& start, const ExportSetup& setup);

}  // namespace pabd
