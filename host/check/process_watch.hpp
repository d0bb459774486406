// SPDX-License-Identifier: MIT
// The process is the host's: signals, locale, rounding, files and processes are after a check what they were before.
#pragma once

#include <functional>

#include "check/child.hpp"

namespace regista::check {

// Runs `check`. What of the process is no longer as it was becomes part of the outcome.
Outcome leaving_the_process_alone(const std::function<Outcome()>& check);

}  // namespace regista::check
