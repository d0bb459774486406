// SPDX-License-Identifier: MIT
// Kinds of documents as commands choose them: those of config, and those of further studies of the program.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/documents.hpp"
#include "results/invocation.hpp"

namespace regista::results {

std::vector<config::DocumentKind> document_kinds(const Invocation& invocation);
std::vector<std::string> kind_names(const Invocation& invocation);

// Throws config::BadInput for an unknown one, in the name of the command that asks for it.
config::DocumentKind kind_named(const std::string& name, std::string_view command, const Invocation& invocation);

// What a document is. Throws config::Error at it when it says no kind.
config::DocumentKind kind_of(const config::Node& document, const Invocation& invocation);

}  // namespace regista::results
