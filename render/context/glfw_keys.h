// SPDX-License-Identifier: MIT
// GLFW's numbers of keys as our names.
#pragma once

#include "render/context/keyboard.h"

namespace pabd {

// Key::none for keys that we have no name for. Letters go by what is printed on the key in the person's
// layout.
Key key_of_glfw(int key, int scancode);
Modifiers modifiers_of_glfw(int bits);

}  // namespace pabd
