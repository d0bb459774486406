// SPDX-License-Identifier: MIT
#include "cli/study_commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "cli/plugin_folders.hpp"
#include "results/results_file.hpp"
#include "texts/message.hpp"

namespace regista::cli {

const results::StudyKind& study_kind(const config::DocumentKind& document) {
  return *std::ranges::find_if(study_kinds(),
                               [&](const results::StudyKind& each) { return each.document == document; });
}

// A study that is played again says what it was played with.
static void name_missing_plugins(const config::Node& document, const plugin::Catalogue& catalogue) {
  constexpr std::string_view kind = "plugin ";
  for (const config::Node& line : document["played_with"].elements()) {
    if (line.kind() != config::Node::Kind::scalar || !line.text().starts_with(kind)) continue;
    const std::string id = line.text().substr(kind.size(), line.text().find(' ', kind.size()) - kind.size());
    const bool there =
        std::ranges::any_of(catalogue.plugins(), [&](const auto& each) { return each.descriptor->id == id; });
    if (there) continue;
    complain(
        to_string(line.where()) +
        texts::one_line(fmt::format(
            ": it was played with the plugin {}, which none of the folders has; name its folder: --plugins DIR", id)));
  }
}

results::PlannedStudy planned(const results::StudyKind& kind, StudyOptions& options, output::OutputFiles& outputs,
                              const Invocation& invocation) {
  campaign::check(options);
  const config::Node document = config::requested(options.asked(), kind.document);
  const plugin::Catalogue catalogue = open_plugins(options.plugins, invocation);
  name_missing_plugins(document, catalogue);
  results::PlannedStudy out = kind.plan(document, options.plugins, catalogue);
  tell_what_is_not_used(catalogue, options.plugins);
  options.plugin_files = catalogue.used_files();
  if (options.results.empty()) options.results = out.name + ".db";
  outputs.read(folders_of(catalogue), Reads::plugins);
  using enum output::OutputFiles::Page;
  outputs.write_beside(options.results, options.no_page ? none : kind.figures ? with_figures : alone);
  return out;
}

int play(const results::StudyKind& kind, StudyOptions options, output::OutputFiles outputs,
         const Invocation& invocation, const WishesOf& wishes, bool force) {
  const results::PlannedStudy study = planned(kind, options, outputs, invocation);
  if (kind.play) return kind.play(study.plan, options, outputs, invocation);
  outputs.check(force);
  const report::CommandOf again = results::play_again(invocation);
  auto report = kind.report(study.plan, nullptr, again);
  campaign::Store store = results::open_results(options.results, options.resume, report->study(),
                                                {outputs.documents(), study.documents}, invocation.studies);
  if (options.resume) report = results::stored_study(options.results, store, again, invocation.studies);
  results::StudyWishes besides = wishes ? wishes(*report, outputs) : results::StudyWishes();
  besides.figures = kind.figures;
  return results::play_study(*report, options, invocation, store, besides);
}

}  // namespace regista::cli
