// SPDX-License-Identifier: MIT
// `regista config reference`: a page of Markdown about all kinds of documents, for a web site or a repository.
#include "config/reference.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/document_kind.hpp"
#include "output/output.hpp"

namespace regista::cli {
namespace {

constexpr auto config_reference_examples = R"(Examples:
  regista config reference > docs/config-reference.md
  regista config reference team)";

std::string reference(const std::vector<std::string>& kinds) {
  if (kinds.empty()) return config::reference_text(config::document_kinds());
  std::vector<config::DocumentKind> wanted;
  for (const std::string& each : kinds) wanted.push_back(kind_named(each, "config reference"));
  return config::reference_text(wanted);
}

}  // namespace

void add_config_reference(Command& parent) {
  Command& command = parent.add("reference", "write the reference of all kinds of documents as Markdown");
  const auto kinds = std::make_shared<std::vector<std::string>>();
  command.choose("kind", *kinds, kind_names(), "these kinds alone");
  command.notes(config_reference_examples);
  command.run = [kinds] {
    output::print(reference(*kinds));
    return exit_done;
  };
}

}  // namespace regista::cli
