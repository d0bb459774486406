// SPDX-License-Identifier: MIT
// A kind of study, as a file of results needs it: which report reads its plan, and how it goes on.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "campaign/options.hpp"
#include "campaign/store.hpp"
#include "output/output_files.hpp"
#include "report/study_report.hpp"
#include "results/invocation.hpp"

namespace regista::results {

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

}  // namespace regista::results
