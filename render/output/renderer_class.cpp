// SPDX-License-Identifier: MIT
// Which renderers give the same pixels, told from GL_RENDERER.
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

#include "render/output/compare_images.h"
#include "sim/base/utf8.h"

namespace pabd {
namespace {

// "llvmpipe (LLVM 15.0.6, 256 bits)": code for other vectors may round elsewhere.
std::string llvmpipe_class(const std::string& name) {
  constexpr std::array<std::pair<std::string_view, const char*>, 3> widths = {
      {{"128 bits", "llvmpipe-128"}, {"256 bits", "llvmpipe-256"}, {"512 bits", "llvmpipe-512"}}};
  for (const auto& [bits, result] : widths) {
    if (name.find(bits) != std::string::npos) return result;
  }
  return "llvmpipe";
}

}  // namespace

std::string renderer_class(const std::string& gl_renderer) {
  const std::string name = lower_case(gl_renderer);
  if (name.starts_with("llvmpipe")) return llvmpipe_class(name);

  std::string word;  // also safe as a folder name
  for (char c : name) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
    if (letter) {
      word += c;
    } else if (!word.empty()) {
      break;
    }
  }
  // Layers over another driver are their own class: their pixels are not the driver's.
  for (const char* layer : {"softpipe", "zink", "virgl", "angle", "d3d12", "svga3d"}) {
    if (word == layer) return word;
  }
  constexpr std::array<std::pair<std::string_view, const char*>, 11> makers = {{{"nvidia", "nvidia"},
                                                                                {"geforce", "nvidia"},
                                                                                {"quadro", "nvidia"},
                                                                                {"tesla", "nvidia"},
                                                                                {"radeon", "amd"},
                                                                                {"amd", "amd"},
                                                                                {"intel", "intel"},
                                                                                {"apple", "apple"},
                                                                                {"mali", "mali"},
                                                                                {"adreno", "adreno"},
                                                                                {"videocore", "videocore"}}};
  for (const auto& [part, maker] : makers) {
    if (name.find(part) != std::string::npos) return maker;
  }
  return word.empty() ? "unknown" : word;
}

}  // namespace pabd
