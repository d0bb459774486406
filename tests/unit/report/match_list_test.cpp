// SPDX-License-Identifier: MIT
#include "report/matches_section.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <vector>

#include "study/study.hpp"
#include "texts/html.hpp"

namespace regista::report {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

ListedMatch played(std::uint64_t row, int home, int away, const char* first = "a", const char* second = "b") {
  campaign::MatchResult decided;
  decided.score = {home, away};
  decided.hash = "0123456789abcdef";
  decided.seconds = static_cast<double>(row);
  return listed(row, {{first, second}, "", row}, decided);
}

ListedMatch forfeited(std::uint64_t row, int side) {
  campaign::Failure failure;
  failure.side = side;
  failure.plugin = "crashes";
  failure.call = "holds";
  failure.what = "Segmentation fault";
  return listed(row, {{"a", "b"}, "", row}, campaign::forfeit(failure, 1.0));
}

std::vector<std::uint64_t> rows(const std::vector<ListedMatch>& matches) {
  std::vector<std::uint64_t> out;
  for (const ListedMatch& each : matches) out.push_back(each.row);
  return out;
}

TEST(MatchList, KeepsTheClearestWinsOfEachSide) {
  MatchList list(2);
  list.take(played(1, 2, 0));
  list.take(played(2, 1, 1));
  list.take(played(3, 0, 5));  // b's
  list.take(played(4, 3, 0));
  list.take(played(5, 4, 1));  // as clear, but b has scored
  list.take(played(6, 0, 1, "b", "a"));
  const auto clearest = list.clearest();
  ASSERT_EQ(clearest.size(), 2u);
  EXPECT_EQ(clearest[0].side, "b");  // its win by five is the clearest of all
  EXPECT_THAT(rows(clearest[0].clearest), ElementsAre(3));
  EXPECT_EQ(clearest[1].side, "a");
  EXPECT_THAT(rows(clearest[1].clearest), ElementsAre(4, 5));
}

// As sorting all of them finds them.
TEST(MatchList, TheClearestOfManyAreThoseOfSortingAll) {
  std::mt19937 chance(7);
  std::uniform_int_distribution<int> goals(0, 9);
  MatchList list;
  std::vector<ListedMatch> wins;
  for (std::uint64_t row = 1; row <= 5000; ++row) {
    const ListedMatch match = played(row, goals(chance), goals(chance));
    list.take(match);
    if (match.score[0] > match.score[1]) wins.push_back(match);
  }
  std::ranges::stable_sort(wins, [](const ListedMatch& one, const ListedMatch& other) {
    if (one.difference() != other.difference()) return one.difference() > other.difference();
    return one.score[1] < other.score[1];
  });
  wins.resize(MatchList::clearest_of_a_side);
  const auto clearest = list.clearest();
  const auto found = std::ranges::find(clearest, "a", &MatchList::Wins::side);
  ASSERT_NE(found, clearest.end());
  EXPECT_EQ(rows(found->clearest), rows(wins));
  EXPECT_EQ(list.count(), 5000u);
  EXPECT_EQ(list.first().size(), MatchList::most_listed);
}

TEST(MatchList, TellsInTurnAWinOfEachSideAndAForfeit) {
  MatchList list;
  list.take(forfeited(1, 0));
  list.take(forfeited(2, 1));
  list.take(played(3, 3, 0));
  list.take(played(4, 2, 0));
  list.take(played(5, 0, 1));
  EXPECT_THAT(rows(list.highlights(3)), ElementsAre(3, 5, 1));
  EXPECT_THAT(rows(list.highlights(4)), ElementsAre(3, 5, 1, 4));
  EXPECT_THAT(rows(list.highlights(9)), ElementsAre(3, 5, 1, 4, 2));
  EXPECT_TRUE(MatchList().highlights(5).empty());
}

TEST(MatchList, NamesAMatchByWhoPlayedAndByItsCourse) {
  const ListedMatch match = played(1, 1, 0);
  ListedMatch other = match;
  EXPECT_EQ(fingerprint_of(match), fingerprint_of(other));
  other.hash = "0123456789abcdee";
  EXPECT_NE(fingerprint_of(match), fingerprint_of(other));
  other = match;
  other.players.sides[1] = "c";
  EXPECT_NE(fingerprint_of(match), fingerprint_of(other));
  EXPECT_NE(fingerprint_of(forfeited(1, 0)), fingerprint_of(forfeited(1, 1)));
}

TEST(Replays, ANoteIsReadAsItWasWritten) {
  const ReplayNote note{fingerprint_of(played(1, 1, 0)), false, 354.25};
  const auto read = replay_note("<!DOCTYPE html>\n<head>" + replay_mark(note).str() + "<title>x</title>");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->match, note.match);
  EXPECT_FALSE(read->same);
  EXPECT_DOUBLE_EQ(read->opens, 354.25);
  for (const char* each :
       {"", "<meta name=\"regista-replay\" content=\"", "<meta name=\"regista-replay\" content=\"same\">",
        "<meta name=\"regista-replay\" content=\"same 0123 1.0\">",
        "<meta name=\"regista-replay\" content=\"maybe 0123456789abcdef0123456789abcdef 1.0\">",
        "<meta name=\"regista-replay\" content=\"same 0123456789abcdef0123456789abcdef x\">"})
    EXPECT_FALSE(replay_note(each)) << each;
}

TEST(Replays, APageOfAnotherMatchCountsForNone) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "replays_test",
                              results = folder / "night.db";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(study::replay_folder(results));
  const auto write = [&](std::int64_t row, const ReplayNote& note) {
    std::ofstream(study::replay_file(results, row)) << "<html><head>" << replay_mark(note).str();
  };
  write(1, {fingerprint_of(played(1, 1, 0)), true, 12.0});
  write(2, {fingerprint_of(played(1, 1, 0)), true, 12.0});  // of the first one
  write(3, {fingerprint_of(played(3, 2, 0)), false, 0.0});
  const FindReplay replays = replay_pages(results, folder / "elsewhere" / "page.html");
  const auto first = replays(played(1, 1, 0)), third = replays(played(3, 2, 0));
  ASSERT_TRUE(first && third);
  EXPECT_EQ(first->file, "../night.replays/1.html");
  EXPECT_EQ(first->fragment, "t=12.00");
  EXPECT_TRUE(first->same);
  EXPECT_FALSE(third->same);
  EXPECT_EQ(third->fragment, "");
  EXPECT_FALSE(replays(played(2, 2, 1)));
  EXPECT_FALSE(replays(played(4, 2, 1)));
  std::filesystem::remove_all(folder);
}

Outline with(Section section) {
  Outline out;
  out.add(std::move(section));
  return out;
}

TEST(MatchesSection, LinksWhatWasPlayedAgainAndSaysWhatCameOutOtherwise) {
  MatchList list;
  list.take(played(1, 3, 0, "<a>"));
  list.take(played(2, 0, 1));
  list.take(forfeited(3, 1));
  const MatchesOnPage page{"-night 1.db", true, [](const ListedMatch& match) -> std::optional<ReplayLink> {
                             if (match.row == 1) return ReplayLink{"night.replays/1.html", "t=5.00", true};
                             if (match.row == 2) return ReplayLink{"night.replays/2.html", "", false};
                             return std::nullopt;
                           }};
  const std::string text = outline_page(with(matches_section(list, page)), "night.db", {});
  EXPECT_THAT(text, HasSubstr("<a href=\"./night.replays/1.html#t=5.00\">watch</a>"));
  EXPECT_THAT(text, HasSubstr("<a href=\"./night.replays/2.html\">came out otherwise</a>"));
  EXPECT_THAT(text, HasSubstr("forfeit of <bdi>b</bdi>: plugin crashes, holds: Segmentation fault"));
  EXPECT_THAT(text, HasSubstr("regista view &#39;./-night 1.db&#39; --row 1"));
  EXPECT_THAT(text, Not(HasSubstr("<a>")));
  const std::string beside = html(ways_to_matches(list, page)).str();
  EXPECT_THAT(beside, HasSubstr("<a href=\"./night.replays/1.html#t=5.00\">&lt;a&gt; 3:0 b</a>"));
  EXPECT_THAT(beside, HasSubstr("<a href=\"#matches\">the matches</a>"));
  EXPECT_TRUE(matches_section(MatchList(), page).empty());
}

// A page is to be opened and sent by mail, however long the study.
TEST(MatchesSection, ManyMatchesMakeNoLargePage) {
  MatchList list;
  for (std::uint64_t row = 1; row <= 100'000; ++row)
    list.take(row % 7 == 0 ? forfeited(row, 0) : played(row, row == 99'999 ? 9 : 1, 0));
  const MatchesOnPage page{"night.db", true, [](const ListedMatch&) { return std::nullopt; }};
  const std::string text = outline_page(with(matches_section(list, page)), "night.db", {});
  EXPECT_LT(text.size(), 1'000'000u);
  EXPECT_THAT(text, HasSubstr("The first 2000 of 100000 matches"));
  EXPECT_THAT(text, HasSubstr("regista report night.db --csv"));
  EXPECT_THAT(text, HasSubstr(">9:0<"));
  EXPECT_THAT(text, HasSubstr("14085 more matches were forfeited."));
}

}  // namespace
}  // namespace regista::report
