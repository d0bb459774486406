// SPDX-License-Identifier: MIT
// Texts from files, as reports show them: as whatever the program says does.
#pragma once

#include "config/visible_text.hpp"

namespace regista::report {

using config::visible;
using config::visible_at_most;
using config::visible_lines;

}  // namespace regista::report
