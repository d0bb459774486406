// SPDX-License-Identifier: MIT
#include "report/search_comparison_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <utility>
#include <vector>

#include "process/program.hpp"
#include "report/fingerprint.hpp"
#include "report/search_comparison.hpp"
#include "report/search_comparison_figures.hpp"
#include "report/search_comparison_page.hpp"
#include "report/search_comparison_sentences.hpp"
#include "report/tuning_problem.hpp"
#include "study/tuning/search_comparison.hpp"

namespace regista::report {
namespace {

class SearchComparisonReport final : public StudyReport {
 public:
  explicit SearchComparisonReport(study::SearchComparisonPlan plan) : plan_(std::move(plan)), study_(plan_) {}
  SearchComparisonReport(const SearchComparisonReport&) = delete;
  SearchComparisonReport& operator=(const SearchComparisonReport&) = delete;

  study::Study& study() override { return study_; }
  const study::Study& study() const override { return study_; }

  std::string title() const override { return comparison_title(view()); }
  std::string question() const override { return plan_.tuning.question; }
  std::string headline() const override { return comparison_verdict(view()).headline; }
  std::vector<std::string> notes() const override { return problem_notes(plan_.tuning); }
  std::string standing() const override { return search_comparison_standing(view()); }
  std::string match(const study::Round& round, std::uint64_t index, const campaign::Decided& decided) const override {
    const auto stage = study_.record().stage;
    return match_text(stage ? study::name(*stage) : "", round.job(index), decided);
  }

  std::string text() const override { return search_comparison_text(view()); }
  std::string json() const override { return search_comparison_json(view()); }
  std::string incomplete() const override {
    if (!study_.record().stage) return {};
    return fmt::format("{} matches: the comparison is not at its end", study_.counted());
  }

  bool is_table_of_matches() const override { return false; }
  std::string begin_table(const TableWish& /*wish*/) override { return {}; }
  std::string table_lines(const study::Round& /*round*/, std::uint64_t /*index*/,
                          const campaign::Decided& /*decided*/) override {
    return {};
  }
  std::string end_table() const override { return search_comparison_csv(view()); }

  void take(const study::Round& round, std::uint64_t index, const campaign::Decided* decided) override {
    fingerprint_.take(round.first_row + index, *decided);
  }
  std::vector<Figure> figures() const override { return search_comparison_figures(view()); }
  std::string page(PageFrame frame) const override {
    return search_comparison_page(
        {view(),
         std::move(frame.figures),
         {frame.program, fingerprint_.text(), process::command_line(search_comparison_arguments(plan_))}});
  }

 private:
  SearchComparisonView view() const { return {plan_, study_.record()}; }

  study::SearchComparisonPlan plan_;
  study::SearchComparison study_;
  Fingerprint fingerprint_;
};

}  // namespace

std::vector<std::string> search_comparison_arguments(const study::SearchComparisonPlan& plan) {
  std::vector<std::string> names;
  for (const study::Algorithm each : plan.algorithms) names.emplace_back(name(each));
  return tuning_arguments(
      plan.tuning, {"--compare", fmt::format("{}", fmt::join(names, ",")), "--repeats", std::to_string(plan.repeats)});
}

std::unique_ptr<StudyReport> search_comparison_report(study::SearchComparisonPlan plan) {
  return std::make_unique<SearchComparisonReport>(std::move(plan));
}

}  // namespace regista::report
