// SPDX-License-Identifier: MIT
// `regista rank RESULTS.csv`: a ranking of teams by results from elsewhere, without playing any.
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "output/output.hpp"
#include "report/results_ranking.hpp"
#include "study/results_table.hpp"

namespace regista::cli {
namespace {

constexpr auto rank_notes =
    R"(RESULTS.csv: values separated by commas; the first line names the columns, in any order. Two columns, first and
second, name the teams. The results are, from the point of view of the first, one of
  LL,LD,DD,WD,WW     counts of pairs: both games lost, ..., both won; DD counts one win each, too
  wins,draws,losses  counts of games without pairs
  score              one game a line: 1, 0.5 or 0 points; two lines with the same text in a column "pair" are a pair
Lines of the same two teams add up.

Results: Elo by Bradley and Terry, sum 0, with intervals of 95 % by the spread of pairs, or of games where there are no
pairs. In JSON, null is what the results do not tell.

Examples:
  regista rank results.csv
  regista rank results.csv --json

Exit codes: 0 done; 1 the result could not be written; 2 bad input; 3 a defect of Regista.)";

struct RankOptions {
  std::vector<std::string> files;
  bool json = false;
};

}  // namespace

void add_rank(Command& parent) {
  Command& command = parent.add("rank", "rank teams by results from elsewhere");
  const auto options = std::make_shared<RankOptions>();
  command.take("results", options->files, "RESULTS.csv", "the results", Reads::data);
  command.flag("--json", options->json, "write the result as JSON");
  command.notes(rank_notes);
  command.run = [options] {
    if (options->files.size() != 1) {
      throw BadInput(
          fmt::format("rank: expected one file of results, {} given; see: regista rank --help", options->files.size()));
    }
    const report::RankedResults ranking = report::ranked(study::read_results_of_teams(options->files.front()));
    output::print(options->json ? report::ranking_json(ranking) : report::ranking_text(ranking));
    return exit_done;
  };
}

}  // namespace regista::cli
