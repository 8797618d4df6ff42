// SPDX-License-Identifier: MIT
// Pictures against approved ones (baselines) in tests/golden/<renderer class>/<name>.png.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

#include "render/output/compare_images.h"
#include "render/output/image.h"

namespace pabd {

struct GoldenFolders {
  std::filesystem::path baselines, failures;
  std::ostream* notes = nullptr;  // null: standard error
};

GoldenFolders golden_folders();  // of this repository and build folder

// Compares with the baseline of the same renderer class when there is one, else across classes with that of
// llvmpipe-128, which is more lenient and therefore said: a line a class that has no pictures at all, else a
// line a picture. No baseline at all is a failure. A failure leaves actual, expected and difference in
// folders.failures; `reason` names them. With PABD_UPDATE_GOLDEN=1 in the environment the picture becomes the
// baseline of its class instead, with 2 its second one, <name>.2.png, which is as good. `renderer` is GL_RENDERER. Throws Error(file) or Error(bad_input) for files
// that cannot be read or written.
CompareResult check_golden(const Image& image, const std::string& name, const std::string& renderer,
                           const GoldenFolders& folders = golden_folders());

}  // namespace pabd
