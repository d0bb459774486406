// SPDX-License-Identifier: MIT
// Declares the documents of the three profiles (rules, robot, disturbance), and checks their values against each other.
#pragma once

#include "config/declaration.hpp"
#include "config/disturbance.hpp"
#include "config/errors.hpp"
#include "config/node.hpp"
#include "config/robot.hpp"
#include "config/rules.hpp"

namespace regista::config {

Map declare(Rules& rules);
Map declare(Robot& robot);
Map declare(Disturbance& disturbance);

// Each function reports values of the document that contradict each other, with the reason.
void check(const Rules& rules, const Node& document, Mistakes& mistakes);
void check(const Robot& robot, const Node& document, Mistakes& mistakes);

// Throws Error at the first value of the robot's document that contradicts the rules.
void check(const Robot& robot, const Rules& rules, const Node& document);

}  // namespace regista::config
