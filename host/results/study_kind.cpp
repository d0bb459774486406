// SPDX-License-Identifier: MIT
#include "results/study_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "config/errors.hpp"
#include "process/child.hpp"
#include "texts/message.hpp"

namespace regista::results {

plugin::Catalogue open_plugins(const std::vector<std::string>& folders, const Invocation& invocation) {
  const std::vector<std::filesystem::path> options(folders.begin(), folders.end());
  return plugin::Catalogue(plugin::Catalogue::search_path(options, std::getenv("REGISTA_PLUGIN_PATH"),
                                                          invocation.own("lib/regista/plugins")));
}

plugin::Catalogue open_stored_plugins(const std::string& file, const std::vector<std::string>& folders,
                                      const Invocation& invocation) {
  for (const std::string& each : folders) {
    std::error_code error;
    if (std::filesystem::is_directory(each, error)) continue;
    const std::string write = process::shell_line({"regista", "report", file, "--study", "again"});
    throw config::BadInput(texts::one_line(fmt::format(
        "{}: it was played with the plugins of {}, which is no folder any more; put it back, or play its study "
        "with others: {}, then regista run again/study.yaml --plugins DIR",
        file, std::filesystem::absolute(each).lexically_normal().string(), write)));
  }
  return open_plugins(folders, invocation);
}

const StudyKind* study_asked(const config::Node& document, std::span<const StudyKind> kinds) {
  const auto found =
      std::ranges::find_if(kinds, [&](const StudyKind& each) { return bool(document[each.document.name]); });
  return found == kinds.end() ? nullptr : &*found;
}

std::vector<config::DocumentKind> document_kinds(const Invocation& invocation) {
  const std::span<const config::DocumentKind> always = config::document_kinds();
  std::vector<config::DocumentKind> out(always.begin(), always.end());
  for (const StudyKind& each : invocation.studies) texts::add_once(out, each.document);
  return out;
}

std::vector<std::string> kind_names(const Invocation& invocation) {
  return texts::names_of(document_kinds(invocation), &config::DocumentKind::name);
}

config::DocumentKind kind_named(const std::string& name, std::string_view command, const Invocation& invocation) {
  const std::vector<config::DocumentKind> kinds = document_kinds(invocation);
  if (const auto found = std::ranges::find(kinds, name, &config::DocumentKind::name); found != kinds.end())
    return *found;
  throw config::BadInput(
      fmt::format("{}: {}", command, texts::unknown("kind of document", name, "", kind_names(invocation))));
}

config::DocumentKind kind_of(const config::Node& document, const Invocation& invocation) {
  const StudyKind* const study = study_asked(document, invocation.studies);
  return study != nullptr ? study->document : config::kind_of(document);
}

}  // namespace regista::results
