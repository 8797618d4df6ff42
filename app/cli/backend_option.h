// SPDX-License-Identifier: MIT
// --backend: where OpenGL comes from.
#pragma once

#include <string>

#include "app/cli/help_text.h"
#include "render/context/context.h"

namespace pabd::cli {

inline void add_backend_option(CLI::App& command, std::string& backend) {
  command.add_option("--backend", backend, "where OpenGL comes from: auto, egl, osmesa (default auto)")
      ->type_name("NAME")
      ->group(group::kPicture)
      ->check(CLI::IsMember({"auto", "egl", "osmesa"}));
}

inline Backend parse_backend(const std::string& name) {
  if (name == "egl") return Backend::egl;
  if (name == "osmesa") return Backend::osmesa;
  return Backend::automatic;
}

}  // namespace pabd::cli
