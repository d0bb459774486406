// SPDX-License-Identifier: MIT
#include "cli/document_kind.hpp"

#include <fmt/format.h>

#include "config/bad_input.hpp"
#include "texts/message.hpp"

namespace regista::cli {

std::vector<std::string> kind_names() {
  std::vector<std::string> out;
  for (const config::DocumentKind kind : config::document_kinds()) out.emplace_back(config::name_of(kind));
  return out;
}

config::DocumentKind kind_named(const std::string& name, std::string_view command) {
  for (const config::DocumentKind kind : config::document_kinds()) {
    if (config::name_of(kind) == name) return kind;
  }
  throw config::BadInput(fmt::format("{}: {}", command, texts::unknown("kind of document", name, "", kind_names())));
}

}  // namespace regista::cli
