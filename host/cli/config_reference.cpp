// SPDX-License-Identifier: MIT
// `regista config reference`: a page of Markdown about all kinds of documents, for a web site or a repository.
#include "config/reference.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "output/output.hpp"
#include "results/document_kinds.hpp"

namespace regista::cli {
namespace {

constexpr auto config_reference_examples = R"(Examples:
  regista config reference > docs/config-reference.md
  regista config reference team)";

std::string reference(const std::vector<std::string>& kinds, const Invocation& invocation) {
  std::vector<config::DocumentKind> wanted;
  for (const std::string& each : kinds) wanted.push_back(results::kind_named(each, "config reference", invocation));
  return config::reference_text(wanted.empty() ? results::document_kinds(invocation) : wanted);
}

}  // namespace

void add_config_reference(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("reference", "write the reference of all kinds of documents as Markdown");
  const auto kinds = std::make_shared<std::vector<std::string>>();
  command.choose("kind", *kinds, results::kind_names(invocation), "these kinds alone");
  command.notes(config_reference_examples);
  command.run = [kinds, &invocation] {
    output::print(reference(*kinds, invocation));
    return exit_done;
  };
}

}  // namespace regista::cli
