// SPDX-License-Identifier: MIT
#include "report/tuning_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "report/experiment.hpp"
#include "report/html_table.hpp"
#include "report/match_remarks.hpp"
#include "report/number.hpp"
#include "report/tuning_sentences.hpp"

namespace regista::report {
namespace {

constexpr std::size_t most_rows = 500;  // of the trace that are shown; all of it can be taken away

Html list(const std::vector<std::string>& sentences) {
  if (sentences.empty()) return {};
  Html out = "<ul>\n"_html;
  for (const std::string& each : sentences) out << "<li>"_html << text(each) << "</li>\n"_html;
  return out << "</ul>\n"_html;
}

Html note(const std::string& sentence) {
  if (sentence.empty()) return {};
  Html out = "<p class=\"note\">"_html;
  return out << text(sentence) << "</p>\n"_html;
}

Html number(std::uint64_t value) { return text(fmt::format("{}", value)); }

Html head(const TuningView& view, const TuningVerdict& verdict) {
  Html out = "<header>\n<p class=\"kicker\">Tuning: "_html;
  out << text(tuning_title(view)) << "</p>\n<h1 id=\"verdict\">"_html << text(verdict.headline)
      << "</h1>\n<p class=\"beside\">"_html;
  if (const std::string unfinished = unfinished_sentence(view); !unfinished.empty())
    out << text(unfinished) << " "_html;
  return out << text(view.plan.question) << "</p>\n</header>\n"_html;
}

Html tiles(const TuningView& view) {
  const study::TuningPlan& plan = view.plan;
  const MatchesByStage matches = matches_by_stage(view);
  Html out = "<div class=\"tiles\">\n"_html;
  for (const CandidateVerdict& each : candidate_verdicts(view)) {
    if (each.finalist != view.record.tuned() || each.pairs == 0) continue;
    out << tile(text(told_text(each.difference)),
                text(fmt::format("{} of the tuned team less the base team's", in_words(plan.objective))));
    if (each.seen && each.value) {
      out << tile(text(rounded(each.value->mean, 0.0)),
                  text(fmt::format("verified, where the search had promised {}", rounded(each.seen->mean, 0.0))));
    }
  }
  out << tile(number(plan.free_parameters()), text(plan.free_parameters() == 1 ? "parameter" : "parameters"));
  if (plan.compares()) {
    out << tile(number(plan.compared.size()), text(plan.compared.size() == 1 ? "algorithm" : "algorithms"));
    out << tile(number(view.record.compared.size()),
                text(fmt::format("runs of {}", plan.compared.size() * plan.repeats)));
  } else {
    out << tile(number(view.record.trace.size()), text("evaluations of the search"));
  }
  out << tile(number(matches.search + matches.selection + matches.verification + matches.slices),
              text(fmt::format("matches, of at most {}", most_matches(plan))));
  return out << "</div>\n"_html;
}

Html findings_section(const TuningView& view, const TuningVerdict& verdict) {
  Html out = list(verdict.beside);
  if (!view.tuned_file.empty() && !view.plan.compares()) {
    out << "<p>The tuned team is in "_html << code(view.tuned_file)
        << (view.record.verified() ? ".</p>\n"_html : ", although it was not found better.</p>\n"_html);
  }
  return section("findings", "What was found"_html, out);
}

Html setup_section(const TuningView& view) {
  HtmlTable table({{"Parameter"_html, Column::words},
                   {"Start"_html},
                   {"Range"_html, Column::words},
                   {"Scale"_html, Column::words},
                   {"What it is"_html, Column::words}});
  for (const study::Parameter& each : view.plan.parameters) {
    table.row({code(each.path), text(text_of(each, each.start)), text(range_text(each)), text(scale_text(each)),
               text(each.doc)});
  }
  Html out = list(setup_sentences(view));
  return section("setup", "How it was tuned"_html,
                 out << "<div class=\"values\">"_html << table.html() << "</div>\n"_html);
}

Html convergence_section(const TuningPage& page) {
  Html out = list(search_sentences(page.view));
  return section("convergence", "The search"_html, out << figure(page.figures, "convergence"));
}

Html quartiles_cell(const std::optional<statistics::Quartiles>& of) {
  if (!of) return "–"_html;
  const double margin = (of->upper - of->lower) / 2.0;
  return text(fmt::format("{} [{}, {}]", signed_text(of->median, margin), signed_text(of->lower, margin),
                          signed_text(of->upper, margin)));
}

Html algorithms_section(const TuningPage& page) {
  const TuningView& view = page.view;
  if (!view.plan.compares()) return {};
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
               any ? text(fmt::format("{:.0f}", each.matches.median)) : Html("–"_html), number(each.runs.size())});
  }
  Html out = note(fmt::format("Difference of {} from the base team.", objective_text(view.plan.objective)));
  out << table.html() << figure(page.figures, "algorithms");
  if (view.record.compared.empty()) return section("algorithms", "Algorithms"_html, out);
  HtmlTable runs({{"Algorithm"_html, Column::words},
                  {"Run"_html},
                  {"Evaluations"_html},
                  {"Matches"_html},
                  {"In its search"_html},
                  {"Judged, less the base team's"_html},
                  {"Ended"_html, Column::words},
                  {"Values"_html, Column::words}});
  for (const study::ComparedRun& each : view.record.compared) {
    runs.row({code(name(each.algorithm)), number(each.repeat + 1), number(each.evaluations), number(each.matches),
              each.seen ? text(rounded(told(view.plan.objective, *each.seen), 0.0)) : Html("–"_html),
              text(difference_text(told(view.plan.objective, each.judged))), text(each.ended),
              text(values_text(view.plan, each.values))});
  }
  out << "<details><summary>All runs</summary>\n<div class=\"values\">"_html << runs.html()
      << "</div>\n</details>\n<p class=\"note\">"_html << table_link("runs.csv", tuning_csv(view)) << "</p>\n"_html;
  return section("algorithms", "Algorithms"_html, out);
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
      table.row({code(parameter.path), text(text_of(parameter, each.base)), tuned, text(range_text(parameter)),
                 text(end_text(each.at)), known ? text(importance_value(*slice)) : Html("–"_html),
                 known ? text(importance_text(*slice)) : Html("–"_html)});
    }
    out << note(fmt::format("Of finalist {}{}", *view.record.tuned() + 1,
                            view.record.verified() ? "." : ", which was not found better than the base team."))
        << "<div class=\"values\">"_html << table.html() << "</div>\n"_html;
  }
  out << note(slices_note(view)) << figure(page.figures, "importance");
  return section("values", "Tuned values and importance"_html, out);
}

Html slices_section(const TuningPage& page) {
  Html out;
  for (const PageFigure& each : page.figures) {
    if (each.figure.name.starts_with("slice_")) out << figure(page.figures, each.figure.name);
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
    std::vector<Html> cells{number(i + 1), text(seen_text(view.plan, each)),
                            each.selected.failed ? Html("forfeited"_html)
                                                 : text(told_text(told(view.plan.objective, each.selected.score)))};
    for (std::size_t j = 0; j < view.plan.parameters.size(); ++j) {
      if (!view.plan.parameters[j].fixed()) cells.push_back(text(text_of(view.plan.parameters[j], each.values[j])));
    }
    const bool verified = std::ranges::find(view.record.candidates, i) != view.record.candidates.end();
    cells.push_back(each.values == base ? Html("the base team"_html) : verified ? Html("candidate"_html) : Html());
    table.row(cells);
  }
  Html out = note(fmt::format(
      "The best on the selection first, whose pairs the search did not play; in brackets what holds with {:.4g} % by "
      "Student's t for one look.",
      100.0 * view.plan.confidence));
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
    table.row({number(each.evaluation),
               each.played.failed ? Html("–"_html) : text(told_text(told(view.plan.objective, each.played.score))),
               text(rounded(told(view.plan.objective, each.best), 0.0)), number(each.matches),
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

Html failures_section(const TuningView& view) {
  const study::ForfeitList& forfeits = view.record.forfeits;
  if (forfeits.listed().empty()) return {};
  HtmlTable table({{"By"_html, Column::words},
                   {"Matches"_html},
                   {"Plugin"_html, Column::words},
                   {"Call"_html, Column::words},
                   {"Reason"_html, Column::words},
                   {"First in match"_html}});
  for (const study::Forfeits& each : forfeits.listed()) {
    table.row(
        {name(forfeiter(view.plan, each.team)), number(each.count),
         each.failure.plugin.empty() ? plugin_cell(name(forfeiter(view.plan, each.team))) : text(each.failure.plugin),
         text(each.failure.call), text(each.failure.what), number(each.first_match + 1)});
  }
  Html out =
      "<p>Those of the team that is tuned count against it, in the search as the worst value there is; pairs in which "
      "others forfeited are left out.</p>\n"
      "<div class=\"values\">"_html;
  out << table.html() << "</div>\n"_html;
  if (forfeits.unlisted() > 0) out << note(fmt::format("{} more for other reasons.", forfeits.unlisted()));
  return section("failures", "Forfeits"_html, out);
}

std::vector<campaign::Input> all_inputs(const study::TuningPlan& plan) {
  std::vector<campaign::Input> out;
  const auto add = [&out](const campaign::Job& job) {
    for (const auto* inputs : {&job.common_inputs, &job.home_inputs, &job.away_inputs}) {
      out.insert(out.end(), inputs->begin(), inputs->end());
    }
  };
  for (const study::TuningOpponent& each : plan.opponents) add(each.jobs[0]);
  if (plan.head_to_head) add(plan.base.jobs[0]);
  for (const study::Opening& opening : plan.openings) out.push_back(opening.input);
  return out;
}

Html reproduction_section(const TuningPage& page) {
  const study::TuningPlan& plan = page.view.plan;
  Html out = "<p>In the folder "_html;
  out << code(plan.folder) << ", with the program and the files that have these hashes:</p>\n"_html
      << block(page.command) << "<p class=\"note\">Regista "_html << text(page.program)
      << " began these results; parameters, ranges, budgets, seeds, test and hashes were fixed and stored before the "
         "first match. Fingerprint of all matches, equal where the same were played with the same course: "_html
      << code(page.fingerprint.empty() ? "–" : page.fingerprint) << "</p>\n"_html;
  if (plan.minutes) {
    out << note(
        "The search had a limit of wall time: where that ended it, the same command on another machine may end "
        "it elsewhere.");
  }
  out << "<details><summary>The base team in full</summary>\n"_html << block(plan.document)
      << "</details>\n<details><summary>Hashes of everything the matches are a function of</summary>\n"_html
      << hashes_table(all_inputs(plan)) << "</details>\n"_html;
  return section("reproduction", "Playing it again"_html, out);
}

}  // namespace

std::vector<std::string> tuning_arguments(const study::TuningPlan& plan) {
  std::vector<std::string> words{"tune", plan.file};
  for (const std::string& each : plan.overrides) words.insert(words.end(), {"--set", each});
  if (plan.compares()) {
    std::vector<std::string> names;
    for (const study::Algorithm each : plan.compared) names.emplace_back(name(each));
    words.insert(words.end(),
                 {"--compare", fmt::format("{}", fmt::join(names, ",")), "--repeats", std::to_string(plan.repeats)});
  }
  for (const std::string& each : plan.base.jobs[0].plugins) words.insert(words.end(), {"--plugins", each});
  words.insert(words.end(), {"--processor-seconds", std::to_string(plan.limits.processor_seconds), "--memory",
                             std::to_string(plan.limits.memory >> 20)});
  return words;
}

std::string tuning_page(const TuningPage& page) {
  const TuningView& view = page.view;
  const TuningVerdict verdict = tuning_verdict(view);
  Html out = page_begin(tuning_title(view));
  out << irreproducible_note(view.record.remarks) << head(view, verdict) << tiles(view)
      << findings_section(view, verdict) << algorithms_section(page) << setup_section(view) << convergence_section(page)
      << values_section(page) << slices_section(page) << finalists_section(view) << trace_section(view)
      << unplayed_section(view.record.unplayed_pairs, view.record.remarks) << failures_section(view)
      << reproduction_section(page) << written_note(view.record.remarks) << page_end();
  return out.str();
}

}  // namespace regista::report
