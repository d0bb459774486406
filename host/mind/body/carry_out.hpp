// SPDX-License-Identifier: MIT
// From the action that a behaviour asks for to the command that the body gets: the way around whoever stands in it, and
// the limits of the walk.
#pragma once

#include <regista/abi.h>

#include "mind/body/body.hpp"
#include "mind/command.hpp"

namespace regista::mind {

// `action` as plugin::Behaviour has checked it. A robot that kicks does not walk.
Command carry_out(const Body& body, const regista_action& action);

}  // namespace regista::mind
