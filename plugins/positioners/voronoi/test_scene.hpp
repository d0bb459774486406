// SPDX-License-Identifier: GPL-3.0-or-later
// The scene in which both plugins show cells.
#pragma once

#include <regista/testkit/frame_builder.hpp>

namespace voronoi {

// Cells are due to robots 2 and 5, with the border at x = 0.5: 3 is not active, and 6 stands where 5 does.
inline regista::testkit::Scene two_robots_with_cells() {
  return regista::testkit::FrameBuilder{}
      .own(2)
      .robot(2)
      .at(-1, 0)
      .robot(3)
      .at(0, 0)
      .inactive()
      .robot(5)
      .at(2, 0)
      .robot(6)
      .at(2, 0)
      .opponent(1.0, 0.5)
      .build()
      .before_tasks();
}

}  // namespace voronoi
