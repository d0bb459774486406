// SPDX-License-Identifier: MIT
#include "results/document_kinds.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "config/bad_input.hpp"
#include "results/study_kind.hpp"
#include "texts/message.hpp"

namespace regista::results {

std::vector<config::DocumentKind> document_kinds(const Invocation& invocation) {
  const std::span<const config::DocumentKind> always = config::document_kinds();
  std::vector<config::DocumentKind> out(always.begin(), always.end());
  for (const StudyKind& each : invocation.studies) {
    if (std::ranges::find(out, each.document) == out.end()) out.push_back(each.document);
  }
  return out;
}

std::vector<std::string> kind_names(const Invocation& invocation) {
  std::vector<std::string> out;
  for (const config::DocumentKind& kind : document_kinds(invocation)) out.emplace_back(kind.name);
  return out;
}

config::DocumentKind kind_named(const std::string& name, std::string_view command, const Invocation& invocation) {
  for (const config::DocumentKind& kind : document_kinds(invocation)) {
    if (kind.name == name) return kind;
  }
  throw config::BadInput(
      fmt::format("{}: {}", command, texts::unknown("kind of document", name, "", kind_names(invocation))));
}

config::DocumentKind kind_of(const config::Node& document, const Invocation& invocation) {
  for (const StudyKind& each : invocation.studies) {
    if (document[each.document.name]) return each.document;
  }
  return config::kind_of(document);
}

}  // namespace regista::results
