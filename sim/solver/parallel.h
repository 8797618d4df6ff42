// Loops over independent items. The result does not depend on the number of threads because every item writes
// only its own entries and sums are made afterwards in order.
#pragma once

#include <cstddef>

namespace pabd {

template <class Body>
void parallel_for(int threads, std::size_t count, const Body& body) {
  constexpr std::size_t kWorthwhile = 256;  // below this a team of threads costs more than it saves
  if (threads <= 1 || count < kWorthwhile) {
    for (std::size_t k = 0; k < count; ++k) body(k);
    return;
  }
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::size_t k = 0; k < count; ++k) body(k);
}

}  // namespace pabd
