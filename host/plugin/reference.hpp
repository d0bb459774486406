// SPDX-License-Identifier: MIT
// The reference of all plugins as a page of Markdown, made from what they declare: docs/plugin-reference.md.
#pragma once

#include <string>

#include "plugin/catalogue.hpp"

namespace regista::plugin {

// By kind, then by id, with a table of parameters for each. Says nothing of files and builds, so that the page is the
// same wherever it is made.
std::string reference_text(const Catalogue& catalogue);

}  // namespace regista::plugin
