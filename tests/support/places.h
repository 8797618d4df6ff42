// SPDX-License-Identifier: MIT
// Where the project and what was built of it are. One file knows, so that a compiler cache knows all others in every
// checkout.
#pragma once

#include <string>

namespace pabd::places {

std::string project();         // the checkout
std::string assets();          // its shipped scenes, meshes and schemas
std::string scenes();          // assets/scenes
std::string tests();           // its tests
std::string build();           // where CMake builds
std::string program();         // the built pabd
std::string full_disk();       // a library to preload: a disk that is full
std::string fake_drivers();    // a program that tries drivers of OpenGL that crash
std::string public_headers();  // of the libraries that are installed, with commas between them

}  // namespace pabd::places
