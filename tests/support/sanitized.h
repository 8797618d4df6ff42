// SPDX-License-Identifier: MIT
// PABD_SANITIZED: is this built with AddressSanitizer or ThreadSanitizer, which take their time and bring their own operator
// new? Each compiler says it in its own way.
#pragma once

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define PABD_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define PABD_SANITIZED
#endif
#endif
