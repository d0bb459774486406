// SPDX-License-Identifier: MIT
// Which studies there are: the one place that knows them all. Whoever reads a file of results finds here what it holds.
//
// A new study needs a study::Study in host/study, a report::StudyReport in host/report, a command in host/cli that
// command_line.cpp adds, and a row in study_kinds.cpp. tests/integration/fifth_study has these and nothing else; what a
// study with a document of its own needs besides stands in docs/architecture.md.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "campaign/options.hpp"
#include "campaign/store.hpp"
#include "cli/invocation.hpp"
#include "output/output_files.hpp"
#include "report/study_report.hpp"

namespace regista::cli {

struct StudyKind {
  std::string_view name;     // as the plan calls it: {"study": NAME, ...}
  std::string_view article;  // "a tournament"
  // What such a plan says, as a report whose study has yet to be read from the store. Throws std::invalid_argument for
  // what is no such plan, campaign::StoreError.
  std::function<std::unique_ptr<report::StudyReport>(const std::string& plan, const campaign::Store& store,
                                                     report::CommandOf again)>
      report;
  bool figures = true;  // stand beside its page
  // Such a plan with so many pairs of matches; empty: a study of this kind has no such number. Throws
  // std::invalid_argument, one line that says why it may not have them.
  std::function<std::string(const std::string& plan, std::uint64_t pairs)> with_pairs{};
  // Goes on with it, as play_study() does; empty: that is all.
  std::function<int(const std::string& plan, const campaign::Options& options, const output::OutputFiles& outputs,
                    const Invocation& invocation)>
      go_on{};
};

std::span<const StudyKind> study_kinds();

}  // namespace regista::cli
