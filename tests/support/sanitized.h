// SPDX-License-Identifier: MIT
// PABD_SANITIZED: is this built with AddressSanitizer, which brings its own operator new? Each compiler says it in
// its own way.
#pragma once

#if defined(__SANITIZE_ADDRESS__)
#define PABD_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define PABD_SANITIZED
#endif
#endif
