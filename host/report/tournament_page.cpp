// SPDX-License-Identifier: MIT
#include "report/tournament_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/elo_interval.hpp"
#include "report/match_remarks.hpp"
#include "report/number.hpp"
#include "report/page_sections.hpp"
#include "report/standing.hpp"
#include "report/verdict_sentence.hpp"

namespace regista::report {
namespace {

Html elo_text(const statistics::Estimate& elo, IntervalUse use) {
  if (!std::isfinite(elo.value)) return text(elo.value > 0.0 ? "above all scales" : "below all scales");
  return text(use == IntervalUse::shown ? fmt::format("{} ± {:.0f}", with_sign(elo.value, 0), elo.margin())
                                        : with_sign(elo.value, 0));
}

const char* elo_caption(IntervalUse use) {
  switch (use) {
    case IntervalUse::shown:
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
  const std::optional<Strength> known = strength(view.course, meeting);
  if (view.plan.teams.size() == 2 && known) {
    const auto& [losses, draws, wins] = meeting.games.seen;
    const double share = points(meeting.games) / static_cast<double>(meeting.matches());
    const IntervalUse use = interval_use(view, 0);
    out << tile(elo_text(known->elo, use), text(elo_caption(use)));
    out << tile(text(fmt::format("{:.1f} %", 100.0 * share)),
                text(fmt::format("of the points, {:.1f} of {}", points(meeting.games), meeting.matches())));
    out << tile(text(fmt::format("{} – {} – {}", wins, draws, losses)), text("won – drawn – lost"));
    out << tile(text(fmt::format("{} : {}", meeting.goals[0], meeting.goals[1])), text("goals"));
    if (use == IntervalUse::shown) {
      Html better = "probability that "_html;
      out << tile(text(fmt::format("{:.1f} %", 100.0 * known->superiority)),
                  better << team_name(source, 0) << " is the stronger one (LOS)"_html);
    }
  } else {
    out << tile(text(fmt::format("{}", view.plan.teams.size())), text("teams"));
    out << tile(text(fmt::format("{}", view.course.calendar().pairings().size())), text("pairings"));
  }
  out << tile(text(fmt::format("{}", view.course.matches())),
              text(fmt::format("matches of {} planned", view.course.calendar().matches())));
  return out << "</div>\n"_html;
}

// The page is read by those who do not know which team is the first.
Html point_of_view(const PageSource& source) {
  if (source.view.plan.teams.size() != 2) return {};
  Html out = "<p class=\"note\">All numbers are from the point of view of "_html;
  return out << team_name(source, 0) << ", against "_html << team_name(source, 1) << ".</p>\n"_html;
}

Html unplayed_section_of(const PageSource& source) {
  return unplayed_section(source.view.course.unplayed_pairs(), source.view.course.remarks());
}

}  // namespace

Html team_name(const PageSource& source, std::size_t team) { return name(source.view.plan.teams[team].label); }

std::string tournament_page(const PageSource& source) {
  const VerdictSentence verdict = verdict_sentence(source.view);
  Html page = page_begin(title(source.view));
  page << doubts_note(source.view.course.remarks()) << "<header>\n<p class=\"kicker\">Tournament: "_html
       << text(title(source.view)) << "</p>\n<h1 id=\"verdict\">"_html << verdict.sentence << "</h1>\n"_html
       << "<p class=\"beside\">"_html;
  for (const Html& each : verdict.beside) page << each << " "_html;
  if (!source.view.plan.asked.question.empty())
    page << "</p>\n<p class=\"beside\">"_html << text(source.view.plan.asked.question);
  page << "</p>\n</header>\n"_html << tiles(source) << played_section(source.played) << point_of_view(source);
  for (const auto part :
       {standing_section, curves_section, goals_section, roles_section, packets_section, plugins_section,
        variance_section, unplayed_section_of, failures_section, recordings_section, configuration_section}) {
    page << part(source);
  }
  page << again_section(source.played, source.results) << remarks_note(source.view.course.remarks()) << page_end();
  return page.str();
}

}  // namespace regista::report
