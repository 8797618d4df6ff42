// SPDX-License-Identifier: MIT
// Every panel, in the order of help and of places. A new one is its file in panels/ and a line here.
#pragma once

#include "app/overlay/overlay_panel.h"

// clang-format off
#define PABD_OVERLAY_PANELS(X) \
  X(params)      /* the parameters of the run */ \
  X(barrier)     /* with every contact on it */ \
  X(convergence) /* of the last step */ \
  X(series)      /* gap, energy and errors over time */ \
  X(legend)      /* of contact colours */ \
  X(difference)  /* of two runs beside each other */ \
  X(joints)      /* legend of joints */ \
  X(colors)      /* legend of the colours of bodies */
// clang-format on

namespace pabd {

// params_overlay, barrier_overlay, …
#define PABD_DECLARE(name) extern const OverlayPanel name##_overlay;
PABD_OVERLAY_PANELS(PABD_DECLARE)
#undef PABD_DECLARE

inline PanelTable overlay_panels() {
#define PABD_ROW(name) &name##_overlay,
  static constexpr const OverlayPanel* kPanels[] = {PABD_OVERLAY_PANELS(PABD_ROW)};
#undef PABD_ROW
  return kPanels;
}

}  // namespace pabd
