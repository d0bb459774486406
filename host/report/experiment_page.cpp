// SPDX-License-Identifier: MIT
#include "report/experiment_page.hpp"
#include "report/estimate_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/html_table.hpp"
#include "report/match_remarks.hpp"
#include "report/number.hpp"

namespace regista::report {
namespace {

Html head(const ExperimentView& view) {
  Html out = "<header>\n<p class=\"kicker\">Experiment: "_html;
  return out << text(experiment_title(view)) << "</p>\n<h1 id=\"verdict\">"_html << text(experiment_headline(view))
             << "</h1>\n<p class=\"beside\">"_html << text(view.plan.asked.question) << "</p>\n</header>\n"_html;
}

std::string minutes_text(double least, double most) {
  const std::string from = fmt::format("{:.0f}", least), to = fmt::format("{:.0f}", most);
  return from == to ? from : fmt::format("{} – {}", from, to);
}

Html tiles(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  const auto [least, most] = [&] {
    double low = view.course.playing_seconds(0), high = low;
    for (std::size_t i = 1; i < plan.conditions.size(); ++i) {
      low = std::min(low, view.course.playing_seconds(i));
      high = std::max(high, view.course.playing_seconds(i));
    }
    return std::pair(low / 60.0, high / 60.0);
  }();
  Html out = "<div class=\"tiles\">\n"_html;
  out << tile(text(fmt::format("{}", plan.asked.arms.size())), text(plan.asked.arms.size() == 1 ? "arm" : "arms"));
  if (plan.swept()) out << tile(text(fmt::format("{}", plan.values())), text("values of the sweep"));
  out << tile(text(fmt::format("{}", plan.pairs)), text("pairs of matches each: same seed, both sides"));
  out << tile(text(minutes_text(least, most)), text("minutes of play each"));
  out << tile(text(fmt::format("{}", view.course.taken())), text(fmt::format("matches of {} planned", plan.matches())));
  return out << "</div>\n"_html;
}

Html findings_section(const std::vector<std::string>& sentences) {
  if (sentences.empty()) return {};
  Html out = "<ul>\n"_html;
  for (const std::string& each : sentences) out << "<li>"_html << text(each) << "</li>\n"_html;
  return section("findings", "What was found"_html, out << "</ul>\n"_html);
}

Html figures_section(const ExperimentPageSource& source) {
  Html out;
  for (const Figure& each : source.figures) out << figure(source.figures, each.name);
  if (out.empty()) return {};
  Html full = "<div class=\"full\">\n"_html;
  return section("figures", "Figures"_html, full << out << "</div>\n"_html);
}

Html measure_cell(const std::string& measure) {
  Html out = path_code(measure);
  if (study::is_time(measure)) out << ", "_html << text(study::unit_of(measure));
  return out;
}

Html means_section(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  std::vector<Heading> headings{{"Measure"_html, Column::words}};
  if (plan.swept()) headings.push_back({code(plan.sweep()), Column::number});
  for (const config::Experiment::Arm& arm : plan.asked.arms) headings.push_back({name(arm.name), Column::number});
  HtmlTable table(headings);
  for (std::size_t measure = 0; measure < plan.measures.size(); ++measure) {
    for (std::size_t value = 0; value < plan.values(); ++value) {
      std::vector<Html> cells{measure_cell(plan.measures[measure])};
      if (plan.swept()) cells.push_back(text(plan.value(value)));
      for (std::size_t arm = 0; arm < plan.asked.arms.size(); ++arm) {
        cells.push_back(text(estimate_text(view.course.mean(plan.condition(arm, value), measure), "±")));
      }
      table.row(cells);
    }
  }
  Html out;
  for (const std::string& each : experiment_notes(view)) {
    out << "<p class=\"note\">"_html << text(each) << "</p>\n"_html;
  }
  out << "<p class=\"note\">"_html;
  out << text(fmt::format("Times are minutes in 60 minutes of play, all other numbers are means of a match. ± is half "
                          "of the {:.4g} % interval: Student's t over pairs of matches.",
                          100.0 * plan.asked.confidence))
      << " "_html << table_link("means.csv", experiment_summary_csv(view)) << "</p>\n<div class=\"values\">"_html
      << table.html() << "</div>\n"_html;
  return section("means", "Means"_html, out);
}

std::string difference_text(const study::MeanEstimate& difference) {
  if (difference.pairs == 0) return "–";
  if (!difference.interval) return rounded(difference.mean, 0.0);
  return rounded(difference.mean, half_width(difference.interval)) + ' ' + interval_text(difference);
}

Html differences_section(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  if (plan.comparisons().empty()) return {};
  HtmlTable table({{"Measure"_html, Column::words},
                   {"First"_html, Column::words},
                   {"Less second"_html, Column::words},
                   {"Pairs"_html},
                   {"Difference"_html}});
  for (std::size_t measure = 0; measure < plan.measures.size(); ++measure) {
    for (const study::Comparison& each : plan.comparisons()) {
      const study::MeanEstimate difference = view.course.difference(each, measure);
      table.row({measure_cell(plan.measures[measure]), name(label(plan, each.first)), name(label(plan, each.second)),
                 text(fmt::format("{}", difference.pairs)), text(difference_text(difference))});
    }
  }
  Html out =
      "<p class=\"note\">Differences pair by pair. Each interval holds for its own comparison. Only the primary "
      "measure was tested, with a correction for the number of comparisons.</p>\n<details><summary>All "
      "differences</summary>\n"
      "<div class=\"values\">"_html;
  out << table.html() << "</div>\n</details>\n"_html;
  return section("differences", "Differences"_html, out);
}

Html failures_section(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  if (view.course.forfeits().listed().empty()) return {};
  HtmlTable table({{"By"_html, Column::words},
                   {"Matches"_html},
                   {"Plugin"_html, Column::words},
                   {"Call"_html, Column::words},
                   {"Reason"_html, Column::words},
                   {"Command that plays the first again"_html, Column::words}});
  for (const study::Forfeits& each : view.course.forfeits().listed()) {
    const bool opponent = each.team == plan.conditions.size();
    table.row({opponent ? text("the opponent") : name(label(plan, each.team)), text(fmt::format("{}", each.count)),
               each.failure.plugin.empty() ? plugin_cell(opponent ? text("the opponent") : name(label(plan, each.team)))
                                           : text(each.failure.plugin),
               text(each.failure.call), text(each.failure.what), code(view.again(each.first_match))});
  }
  Html out = "<p>Their pairs are left out of every number.</p>\n<div class=\"values\">"_html;
  return section("failures", "Forfeits"_html, out << table.html() << "</div>\n"_html);
}

Html configuration_section(const study::ExperimentPlan& plan) {
  std::vector<std::string> names;
  for (const config::Experiment::Arm& arm : plan.asked.arms) names.push_back(arm.name);
  names.emplace_back("opponent");
  return section("configuration", "Where the teams differ"_html,
                 differing_documents(names, plan.documents, what_was_played(plan).teams));
}

}  // namespace

std::string experiment_page(const ExperimentPageSource& source) {
  const ExperimentView& view = source.view;
  const std::vector<std::string> sentences = finding_sentences(view);
  Html page = page_begin(experiment_title(view));
  const WhatWasPlayed played = what_was_played(view.plan);
  page << doubts_note(view.course.remarks()) << head(view) << tiles(view) << played_section(played)
       << findings_section(sentences) << figures_section(source) << means_section(view) << differences_section(view)
       << unplayed_section(view.course.unplayed_pairs(), view.course.remarks()) << failures_section(view)
       << configuration_section(view.plan) << again_section(played, source.results)
       << remarks_note(view.course.remarks()) << page_end();
  return page.str();
}

}  // namespace regista::report
