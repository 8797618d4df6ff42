// SPDX-License-Identifier: MIT
// Numbers as the bytes of a file that is little endian, as .glb and .npz are.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace pabd {

static_assert(std::endian::native == std::endian::little, "bytes would have to be turned round");

template <class T>
std::string_view bytes_of(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

template <class T>
void append_bytes(const T& value, std::string& out) {
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace pabd
