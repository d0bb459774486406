// SPDX-License-Identifier: MIT
#include "report/tuning_page_parts.hpp"

#include <fmt/format.h>

#include "report/html_table.hpp"
#include "report/page_parts.hpp"
#include "report/tuning_problem.hpp"

namespace regista::report {
Html sentence_list(const std::vector<std::string>& sentences) {
  if (sentences.empty()) return {};
  Html out = "<ul>\n"_html;
  for (const std::string& each : sentences) out << "<li>"_html << text(each) << "</li>\n"_html;
  return out << "</ul>\n"_html;
}

Html note_paragraph(const std::string& sentence) {
  if (sentence.empty()) return {};
  Html out = "<p class=\"note\">"_html;
  return out << text(sentence) << "</p>\n"_html;
}

Html whole_number(std::uint64_t value) { return text(fmt::format("{}", value)); }

Html verdict_header(const std::string& title, const std::string& headline, const std::string& unfinished,
                    const std::string& question) {
  Html out = "<header>\n<p class=\"kicker\">Tuning: "_html;
  out << text(title) << "</p>\n<h1 id=\"verdict\">"_html << text(headline) << "</h1>\n<p class=\"beside\">"_html;
  if (!unfinished.empty()) out << text(unfinished) << " "_html;
  return out << text(question) << "</p>\n</header>\n"_html;
}

Html setup_section(const study::TuningPlan& plan, const std::vector<std::string>& sentences) {
  HtmlTable table({{"Parameter"_html, Column::words},
                   {"Start"_html},
                   {"Range"_html, Column::words},
                   {"Scale"_html, Column::words},
                   {"What it is"_html, Column::words}});
  for (const study::Parameter& each : plan.parameters) {
    table.row({path_code(each.path), text(text_of(each, each.start)), text(range_text(each)), text(scale_text(each)),
               text(each.doc)});
  }
  Html out = sentence_list(sentences);
  return section("setup", "How it was tuned"_html,
                 out << "<div class=\"values\">"_html << table.html() << "</div>\n"_html);
}

Html failures_section(const study::TuningPlan& plan, const study::ForfeitList& forfeits) {
  if (forfeits.listed().empty()) return {};
  HtmlTable table({{"By"_html, Column::words},
                   {"Matches"_html},
                   {"Plugin"_html, Column::words},
                   {"Call"_html, Column::words},
                   {"Reason"_html, Column::words},
                   {"First in match"_html}});
  for (const study::Forfeits& each : forfeits.listed()) {
    table.row({name(forfeiter(plan, each.team)), whole_number(each.count),
               each.failure.plugin.empty() ? plugin_cell(name(forfeiter(plan, each.team))) : text(each.failure.plugin),
               text(each.failure.call), text(each.failure.what), whole_number(each.first_match + 1)});
  }
  Html out =
      "<p>A forfeit of the tuned team counts against it; in the search it has the worst value. Pairs that another team "
      "forfeited are left out.</p>\n"
      "<div class=\"values\">"_html;
  out << table.html() << "</div>\n"_html;
  if (forfeits.unlisted() > 0) out << note_paragraph(fmt::format("{} more for other reasons.", forfeits.unlisted()));
  return section("failures", "Forfeits"_html, out);
}

}  // namespace regista::report
