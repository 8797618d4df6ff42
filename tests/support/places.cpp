// SPDX-License-Identifier: MIT
#include "tests/support/places.h"

namespace pabd::places {

std::string project() { return PABD_SOURCE_DIR; }
std::string assets() { return PABD_SOURCE_DIR "/assets"; }
std::string scenes() { return PABD_SOURCE_DIR "/assets/scenes"; }
std::string tests() { return PABD_SOURCE_DIR "/tests"; }
std::string build() { return PABD_BINARY_DIR; }
std::string program() { return PABD_PROGRAM; }
std::string full_disk() { return PABD_FULL_DISK; }
std::string fake_drivers() { return PABD_FAKE_DRIVERS; }
std::string public_headers() { return PABD_PUBLIC_HEADERS; }

}  // namespace pabd::places
