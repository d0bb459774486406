// SPDX-License-Identifier: MIT
#include "cli/tournament_progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>

#include <algorithm>
#include <filesystem>

#include "cli/end_of_program.hpp"
#include "cli/terminal.hpp"

namespace regista::cli {
namespace {

constexpr std::chrono::milliseconds between_drawings{200};
constexpr std::uint64_t between_standings = 200;  // matches, where each has a line

winsize terminal() {
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 0;
  return known ? size : winsize{24, 80, 0, 0};
}

// Lines no longer than the terminal is wide, so that as many can be taken away as were drawn. A byte counts as a
// column: what is cut is cut too soon rather than too late, and never within a character. And no more lines than
// `height`: the last ones.
std::string cut(std::string text, std::size_t width, std::size_t height) {
  auto lines = static_cast<std::size_t>(std::ranges::count(text, '\n'));
  for (; lines > height; --lines) text.erase(0, text.find('\n') + 1);
  std::string out;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::size_t length = std::min(end - begin, width);
    while (length > 0 && length < end - begin && (static_cast<unsigned char>(text[begin + length]) & 0xC0) == 0x80) {
      --length;
    }
    out += text.substr(begin, length) + '\n';
    begin = end + 1;
  }
  return out;
}

std::string duration(double seconds) {
  if (seconds < 90.0) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400.0) return fmt::format("{:.0f} min", seconds / 60.0);
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

}  // namespace

TournamentProgress::TournamentProgress(const report::TournamentView& view, bool wanted)
    : view_(view), wanted_(wanted), rewrite_(wanted && can_rewrite()) {}

TournamentProgress::~TournamentProgress() { clear(); }

void TournamentProgress::match(std::uint64_t index, const campaign::Decided* decided, bool fresh) {
  if (decided == nullptr) return;
  ++(fresh ? played_ : stored_);
  if (!wanted_) return;
  if (rewrite_) {
    if (Clock::now() - drawn_ >= between_drawings) draw();
    return;
  }
  if (!fresh) return;
  const study::Fixture fixture = view_.course.calendar().at(index);
  const auto& teams = view_.plan.teams;
  const auto& openings = view_.plan.openings;
  const std::string scene =
      openings.empty() ? "" : ", " + std::filesystem::path(openings[fixture.opening].file).stem().string();
  std::string line =
      fmt::format("match {} of {}, seed {}{}: {} {}:{} {}", index + 1, view_.course.calendar().matches(), fixture.seed,
                  scene, teams[fixture.home].label, decided->score[0], decided->score[1], teams[fixture.away].label);
  if (decided->failure) {
    const std::size_t loser = decided->failure->side == 0 ? fixture.home : fixture.away;
    line += ", " + report::forfeit_text(teams[loser].label, *decided->failure);
  }
  say(line + '\n');
  if ((index + 1) % between_standings == 0) say(block());
}

std::string TournamentProgress::rate_text() const {
  const double seconds = std::chrono::duration<double>(Clock::now() - began_).count();
  return fmt::format("{:.2f} matches/s", static_cast<double>(played_) / std::max(seconds, 1e-3));
}

std::string TournamentProgress::block() const {
  const std::uint64_t matches = view_.course.calendar().matches(), done = view_.course.taken();
  std::string text = fmt::format("{}\n{}", report::title(view_), report::standing_text(view_));
  text += fmt::format("{} of {} matches, {}", done, matches, rate_text());
  if (played_ > 0) {
    const double seconds = std::chrono::duration<double>(Clock::now() - began_).count();
    text += fmt::format(", at most {} left",
                        duration(static_cast<double>(matches - done) * seconds / static_cast<double>(played_)));
  }
  return text + '\n';
}

void TournamentProgress::draw() {
  drawn_ = Clock::now();
  const winsize size = terminal();
  const std::string text = cut(block(), size.ws_col - std::size_t{1}, std::max<std::size_t>(size.ws_row, 2) - 1);
  clear();
  lines_ = static_cast<int>(std::ranges::count(text, '\n'));
  say(text);
}

void TournamentProgress::begin() {
  if (!wanted_) return;
  for (const study::Pairing& pairing : view_.course.calendar().pairings()) {
    if (!study::equal_teams(view_.plan, pairing)) continue;
    say(fmt::format("A/A: {} and {} are equal, so every pair is a draw by construction\n",
                    view_.plan.teams[pairing.first].label, view_.plan.teams[pairing.second].label));
  }
}

void TournamentProgress::tell(std::string_view line) {
  clear();
  complain(line);
}

void TournamentProgress::clear() {
  if (lines_ == 0) return;
  say(fmt::format("\x1b[{}F\x1b[J", lines_));
  lines_ = 0;
}

void TournamentProgress::finish() {
  if (!wanted_) return;
  const double seconds = std::chrono::duration<double>(Clock::now() - began_).count();
  std::string out = fmt::format("{} matches played in {}", played_, duration(seconds));
  if (played_ > 0) out += fmt::format(", {}", rate_text());
  if (stored_ > 0) out += fmt::format("; {} were played before", stored_);
  say(out + '\n');
}

void TournamentProgress::stopped() {
  if (wanted_ && view_.course.matches() > 0) say(report::tournament_text(view_));
}

}  // namespace regista::cli
