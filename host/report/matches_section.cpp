// SPDX-License-Identifier: MIT
#include "report/matches_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <system_error>
#include <tuple>
#include <utility>

#include "plugin/shared_object.hpp"
#include "process/child.hpp"
#include "study/study.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

bool clearer(const ListedMatch& one, const ListedMatch& other) {
  const auto order = [](const ListedMatch& match) {
    return std::tuple(-std::abs(match.difference()), std::min(match.score[0], match.score[1]), match.row);
  };
  return order(one) < order(other);
}

using texts::Html;
using texts::Markup;
using texts::text;
using texts::operator""_html;

constexpr auto id = "matches";
constexpr std::size_t most_beside = 4;  // largest number of links to matches beside the headline

std::string score_text(const ListedMatch& match) {
  if (!match.played() && !match.forfeited_by) return "–";
  return fmt::format("{}:{}", match.score[0], match.score[1]);
}

Sentence end_of(const ListedMatch& match) {
  if (match.forfeited_by)
    return Sentence("forfeit of ") << named(match.players.sides[static_cast<std::size_t>(*match.forfeited_by)]);
  return match.played() ? Sentence() : Sentence("could not be played");
}

Cell replay_cell(const ListedMatch& match, const MatchesOnPage& page) {
  const std::optional<ReplayLink> link = page.replay(match);
  if (!link) return {};
  Cell out = Sentence::link_to(link->same ? "watch" : "came out otherwise", link->file, link->fragment);
  out.stressed = !link->same;
  return out;
}

void leave_out_empty_columns(Table& table) {
  for (std::size_t column = table.headings.size(); column-- > 0;) {
    const auto is_empty = [column](const Row& row) { return row.cells[column].words.empty(); };
    if (!std::ranges::all_of(table.rows, is_empty)) continue;
    const auto place = static_cast<std::ptrdiff_t>(column);
    table.headings.erase(table.headings.begin() + place);
    for (Row& each : table.rows) each.cells.erase(each.cells.begin() + place);
  }
}

// Returns a table with the given columns, followed by the columns that all tables of matches have.
Table table_of(std::vector<Heading> first) {
  Table out(std::move(first));
  out.headings.insert(out.headings.end(), {{"Row"},
                                           {"Home – away", Column::words},
                                           {"Score"},
                                           {"Seed"},
                                           {"Opening", Column::words},
                                           {"Replay", Column::words}});
  return out;
}

void add(Table& table, std::vector<Cell> cells, const ListedMatch& match, const MatchesOnPage& page) {
  cells.insert(cells.end(),
               {match.row, named(match.players.sides[0]) << " – " << named(match.players.sides[1]), score_text(match),
                match.players.seed, named(match.players.opening), replay_cell(match, page)});
  table.row(std::move(cells));
}

Table clearest_table(const MatchList& matches, const MatchesOnPage& page) {
  Table out = table_of({{"Clearest", Column::words}});
  for (const auto& [side, wins] : matches.clearest()) {
    for (const ListedMatch& each : wins) add(out, {Sentence("won by ") << named(side)}, each, page);
  }
  for (const ListedMatch& each : matches.forfeits())
    add(out, {end_of(each) << ": " + texts::one_line(each.why)}, each, page);
  leave_out_empty_columns(out);
  return out;
}

namespace fs = std::filesystem;

constexpr Markup before = "<meta name=\"regista-replay\" content=\""_html;
constexpr std::string_view same = "same ", other = "other ";
constexpr std::size_t digits = 32;

std::string beginning_of(const fs::path& file) {
  constexpr std::size_t enough = 2048;  // bytes
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return {};  // the reader of a pipe may wait without end
  std::string out(enough, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(out.data(), static_cast<std::streamsize>(out.size()));
  return out;
}

}  // namespace

std::optional<std::size_t> ListedMatch::winner() const {
  if (!played() || difference() == 0) return std::nullopt;
  return difference() > 0 ? 0 : 1;
}

ListedMatch listed(std::uint64_t row, MatchPlayers players, const campaign::MatchResult& decided) {
  ListedMatch out{.row = row,
                  .players = std::move(players),
                  .score = decided.score,
                  .hash = decided.hash,
                  .forfeited_by = {},
                  .why = decided.why_set_aside,
                  .seconds = decided.seconds};
  if (decided.failure) {
    const campaign::Failure& failure = *decided.failure;
    out.forfeited_by = failure.side;
    out.why = failure.plugin.empty() ? failure.what
                                     : fmt::format("plugin {}, {}: {}", failure.plugin, failure.call, failure.what);
  }
  return out;
}

std::string fingerprint_of(const ListedMatch& match) {
  const std::string end = match.forfeited_by ? fmt::format("forfeit {}", *match.forfeited_by)
                          : match.played()   ? match.hash
                                             : std::string("not played");
  return plugin::content_hash(fmt::format("{}\n{}\n{}\n{}\n{}", match.players.sides[0], match.players.sides[1],
                                          match.players.opening, match.players.seed, end));
}

void MatchList::take(ListedMatch match) {
  ++count_;
  if (match.forfeited_by) {
    ++forfeit_count_;
    if (forfeits_.size() < most_forfeits) forfeits_.push_back(match);
  } else if (const std::optional<std::size_t> side = match.winner(); side && of_a_side_ > 0) {
    std::vector<ListedMatch>& wins = wins_[match.players.sides[*side]];
    if (wins.size() < of_a_side_ || clearer(match, wins.back())) {
      if (wins.size() == of_a_side_) wins.pop_back();
      wins.insert(std::ranges::upper_bound(wins, match, clearer), match);
    }
  }
  if (first_.size() < most_listed) first_.push_back(std::move(match));
}

std::vector<MatchList::Wins> MatchList::clearest() const {
  std::vector<Wins> out;
  for (const auto& [side, wins] : wins_) out.push_back({side, wins});
  std::ranges::sort(out, clearer, [](const Wins& wins) -> const ListedMatch& { return wins.clearest.front(); });
  return out;
}

double MatchList::usual_seconds() const {
  std::vector<double> seconds;
  for (const ListedMatch& each : first_) {
    if (each.seconds) seconds.push_back(*each.seconds);
  }
  if (seconds.empty()) return 0.0;
  const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
  std::ranges::nth_element(seconds, middle);
  return *middle;
}

std::vector<ListedMatch> MatchList::highlights(std::size_t most) const {
  const std::vector<Wins> wins = clearest();
  std::vector<const std::vector<ListedMatch>*> queues;
  for (const Wins& each : wins) queues.push_back(&each.clearest);
  queues.push_back(&forfeits_);
  std::vector<ListedMatch> out;
  for (std::size_t i = 0, found = 1; out.size() < most && found > 0; ++i) {
    found = 0;
    for (const auto* const queue : queues) {
      if (i >= queue->size() || out.size() == most) continue;
      out.push_back((*queue)[i]);
      ++found;
    }
  }
  return out;
}

std::string as_argument(const std::string& path) { return path.starts_with('-') ? "./" + path : path; }

Section matches_section(const MatchList& matches, const MatchesOnPage& page) {
  Section out(id, "Matches");
  if (matches.count() == 0) return out;
  const std::string results = as_argument(page.results);
  const std::vector<ListedMatch> clear = matches.highlights(1);
  const std::uint64_t example = clear.empty() ? matches.first().front().row : clear.front().row;
  out.note(Sentence("To watch a match: ")
           << code(process::command_line({"view", results, "--row", std::to_string(example)}))
           << " plays this one again and writes its page; "
           << code(process::command_line({"report", results, "--replays", "5"}))
           << " does so for the clearest ones and links them here.");
  out.table(clearest_table(matches, page));
  if (const std::uint64_t more = matches.forfeit_count() - matches.forfeits().size(); more > 0)
    out.note(fmt::format("{} forfeited.", texts::plural(more, "more match was", "more matches were")));
  Table all = table_of({});
  all.headings.push_back({"End", Column::words});
  for (const ListedMatch& each : matches.first()) {
    add(all, {}, each, page);
    all.rows.back().cells.emplace_back(end_of(each));
  }
  leave_out_empty_columns(all);
  const bool cut = matches.count() > matches.first().size();
  all.summary = cut ? fmt::format("The first {} of {} matches", matches.first().size(), matches.count())
                    : fmt::format("All {}", texts::plural(matches.count(), "match", "matches"));
  all.sortable = true;
  out.table(std::move(all));
  if (cut && page.has_table)
    out.note(Sentence("All of them: ") << code(process::command_line({"report", results, "--csv"})));
  return out;
}

Sentence ways_to_matches(const MatchList& matches, const MatchesOnPage& page) {
  if (matches.count() == 0) return {};
  Sentence out;
  for (const ListedMatch& each : matches.highlights(most_beside)) {
    const std::optional<ReplayLink> link = page.replay(each);
    if (!link) continue;
    out << (out.empty() ? "Watch " : ", ")
        << Sentence::link_to(fmt::format("{} {} {}", each.players.sides[0], score_text(each), each.players.sides[1]),
                             link->file, link->fragment);
    if (!link->same) out << " (came out otherwise)";
  }
  out << (out.empty() ? "See " : "; or ") << Sentence::link_to("the matches", "", id) << ".";
  return out;
}

Html replay_mark(const ReplayNote& note) {
  return Html(before) << text(fmt::format("{}{} {:.2f}", note.same ? same : other, note.match, note.opens))
                      << "\">\n"_html;
}

std::optional<ReplayNote> replay_note(std::string_view beginning) {
  const std::size_t at = beginning.find(before.view());
  if (at == std::string_view::npos) return std::nullopt;
  std::string_view rest = beginning.substr(at + before.view().size());
  rest = rest.substr(0, rest.find('"'));
  ReplayNote out;
  out.same = rest.starts_with(same);
  if (!out.same && !rest.starts_with(other)) return std::nullopt;
  rest.remove_prefix(out.same ? same.size() : other.size());
  if (rest.size() <= digits || rest[digits] != ' ') return std::nullopt;
  out.match = rest.substr(0, digits);
  const auto [end, wrong] = std::from_chars(rest.data() + digits + 1, rest.data() + rest.size(), out.opens);
  if (wrong != std::errc() || end != rest.data() + rest.size()) return std::nullopt;
  return out;
}

std::set<std::uint64_t> numbered_files(const fs::path& folder, std::string_view extension) {
  std::set<std::uint64_t> out;
  std::error_code error;
  for (fs::directory_iterator each(folder, error), end; !error && each != end; each.increment(error)) {
    const std::string name = each->path().filename().string();
    std::uint64_t number = 0;
    const auto [rest, wrong] = std::from_chars(name.data(), name.data() + name.size(), number);
    if (wrong == std::errc() && name == fmt::format("{}{}", number, extension)) out.insert(number);
  }
  return out;
}

FindReplay replay_pages(const fs::path& results, const fs::path& page) {
  const fs::path folder = study::replay_folder(results);
  const fs::path from_page = fs::absolute(folder).lexically_relative(fs::absolute(page).parent_path());
  return [folder, from_page,
          rows = numbered_files(folder, ".html")](const ListedMatch& match) -> std::optional<ReplayLink> {
    if (!rows.contains(match.row)) return std::nullopt;
    const std::string name = std::to_string(match.row) + ".html";
    const std::optional<ReplayNote> note = replay_note(beginning_of(folder / name));
    if (!note || note->match != fingerprint_of(match)) return std::nullopt;
    return ReplayLink{(from_page / name).generic_string(),
                      note->opens > 0.0 ? fmt::format("t={:.2f}", note->opens) : "", note->same};
  };
}

}  // namespace regista::report
