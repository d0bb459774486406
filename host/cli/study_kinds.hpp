// SPDX-License-Identifier: MIT
// Which studies there are: the one place that knows them all. Whoever reads a file of results finds here what it holds.
//
// A new study needs a study::Study in host/study, a report::StudyReport in host/report, a command in host/cli that
// command_line.cpp adds, and a row in study_kinds.cpp. tests/integration/fifth_study has these and nothing else; what a
// study with a document of its own needs besides stands in docs/architecture.md.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "campaign/store.hpp"
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
};

std::span<const StudyKind> study_kinds();

}  // namespace regista::cli
