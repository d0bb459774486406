// SPDX-License-Identifier: MIT
#include "report/tuning_tables.hpp"

#include <fmt/format.h>

#include "report/match_remarks.hpp"
#include "report/text_table.hpp"
#include "report/tournament.hpp"
#include "report/tuning_problem.hpp"
#include "texts/visible.hpp"

namespace regista::report {

std::string paragraph(const char* title, const std::vector<std::string>& sentences) {
  if (sentences.empty()) return {};
  std::string out = fmt::format("\n{}\n", title);
  for (const std::string& each : sentences) out += fmt::format("  {}\n", each);
  return out;
}

std::string indented(const std::string& lines) {
  std::string out = "  ";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    out += lines[i];
    if (lines[i] == '\n' && i + 1 < lines.size()) out += "  ";
  }
  return out;
}

std::string parameters_table(const study::TuningPlan& plan) {
  TextTable table;
  table.row({"parameter", "start", "range", "scale"});
  for (const study::Parameter& each : plan.parameters) {
    table.row({texts::visible(each.path), text_of(each, each.start), range_text(each), scale_text(each)});
  }
  return "\nParameters\n" + indented(table.text());
}

std::string forfeits_text(const study::TuningPlan& plan, const study::MatchTally& tally) {
  std::string out;
  for (const study::Forfeits& each : tally.forfeits.listed()) {
    out += fmt::format("  {} {}\n", each.count == 1 ? "1 match" : fmt::format("{} matches", each.count),
                       texts::visible(forfeit_text(forfeiter(plan, each.team), each.failure)));
  }
  const std::uint64_t more = tally.forfeits.unlisted();
  if (more > 0) out += fmt::format("  {} more {} forfeited for other reasons\n", more, more == 1 ? "was" : "were");
  if (out.empty()) return out;
  return "\nForfeits: one of the tuned team counts against it and has the worst value in the search; "
         "pairs "
         "with others' are left out\n" +
         out;
}

std::string left_out_text(const study::MatchTally& tally) {
  if (tally.unplayed_pairs == 0) return {};
  return fmt::format("\nLeft out: {} that could not be played; no team can be blamed\n",
                     pairs_in_words(tally.unplayed_pairs)) +
         unplayed_text(tally.remarks);
}

}  // namespace regista::report
