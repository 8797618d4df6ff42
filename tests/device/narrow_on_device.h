// SPDX-License-Identifier: MIT
// The narrow phase of the GPU, one dispatch for many pairs of bodies.
#pragma once

#include <memory>
#include <vector>

#include "render/context/context.h"
#include "render/device/shape_table.h"
#include "sim/collision/detect.h"

namespace pabd::testing {

// Two bodies where they stand; the first goes first (sim/collision/narrow_phase.h).
struct PlacedPair {
  Vec3 c[2];
  Mat3 R[2];
  std::uint32_t shape[2];  // in the table
  double reach = 0;        // of both together; m
};

class NarrowOnDevice {
 public:
  // `numbers`: kWideIsFloat or kWideIsDouble.
  explicit NarrowOnDevice(const char* numbers);
  ~NarrowOnDevice();

  // The contacts of each pair as `detect` has them, those of one pair sorted by feature; bodies 0 and 1. All shapes of
  // one place in the pairs are of one kind, or the first two kinds come in either order.
  std::vector<std::vector<ContactPoint>> contacts(const ShapeTable& table, int kind_0, int kind_1,
                                                  const std::vector<PlacedPair>& pairs);

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace pabd::testing
