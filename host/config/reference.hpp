// SPDX-License-Identifier: MIT
// Writes declarations as JSON Schema for editors, and as a Markdown page with values, default and meaning of each key.
#pragma once

#include <span>
#include <string>

#include "config/declaration.hpp"
#include "config/documents.hpp"

namespace regista::config {

// Returns the indented JSON Schema (draft 2020-12) of a document. The defaults in the schema are the object's values.
std::string schema(const Map& map, const std::string& title, std::span<const PluginDeclaration> plugins);

// Returns a Markdown page about these kinds of documents, in this order. The page also explains the syntax of values.
std::string reference_text(std::span<const DocumentKind> kinds);

}  // namespace regista::config
