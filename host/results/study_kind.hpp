// SPDX-License-Identifier: MIT
// A kind of study: which document asks for it, how that is planned, which report reads the plan, and how it goes on.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/options.hpp"
#include "campaign/store.hpp"
#include "config/documents.hpp"
#include "output/output_files.hpp"
#include "plugin/catalogue.hpp"
#include "report/study_report.hpp"
#include "results/invocation.hpp"

namespace regista::results {

// What a document asks for, once it is planned.
struct PlannedStudy {
  std::string plan;                      // {"study": NAME, ...}
  std::string name;                      // that its document gives it
  std::vector<std::string> documents{};  // of the teams, resolved, where the plan does not hold them
};

struct StudyKind {
  std::string_view name;     // as the plan calls it
  std::string_view article;  // "a tournament"
  const config::DocumentKind& document;
  // plugins: folders of the catalogue. Throws config::BadInput and config::Error, at the place that asks for what
  // cannot be.
  std::function<PlannedStudy(const config::Node& document, const std::vector<std::string>& plugins,
                             const plugin::Catalogue& catalogue)>
      plan;
  // What such a plan says, as a report whose study has yet to be run. store: where it was played; null: nowhere yet.
  // Throws std::invalid_argument for what is no such plan, campaign::StoreError.
  std::function<std::unique_ptr<report::StudyReport>(const std::string& plan, const campaign::Store* store,
                                                     report::CommandOf again)>
      report;
  bool figures = true;  // beside its page
  // Such a plan with so many pairs of matches; empty: a study of this kind has no such number. Throws
  // std::invalid_argument, one line that says why it may not have them.
  std::function<std::string(const std::string& plan, std::uint64_t pairs)> with_pairs{};
  // Begins it, or goes on with it, to its report: the exit code. Empty: play_study() does.
  std::function<int(const std::string& plan, const campaign::Options& options, const output::OutputFiles& outputs,
                    const Invocation& invocation)>
      play{};
  // Lists every mistake for which such a document, sound in itself, cannot be planned. Empty: the first one, of plan().
  std::function<void(const config::Node& document, const std::vector<std::string>& plugins,
                     const plugin::Catalogue& catalogue, config::Mistakes& mistakes)>
      check{};
};

}  // namespace regista::results
