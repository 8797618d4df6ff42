// SPDX-License-Identifier: MIT
// Takes the font file into the read-only data of the program. The assembler's .incbin reads 760 kB in no
// time; a generated C array would take seconds. PABD_FONT_FILE comes from CMakeLists.txt.
#include "app/plots/font_data.h"

asm(R"(
.pushsection .rodata
.balign 16
.local pabd_font_begin
.local pabd_font_end
pabd_font_begin:
.incbin ")" PABD_FONT_FILE R"("
pabd_font_end:
.balign 16
.popsection
)");

extern "C" {
extern const unsigned char pabd_font_begin[];
extern const unsigned char pabd_font_end[];
}

namespace pabd {

std::span<const unsigned char> font_bytes() { return {pabd_font_begin, pabd_font_end}; }

}  // namespace pabd
