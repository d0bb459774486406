// SPDX-License-Identifier: MIT
#include "report/tournament_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/number.hpp"
#include "report/page_sections.hpp"
#include "report/page_style.hpp"
#include "report/standing.hpp"
#include "report/verdict_interval.hpp"
#include "report/verdict_sentence.hpp"

namespace regista::report {
namespace {

// What a file begins with that may be replaced by one of ours.
constexpr Markup ours = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="generator" content="Regista tournament page">
)"_html;

constexpr Markup head = R"(<meta name="viewport" content="width=device-width">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; img-src data:">
)"_html;

void tile(Html& out, const Html& number, const Html& what) {
  out << "<div class=\"tile\"><b>"_html << number << "</b><span>"_html << what << "</span></div>\n"_html;
}

Html elo_text(const statistics::Estimate& elo, IntervalUse use) {
  if (!std::isfinite(elo.value)) return text(elo.value > 0.0 ? "above all scales" : "below all scales");
  return text(use == IntervalUse::told ? fmt::format("{} ± {:.0f}", with_sign(elo.value, 0), elo.margin())
                                       : with_sign(elo.value, 0));
}

const char* elo_caption(IntervalUse use) {
  switch (use) {
    case IntervalUse::told:
      return "Elo, with the margin that holds with 95 %";
    case IntervalUse::too_few_pairs:
      return "Elo; too few pairs for an interval";
    case IntervalUse::not_at_its_end:
      return "Elo so far";
    case IntervalUse::biased:
      return "Elo, biased towards the verdict";
    case IntervalUse::contradicted:
    case IntervalUse::unbounded:
      break;
  }
  return "Elo";
}

Html tiles(const PageSource& source) {
  const TournamentView& view = source.view;
  const study::Meeting& meeting = view.course.meetings().front();
  Html out = "<div class=\"tiles\">\n"_html;
  const std::optional<Strength> known = strength(meeting);
  if (view.plan.teams.size() == 2 && known) {
    const auto& [losses, draws, wins] = meeting.games.seen;
    const double share = points(meeting.games) / static_cast<double>(meeting.matches());
    const IntervalUse use = interval_use(view, 0);
    tile(out, elo_text(known->elo, use), text(elo_caption(use)));
    tile(out, text(fmt::format("{:.1f} %", 100.0 * share)),
         text(fmt::format("of the points, {:.1f} of {}", points(meeting.games), meeting.matches())));
    tile(out, text(fmt::format("{} – {} – {}", wins, draws, losses)), text("won – drawn – lost"));
    tile(out, text(fmt::format("{} : {}", meeting.goals[0], meeting.goals[1])), text("goals"));
    if (use == IntervalUse::told) {
      Html better = "probability that "_html;
      tile(out, text(fmt::format("{:.1f} %", 100.0 * known->superiority)),
           better << team_name(source, 0) << " is the stronger one (LOS)"_html);
    }
  } else {
    tile(out, text(fmt::format("{}", view.plan.teams.size())), text("teams"));
    tile(out, text(fmt::format("{}", view.course.calendar().pairings().size())), text("pairings"));
  }
  tile(out, text(fmt::format("{}", view.course.matches())),
       text(fmt::format("matches of {} planned", view.course.calendar().matches())));
  return out << "</div>\n"_html;
}

// The page is read by those who do not know which team is the first.
Html point_of_view(const PageSource& source) {
  if (source.view.plan.teams.size() != 2) return {};
  Html out = "<p class=\"note\">All numbers are from the point of view of "_html;
  return out << team_name(source, 0) << ", against "_html << team_name(source, 1) << ".</p>\n"_html;
}

}  // namespace

Html team_name(const PageSource& source, std::size_t team) { return name(source.view.plan.teams[team].label); }

Html section(std::string_view id, Markup title, const Html& content) {
  if (content.empty()) return {};
  Html out = "<section id=\""_html;
  return out << text(id) << "\">\n<h2>"_html << title << "</h2>\n"_html << content << "</section>\n"_html;
}

Html table_link(std::string_view file_name, std::string_view csv) {
  Html out = "<a class=\"take\" download=\""_html;
  return out << text(file_name) << "\" href=\""_html << data_address("text/csv", csv) << "\">data as CSV</a>"_html;
}

Html figure(const PageSource& source, std::string_view figure_name) {
  const auto found = std::ranges::find(source.figures, figure_name,
                                       [](const PageFigure& each) { return std::string_view(each.figure.name); });
  if (found == source.figures.end()) return {};
  const Figure& figure = found->figure;
  Html out = "<figure>\n"_html;
  if (found->svg.empty()) {
    out << "<p class=\"missing\">Here a figure is missing: "_html << text(found->why_not)
        << ". Its data are there.</p>\n"_html;
  } else {
    out << Html::made_by_us(found->svg);  // svg.cpp has let through what it knows, and nothing else
  }
  return out << "<figcaption><b>"_html << text(figure.title) << ".</b> "_html << text(figure.description) << " "_html
             << table_link(figure.name + ".csv", figure.csv) << "</figcaption>\n</figure>\n"_html;
}

std::string tournament_page(const PageSource& source) {
  const VerdictSentence verdict = verdict_sentence(source.view);
  Html page = ours;
  page << head << "<title>"_html << text(title(source.view)) << "</title>\n<style>"_html << page_style
       << "</style>\n</head>\n<body>\n<main>\n<header>\n<p class=\"kicker\">Tournament: "_html
       << text(title(source.view)) << "</p>\n<h1 id=\"verdict\">"_html << verdict.sentence << "</h1>\n"_html
       << "<p class=\"beside\">"_html;
  for (const Html& each : verdict.beside) page << each << " "_html;
  page << "</p>\n</header>\n"_html << tiles(source) << point_of_view(source);
  for (const auto part :
       {standing_section, curves_section, goals_section, roles_section, packets_section, variance_section,
        failures_section, recordings_section, configuration_section, reproduction_section}) {
    page << part(source);
  }
  page << "<footer>Written by <code>regista report</code> from the stored results alone.</footer>\n"_html
       << "</main>\n</body>\n</html>\n"_html;
  return page.str();
}

bool is_our_page(std::string_view beginning) { return beginning.starts_with(ours.view()); }

}  // namespace regista::report
