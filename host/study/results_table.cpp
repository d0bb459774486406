// SPDX-License-Identifier: MIT
#include "study/results_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "study/table.hpp"
#include "texts/message.hpp"

namespace regista::study {
namespace {

using statistics::Encounter;
using statistics::GameOutcome;

const std::array<std::string, 5> pair_columns{"LL", "LD", "DD", "WD", "WW"};
const std::array<std::string, 3> game_columns{"losses", "draws", "wins"};  // in the order of GameCounts

enum class Layout { pairs, games, game_a_line };

constexpr auto layouts = "LL, LD, DD, WD, WW (pairs), wins, draws, losses (games), or score (a game a line)";

void refuse_unknown_columns(const Table& table) {
  std::vector<std::string> known{"first", "second", "wins", "draws", "losses", "score", "pair"};
  known.insert(known.end(), pair_columns.begin(), pair_columns.end());
  for (std::size_t i = 0; i < table.columns().size(); ++i) {
    const std::string& name = table.columns()[i];
    if (std::ranges::find(known, name) == known.end()) {
      throw config::Error(table.where(i), texts::unknown("column", name, "", known));
    }
    if (std::ranges::count(table.columns(), name) > 1) {
      throw config::Error(table.where(i), fmt::format("column {} stands twice", texts::in_quotes(name)));
    }
  }
}

Layout layout_of(const Table& table) {
  const auto has = [&](const std::string& name) { return table.has_column(name); };
  const bool pairs = std::ranges::any_of(pair_columns, has), games = std::ranges::any_of(game_columns, has),
             game = has("score");
  if (pairs + games + game != 1) {
    throw config::Error(table.where(0), fmt::format("{} columns of results; expected {}",
                                                    pairs + games + game == 0 ? "no" : "two kinds of", layouts));
  }
  if (has("pair") && !game) {
    throw config::Error(table.where(table.column("pair")), "column \"pair\" needs a column \"score\"");
  }
  return pairs ? Layout::pairs : games ? Layout::games : Layout::game_a_line;
}

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : table_(file) {
    refuse_unknown_columns(table_);
    layout_ = layout_of(table_);
    first_ = table_.column("first");
    second_ = table_.column("second");
    if (layout_ == Layout::pairs) {
      for (const std::string& each : pair_columns) counts_.push_back(table_.column(each));
    } else if (layout_ == Layout::games) {
      for (const std::string& each : game_columns) counts_.push_back(table_.column(each));
    } else {
      counts_.push_back(table_.column("score"));
      if (table_.has_column("pair")) pair_ = table_.column("pair");
    }
    start_ = table_.where(0);
  }

  ResultsOfTeams read() {
    while (table_.next()) take_line();
    // Of several the one that stands first.
    std::optional<config::Location> alone;
    for (const auto& [key, game] : open_) {
      if (!game.complete && (!alone || game.where.line < alone->line)) alone = game.where;
    }
    if (alone) throw config::Error(*alone, "this pair has one game; expected two");
    const auto played = [](const Encounter& each) { return each.games_played() > 0; };
    if (std::ranges::none_of(out_.encounters, played)) throw config::Error({start_.file}, "holds no game");
    return std::move(out_);
  }

 private:
  struct Game {
    GameOutcome outcome;
    config::Location where;
    bool complete = false;
  };

  void take_line() {
    const std::size_t first = team(first_), second = team(second_);
    if (first == second) table_.refuse(second_, "stands on both sides; expected two different teams");
    const bool turned = first > second;
    const auto [place, is_new] =
        encounter_.try_emplace({std::min(first, second), std::max(first, second)}, out_.encounters.size());
    if (is_new) out_.encounters.push_back({std::min(first, second), std::max(first, second), {}, {}});
    Encounter& encounter = out_.encounters[place->second];
    if (layout_ == Layout::game_a_line) {
      take_game(encounter, place->second, turned);
    } else if (layout_ == Layout::pairs) {
      add(encounter.pairs, counts<statistics::PairCounts>(), turned);
    } else {
      add(encounter.games, counts<statistics::GameCounts>(), turned);
    }
  }

  std::size_t team(std::size_t column) {
    const std::string name(table_.text(column));
    if (name.empty()) table_.refuse(column, "is no name of a team");
    const auto [place, is_new] = team_.try_emplace(name, out_.teams.size());
    if (is_new) {
      if (out_.teams.size() == most_ranked_teams) {
        table_.refuse(column, fmt::format("is one team too many: at most {} can be ranked", most_ranked_teams));
      }
      out_.teams.push_back(name);
    }
    return place->second;
  }

  template <class Counts>
  Counts counts() const {
    Counts out;
    for (std::size_t i = 0; i < counts_.size(); ++i) out.seen[i] = table_.count(counts_[i], statistics::most_counted);
    return out;
  }

  template <class Counts>
  void add(Counts& sum, const Counts& line, bool turned) const {
    const Counts mine = turned ? swapped(line) : line;
    for (std::size_t i = 0; i < mine.seen.size(); ++i) {
      sum.seen[i] += mine.seen[i];
      if (sum.seen[i] > statistics::most_counted) {
        table_.refuse(counts_.front(), fmt::format("brings the sum of these teams above {}", statistics::most_counted));
      }
    }
  }

  GameOutcome outcome(bool turned) const {
    using enum GameOutcome;
    const std::string_view score = table_.text(counts_.front());
    if (score == "0.5") return draw;
    if (score == "1") return turned ? loss : win;
    if (score != "0") table_.refuse(counts_.front(), "is no score; expected 1, 0.5 or 0");
    return turned ? win : loss;
  }

  void take_game(Encounter& encounter, std::size_t number, bool turned) {
    const GameOutcome now = outcome(turned);
    const std::string name(pair_ ? table_.text(*pair_) : std::string_view());
    if (name.empty()) {
      encounter.games.add(now);
      return;
    }
    const auto [game, is_new] = open_.try_emplace({number, name}, Game{now, table_.where(*pair_)});
    if (is_new) return;
    if (game->second.complete) table_.refuse(*pair_, "has two games already; a pair is two games");
    encounter.pairs.add(pair_outcome(game->second.outcome, now));
    game->second.complete = true;
  }

  Table table_;
  Layout layout_;
  std::size_t first_ = 0, second_ = 0;
  std::vector<std::size_t> counts_;
  std::optional<std::size_t> pair_;
  config::Location start_;
  ResultsOfTeams out_;
  std::map<std::string, std::size_t> team_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> encounter_;
  std::map<std::pair<std::size_t, std::string>, Game> open_;
};

}  // namespace

ResultsOfTeams read_results_of_teams(const std::filesystem::path& file) { return Reader(file).read(); }

}  // namespace regista::study
