// SPDX-License-Identifier: MIT
// See include_library.h.
#include "sim/scene/include_library.h"

#include <fmt/format.h>

#include "sim/base/error.h"
#include "sim/base/input_file.h"
#include "sim/scene/document.h"
#include "sim/scene/text.h"

namespace fs = std::filesystem;

namespace pabd {
namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& problem) {
  throw Error(ErrorKind::bad_input, fmt::format("{}: {}", printable(name), problem));
}

// Two names of one file are one name.
fs::path real_path(const fs::path& file) {
  std::error_code unknown;
  fs::path out = fs::weakly_canonical(file, unknown);
  return unknown ? file.lexically_normal() : out;
}

SceneText read_scene_file(const fs::path& file, const MayRead&) {
  SceneText out;
  std::string problem;
  if (try_read_file(file, DocumentLimits{}.bytes, out.text, problem) != ReadOutcome::done)
    throw Error(ErrorKind::bad_input, "cannot be read: " + problem + "; expected a scene file");
  return out;
}

}  // namespace

IncludeLibrary::IncludeLibrary(std::string source, fs::path folder, MayRead may_read, ReadSceneText read_text)
    : may_read_(std::move(may_read)), read_text_(read_text ? std::move(read_text) : read_scene_file) {
  fs::path file = real_path(source);
  open_.push_back({std::move(source), std::move(file), std::move(folder)});
}

void IncludeLibrary::refuse_cycle(const std::string& name, const fs::path& file) const {
  for (std::size_t k = 0; k < open_.size(); ++k) {
    if (open_[k].file != file) continue;
    std::string chain;
    for (; k < open_.size(); ++k) chain += printable(open_[k].name) + " → ";
    refuse(name, "includes itself: " + chain + printable(name) + "; remove one of them");
  }
}

const SceneText& IncludeLibrary::text_of(const fs::path& file, const std::string& name) {
  const auto [place, fresh] = texts_.try_emplace(file);
  if (!fresh) return place->second;
  try {
    if (may_read_) may_read_(file);
    place->second = read_text_(file, may_read_);
  } catch (const Error& error) {
    texts_.erase(place);
    const std::string what = error.what(), whole = file.string();  // which the scene does not need to know
    if (what.starts_with(whole))
      throw Error(ErrorKind::bad_input, printable(name) + what.substr(whole.size()));
    refuse(name, what);
  }
  return place->second;
}

IncludeLibrary::Opened::Opened(IncludeLibrary& library, const std::string& name) : library_(library) {
  if (library.included_ == kMostIncludes)
    refuse(name, fmt::format("more than {} included scenes; expected fewer", kMostIncludes));
  ++library.included_;
  if (library.open_.size() > kDeepestInclude)
    refuse(name, fmt::format("more than {} scenes inside each other; expected fewer", kDeepestInclude));
  const fs::path file = library.open_.back().folder / name;
  const fs::path real = real_path(file);
  library.refuse_cycle(name, real);
  const SceneText& read = library.text_of(file, name);
  library.bytes_ += read.text.size();
  if (library.bytes_ > kMostIncluded)
    refuse(name, fmt::format("more than {} MiB of included scenes; expected fewer", kMostIncluded >> 20));
  const fs::path folder = file.parent_path();
  meshes_ = &library.meshes_.try_emplace(folder, folder, library.may_read_).first->second;
  text_ = &read.text;
  library.open_.push_back({name, real, folder});
}

IncludeLibrary::Opened::~Opened() { library_.open_.pop_back(); }

std::vector<fs::path> IncludeLibrary::files() const {
  std::vector<fs::path> out;
  for (const auto& [file, text] : texts_) {
    out.push_back(file);
    out.insert(out.end(), text.files.begin(), text.files.end());
  }
  for (const auto& [folder, meshes] : meshes_) {
    const auto read = meshes.files();
    out.insert(out.end(), read.begin(), read.end());
  }
  return out;
}

}  // namespace pabd
