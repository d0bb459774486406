// SPDX-License-Identifier: MIT
// What documents may hold, as a page of Markdown written from their declarations: each key with its values, default
// and meaning.
#pragma once

#include <span>
#include <string>

#include "config/documents.hpp"

namespace regista::config {

// Of these kinds of documents, in this order, and of the forms of values that they refer to.
std::string reference_text(std::span<const DocumentKind> kinds);

}  // namespace regista::config
