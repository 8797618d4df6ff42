// SPDX-License-Identifier: MIT
#include "sim/potential/barrier.h"

#include <algorithm>

#include "sim/potential/barrier_traits.h"

namespace pabd {
namespace {

template <class Kind>
BarrierValue value_of(const Barrier& b, double d) {
  if constexpr (HasSum<Kind>) {
    const PowerSum<double> sum = Kind::template sum<double>(b, 1 - d / b.d_hat);
    return {b.kappa * sum.value, -b.kappa * sum.first / b.d_hat, b.kappa * sum.second / (b.d_hat * b.d_hat)};
  } else {
    return Kind::evaluate(b, d);
  }
}

template <class Kind>
Split split_of(const Barrier& b, double x) {
  if constexpr (Kind::traits.has_split) {
    return Kind::split(b, x);
  } else {
    return {0, 0};
  }
}

}  // namespace

const char* to_string(BarrierKind kind) {
  static constexpr const char* kWords[] = {
#define PABD_KIND(name) #name,
      PABD_BARRIERS(PABD_KIND)
#undef PABD_KIND
  };
  return kWords[static_cast<std::size_t>(kind)];
}

const BarrierTraits& traits_of(BarrierKind kind) {
  static constexpr const BarrierTraits* kTraits[] = {
#define PABD_KIND(name) &barriers::name::traits,
      PABD_BARRIERS(PABD_KIND)
#undef PABD_KIND
  };
  return *kTraits[static_cast<std::size_t>(kind)];
}

BarrierValue evaluate(const Barrier& barrier, double d) {
  if (d >= barrier.d_hat) return {0, 0, 0};
  switch (barrier.kind) {
#define PABD_KIND(name)   \
  case BarrierKind::name: \
    return value_of<barriers::name>(barrier, d);
    PABD_BARRIERS(PABD_KIND)
#undef PABD_KIND
  }
  return {0, 0, 0};
}

Split binomial_split(const Barrier& barrier, double d) {
  if (d >= barrier.d_hat) return {0, 0};
  const double x = d / barrier.d_hat;
  Split split{0, 0};
  switch (barrier.kind) {
#define PABD_KIND(name)                           \
  case BarrierKind::name:                         \
    split = split_of<barriers::name>(barrier, x); \
    break;
    PABD_BARRIERS(PABD_KIND)
#undef PABD_KIND
  }
  split.stiffness *= barrier.kappa;
  split.force *= barrier.kappa;
  return split;
}

Split tangent_split(const Barrier& barrier, double d) {
  if (d >= barrier.d_hat) return {0, 0};
  const BarrierValue psi = evaluate(barrier, d);
  const double stiffness = std::max(psi.second, psi.first / (d - barrier.d_hat));
  return {stiffness, psi.first - stiffness * d};
}

}  // namespace pabd
