// SPDX-License-Identifier: MIT
// Profiles whose values are sound one by one, but cannot be played together.
#pragma once

#include "config/disturbance.hpp"
#include "config/mistakes.hpp"
#include "config/node.hpp"
#include "config/robot.hpp"
#include "config/rules.hpp"

namespace regista::config {

// Each tells of the values of the document that do not fit, with the reason.
void check(const Rules& rules, const Node& document, Mistakes& mistakes);
void check(const Robot& robot, const Node& document, Mistakes& mistakes);

// Throws Error at the first value of the robot's document that does not fit.
void check(const Robot& robot, const Rules& rules, const Node& document);

}  // namespace regista::config
