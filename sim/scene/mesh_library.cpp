// SPDX-License-Identifier: MIT
// See mesh_library.h. In the order: file, surface, closed, scaled, hull.
#include "sim/scene/mesh_library.h"

#include <fmt/format.h>

#include "sim/base/error.h"
#include "sim/base/hash.h"
#include "sim/base/input_file.h"
#include "sim/body/convex_hull.h"
#include "sim/scene/mesh_surface.h"
#include "sim/scene/model_builder.h"
#include "sim/scene/text.h"

namespace pabd {
namespace {

[[noreturn]] void refuse(const std::string& message) { throw Error(ErrorKind::bad_input, message); }

}  // namespace

std::string read_mesh_file(const std::filesystem::path& file) {
  std::error_code unknown;
  if (!std::filesystem::exists(file, unknown) && !unknown)
    refuse("the file does not exist; expected a mesh beside the scene");
  std::string bytes, problem;
  switch (try_read_file(file, kMostMeshBytes, bytes, problem)) {
    case ReadOutcome::unreadable:
      refuse("cannot be read: " + problem + "; expected a mesh");
    case ReadOutcome::too_long:
      refuse(problem + "; expected a smaller file, simplify the mesh");
    case ReadOutcome::done:
      break;
  }
  if (bytes.empty()) refuse("the file is empty; expected a mesh");
  return bytes;
}

std::string ending_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  if (!ending.empty()) ending.erase(0, 1);
  for (char& c : ending) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return ending;
}

MeshSurface read_surface(std::string_view bytes, std::string_view ending) {
  if (ending == "obj") return read_obj(bytes);
  if (ending == "stl") return read_stl(bytes);
  if (ending == "ply") return read_ply(bytes);
  refuse("unknown kind of mesh; expected a name that ends in .obj, .stl or .ply");
}

Hull read_mesh_hull(std::string_view bytes, std::string_view ending, double scale) {
  const MeshSurface surface = read_surface(bytes, ending);
  std::vector<Vec3> used(surface.corners.size());
  Vec3 lo = Vec3::Constant(1e300), hi = -lo;
  for (std::size_t k = 0; k < used.size(); ++k) {
    used[k] = scale * surface.points[surface.corners[k]];
    lo = lo.cwiseMin(used[k]);
    hi = hi.cwiseMax(used[k]);
  }
  if (!(lo.minCoeff() >= -kFarthest && hi.maxCoeff() <= kFarthest)) {
    refuse(
        fmt::format("a point is farther than {} m from the origin; expected a smaller \"scale\"", kFarthest));
  }
  if (!((hi - lo).maxCoeff() >= kSizeRange.lo)) {
    refuse(fmt::format("smaller than {} m; expected a larger \"scale\"", kSizeRange.lo));
  }
  require_closed(surface);
  HullResult result = make_hull(used);
  if (!result.hull) refuse(result.problem);
  return Hull{std::move(result.hull)};
}

const MeshLibrary::Entry& MeshLibrary::load(const std::string& file, double scale) {
  const auto [place, fresh] = entries_.try_emplace({file, scale});
  if (!fresh) return place->second;
  try {
    if (may_read_) may_read_(folder_ / file);
    const std::string bytes = read_mesh_file(folder_ / file);
    place->second.hull = read_mesh_hull(bytes, ending_of(file), scale);
    Hash64 hash;
    hash.add_text(bytes);
    place->second.digest = hash.hex();
  } catch (const Error& error) {
    entries_.erase(place);
    refuse(fmt::format("{}: {}", printable(file), error.what()));
  }
  return place->second;
}

void MeshLibrary::enter(const std::string& name, const Hull& hull) {
  Hash64 hash;
  for (const Vec3& vertex : hull.data->vertices) {
    for (const double x : vertex) hash.add_number(x);
  }
  entries_[{name, 1}] = {hull, hash.hex(), false};
}

void MeshLibrary::enter(const std::vector<std::string>& names, const Compound& compound) {
  compounds_[{names, 1}] = compound;
}

std::vector<std::filesystem::path> MeshLibrary::files() const {
  std::vector<std::filesystem::path> list;
  for (const auto& [key, entry] : entries_) {
    if (entry.file) list.push_back(folder_ / key.first);
  }
  return list;
}

const Compound& MeshLibrary::load_parts(const std::vector<std::string>& files, double scale) {
  const auto [place, fresh] = compounds_.try_emplace({files, scale});
  if (fresh) {
    std::vector<Hull> hulls;
    for (const std::string& file : files) hulls.push_back(load(file, scale).hull);
    place->second = make_compound(hulls);
  }
  return place->second;
}

}  // namespace pabd
