// SPDX-License-Identifier: MIT
#include "report/search_comparison_page.hpp"

#include <fmt/format.h>

#include <optional>

#include "report/estimate_text.hpp"
#include "report/experiment.hpp"
#include "report/html_table.hpp"
#include "report/match_remarks.hpp"
#include "report/objective_numbers.hpp"
#include "report/search_comparison_numbers.hpp"
#include "report/search_comparison_sentences.hpp"
#include "report/tuning_problem.hpp"

namespace regista::report {
namespace {

Html tiles(const SearchComparisonView& view) {
  const std::size_t parameters = view.plan.tuning.free_parameters(), algorithms = view.plan.algorithms.size();
  Html out = "<div class=\"tiles\">\n"_html;
  out << tile(whole_number(parameters), text(parameters == 1 ? "parameter" : "parameters"))
      << tile(whole_number(algorithms), text(algorithms == 1 ? "algorithm" : "algorithms"))
      << tile(whole_number(view.record.runs.size()), text(fmt::format("runs of {}", view.plan.runs())))
      << tile(whole_number(searched_matches(view) + judged_matches(view)),
              text(fmt::format("matches, of at most {}", most_matches(view.plan))));
  return out << "</div>\n"_html;
}

Html quartiles_cell(const std::optional<statistics::Quartiles>& of) {
  if (!of) return "–"_html;
  const double margin = (of->upper - of->lower) / 2.0;
  return text(fmt::format("{} [{}, {}]", rounded_with_sign(of->median, margin), rounded_with_sign(of->lower, margin),
                          rounded_with_sign(of->upper, margin)));
}

Html algorithms_section(const SearchComparisonPage& page) {
  const SearchComparisonView& view = page.view;
  const study::TuningObjective& objective = view.plan.tuning.objective;
  HtmlTable table({{"Algorithm"_html, Column::words},
                   {"Difference: median [quartiles]"_html},
                   {"Runs better than the base team"_html},
                   {"Evaluations of a run, median"_html},
                   {"Matches of a run, median"_html},
                   {"Runs"_html}});
  for (const AlgorithmSummary& each : algorithm_summaries(view)) {
    const bool any = !each.runs.empty();
    table.row({code(name(each.algorithm)), quartiles_cell(each.difference),
               each.judged == 0 ? Html("–"_html) : text(fmt::format("{} of {}", each.better, each.judged)),
               any ? text(fmt::format("{:.0f}", each.evaluations.median)) : Html("–"_html),
               any ? text(fmt::format("{:.0f}", each.matches.median)) : Html("–"_html),
               whole_number(each.runs.size())});
  }
  Html out = note_paragraph(fmt::format("Difference of {} from the base team.", objective_text(objective)));
  out << table.html() << figure(page.figures, "algorithms");
  if (view.record.runs.empty()) return section("algorithms", "Algorithms"_html, out);
  HtmlTable runs({{"Algorithm"_html, Column::words},
                  {"Run"_html},
                  {"Evaluations"_html},
                  {"Matches"_html},
                  {"In its search"_html},
                  {"Judged, less the base team's"_html},
                  {"Ended"_html, Column::words},
                  {"Values"_html, Column::words}});
  for (const study::ComparedRun& each : view.record.runs) {
    runs.row({code(name(each.algorithm)), whole_number(each.repeat + 1), whole_number(each.evaluations),
              whole_number(each.matches),
              each.seen ? text(rounded(of_objective(objective, *each.seen), 0.0)) : Html("–"_html),
              text(signed_with_interval(of_objective(objective, each.judged))), text(each.ended),
              text(values_text(view.plan.tuning, each.values))});
  }
  out << "<details><summary>All runs</summary>\n<div class=\"values\">"_html << runs.html()
      << "</div>\n</details>\n<p class=\"note\">"_html << table_link("runs.csv", search_comparison_csv(view))
      << "</p>\n"_html;
  return section("algorithms", "Algorithms"_html, out);
}

}  // namespace

std::string search_comparison_page(const SearchComparisonPage& page) {
  const SearchComparisonView& view = page.view;
  const study::TuningPlan& plan = view.plan.tuning;
  const study::MatchTally& tally = view.record.tally;
  const ComparisonVerdict verdict = comparison_verdict(view);
  const std::string title = comparison_title(view);
  Html out = page_begin(title);
  out << doubts_note(tally.remarks) << verdict_header(title, verdict.headline, unfinished_sentence(view), plan.question)
      << tiles(view) << section("findings", "What was found"_html, sentence_list(verdict.beside))
      << algorithms_section(page) << setup_section(plan, setup_sentences(view))
      << unplayed_section(tally.unplayed_pairs, tally.remarks) << failures_section(plan, tally.forfeits)
      << reproduction_section(plan, page.played) << remarks_note(tally.remarks) << page_end();
  return out.str();
}

}  // namespace regista::report
