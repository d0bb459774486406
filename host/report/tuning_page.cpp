// SPDX-License-Identifier: MIT
#include "report/tuning_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/estimate_text.hpp"
#include "report/experiment.hpp"
#include "report/html_table.hpp"
#include "report/match_remarks.hpp"
#include "report/number.hpp"
#include "report/tuning_page_parts.hpp"
#include "report/tuning_sentences.hpp"

namespace regista::report {
namespace {

constexpr std::size_t most_rows = 500;  // of the trace that are shown; all of it can be taken away

Html tiles(const TuningView& view) {
  const study::TuningPlan& plan = view.plan;
  const MatchesByStage matches = matches_by_stage(view);
  Html out = "<div class=\"tiles\">\n"_html;
  for (const CandidateVerdict& each : candidate_verdicts(view)) {
    if (each.finalist != view.record.tuned() || each.pairs == 0) continue;
    out << tile(text(signed_with_interval(each.difference)),
                text(fmt::format("{} of the tuned team less the base team's", in_words(plan.objective))));
    if (each.seen && each.value) {
      out << tile(text(rounded(each.value->mean, 0.0)),
                  text(fmt::format("on the verification; the search had {}", rounded(each.seen->mean, 0.0))));
    }
  }
  out << tile(whole_number(plan.free_parameters()), text(plan.free_parameters() == 1 ? "parameter" : "parameters"));
  out << tile(whole_number(view.record.trace.size()), text("evaluations of the search"));
  out << tile(whole_number(matches.search + matches.selection + matches.verification + matches.slices),
              text(fmt::format("matches, of at most {}", most_matches(plan))));
  return out << "</div>\n"_html;
}

Html findings_section(const TuningView& view, const TuningVerdict& verdict) {
  Html out = sentence_list(verdict.beside);
  if (!view.tuned_file.empty()) {
    out << "<p>The tuned team is in "_html << code(view.tuned_file)
        << (view.record.verified() ? ".</p>\n"_html : ", although it was not found better.</p>\n"_html);
  }
  return section("findings", "What was found"_html, out);
}

Html convergence_section(const TuningPage& page) {
  Html out = sentence_list(search_sentences(page.view));
  return section("convergence", "The search"_html, out << figure(page.figures, "convergence"));
}

Html values_section(const TuningPage& page) {
  const TuningView& view = page.view;
  const std::vector<TunedValue> values = tuned_values(view);
  Html out;
  if (!values.empty()) {
    HtmlTable table({{"Parameter"_html, Column::words},
                     {"Base"_html},
                     {"Tuned"_html},
                     {"Range"_html, Column::words},
                     {""_html, Column::words},
                     {"Importance"_html},
                     {"p"_html, Column::words}});
    for (const TunedValue& each : values) {
      const study::Parameter& parameter = view.plan.parameters[each.parameter];
      const auto slice = std::ranges::find(view.record.slices, each.parameter, &study::Slice::parameter);
      const bool known = slice != view.record.slices.end();
      Html tuned = text(text_of(parameter, each.tuned));
      if (each.tuned != each.base) {
        Html differs = "<span class=\"differs\">"_html;
        tuned = differs << tuned << "</span>"_html;
      }
      table.row({path_code(parameter.path), text(text_of(parameter, each.base)), tuned, text(range_text(parameter)),
                 text(end_text(each.at)), known ? text(importance_value(*slice)) : Html("–"_html),
                 known ? text(importance_text(*slice)) : Html("–"_html)});
    }
    out << note_paragraph(
               fmt::format("Of finalist {}{}", *view.record.tuned() + 1,
                           view.record.verified() ? "." : ", which was not found better than the base team."))
        << "<div class=\"values\">"_html << table.html() << "</div>\n"_html;
  }
  out << note_paragraph(slices_note(view)) << figure(page.figures, "importance");
  return section("values", "Tuned values and importance"_html, out);
}

Html slices_section(const TuningPage& page) {
  Html out;
  for (const Figure& each : page.figures) {
    if (each.name.starts_with("slice_")) out << figure(page.figures, each.name);
  }
  if (out.empty()) return {};
  Html two = "<div class=\"two\">\n"_html;
  return section("slices", "Each parameter by itself"_html, two << out << "</div>\n"_html);
}

Html finalists_section(const TuningView& view) {
  if (view.record.finalists.empty()) return {};
  const study::ParameterValues base = start_values(view.plan);
  std::vector<Heading> headings{{"Finalist"_html}, {"In the search (optimistic)"_html}, {"On the selection"_html}};
  for (const study::Parameter& each : view.plan.parameters) {
    if (!each.fixed()) headings.push_back({code(each.path), Column::number});
  }
  headings.push_back({""_html, Column::words});
  HtmlTable table(headings);
  for (std::size_t i = 0; i < view.record.finalists.size(); ++i) {
    const study::Finalist& each = view.record.finalists[i];
    std::vector<Html> cells{whole_number(i + 1), text(seen_text(view.plan, each)),
                            each.selected.failed
                                ? Html("forfeited"_html)
                                : text(with_interval(of_objective(view.plan.objective, each.selected.score)))};
    for (std::size_t j = 0; j < view.plan.parameters.size(); ++j) {
      if (!view.plan.parameters[j].fixed()) cells.push_back(text(text_of(view.plan.parameters[j], each.values[j])));
    }
    const bool verified = std::ranges::find(view.record.candidates, i) != view.record.candidates.end();
    cells.push_back(each.values == base ? Html("the base team"_html) : verified ? Html("candidate"_html) : Html());
    table.row(cells);
  }
  Html out =
      note_paragraph(fmt::format("In the order of the selection, whose pairs the search did not play. In brackets: "
                                 "{:.4g} % intervals of Student's t.",
                                 100.0 * view.plan.confidence()));
  return section("finalists", "Finalists"_html,
                 out << "<div class=\"values\">"_html << table.html() << "</div>\n"_html);
}

Html trace_section(const TuningView& view) {
  const std::vector<study::SearchStep>& trace = view.record.trace;
  if (trace.empty()) return {};
  HtmlTable table({{"Evaluation"_html},
                   {"Value"_html},
                   {"Best"_html},
                   {"Matches"_html},
                   {""_html, Column::words},
                   {"Values"_html, Column::words}});
  for (std::size_t i = 0; i < std::min(trace.size(), most_rows); ++i) {
    const study::SearchStep& each = trace[i];
    table.row({whole_number(each.evaluation),
               each.played.failed ? Html("–"_html)
                                  : text(with_interval(of_objective(view.plan.objective, each.played.score))),
               text(rounded(of_objective(view.plan.objective, each.best), 0.0)), whole_number(each.matches),
               each.played.failed ? Html("forfeited"_html)
               : each.repeated    ? Html("played before"_html)
                                  : Html(),
               text(values_text(view.plan, each.values))});
  }
  Html out = "<p class=\"note\">All of it: "_html;
  out << table_link("trace.csv", tuning_csv(view)) << "</p>\n<details><summary>"_html
      << text(trace.size() <= most_rows ? fmt::format("All {} evaluations", trace.size())
                                        : fmt::format("The first {} of {} evaluations", most_rows, trace.size()))
      << "</summary>\n<div class=\"values tight\">"_html << table.html() << "</div>\n</details>\n"_html;
  return section("trace", "Trace of the search"_html, out);
}

Html team_section(const study::TuningPlan& plan) {
  Html out = "<details><summary>In full</summary>\n"_html;
  return section("base", "The base team"_html, out << block(plan.document) << "</details>\n"_html);
}

}  // namespace

std::string tuning_page(const TuningPage& page) {
  const TuningView& view = page.view;
  const study::MatchTally& tally = view.record.tally;
  const TuningVerdict verdict = tuning_verdict(view);
  const std::string title = problem_title(view.plan);
  const WhatWasPlayed played = what_was_played(view.plan);
  Html out = page_begin(title);
  out << doubts_note(tally.remarks)
      << verdict_header(title, verdict.headline, unfinished_sentence(view), view.plan.asked.question) << tiles(view)
      << played_section(played) << findings_section(view, verdict) << setup_section(view.plan, setup_sentences(view))
      << convergence_section(page) << values_section(page) << slices_section(page) << finalists_section(view)
      << trace_section(view) << unplayed_section(tally.unplayed_pairs, tally.remarks)
      << failures_section(view.plan, tally.forfeits) << team_section(view.plan) << again_section(played, page.results)
      << remarks_note(tally.remarks) << page_end();
  return out.str();
}

}  // namespace regista::report
