// SPDX-License-Identifier: MIT
// Profiles whose values are sound one by one, but cannot be played together.
#pragma once

#include "config/disturbance.hpp"
#include "config/node.hpp"
#include "config/robot.hpp"
#include "config/rules.hpp"

namespace regista::config {

// Each throws Error at the value of the document that does not fit, with the reason.
void check(const Rules& rules, const Node& document);
void check(const Robot& robot, const Node& document);
void check(const Robot& robot, const Rules& rules, const Node& document);  // of the robot

}  // namespace regista::config
