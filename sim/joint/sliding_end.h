// SPDX-License-Identifier: MIT
// On which body the points of a joint lie that moves along its axis (Deviation D27).
//
// A load F of the body that hangs on the joint acts at a lever l from the points, and moves it by F/(4k) (1 + 2 l²/a²), a
// the arm, k the stiffness of a bond. With points that stay with the other body l grows with the way: 10 m on arms of
// 0.1 m are a factor of 20,000. With points that go along l is how far the centre of mass is from the anchor.
#pragma once

#include "sim/body/model.h"

namespace pabd {

// For all joints from `first` on: sets Joint::on_second, and lengthens arms that nobody chose to that lever. The points
// lie on the body that is more joints away from what cannot move; of two that are as far on the smaller one.
void settle_sliding_ends(Model& model, std::size_t first = 0);

}  // namespace pabd
