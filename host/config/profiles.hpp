// SPDX-License-Identifier: MIT
// The declarations of the three profiles; that of the team page is in team_page.hpp.
#pragma once

#include "config/declaration.hpp"
#include "config/disturbance.hpp"
#include "config/robot.hpp"
#include "config/rules.hpp"

namespace regista::config {

Map declare(Rules& rules);
Map declare(Robot& robot);
Map declare(Disturbance& disturbance);

}  // namespace regista::config
