// SPDX-License-Identifier: MIT
#include "cli/tournament_progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "cli/end_of_program.hpp"

namespace regista::cli {
namespace {

constexpr std::chrono::milliseconds between_drawings{200};

bool can_rewrite() {
  const char* const type = std::getenv("TERM");
  return isatty(STDERR_FILENO) != 0 && type != nullptr && std::string_view(type) != "dumb";
}

// What is lost of this is lost: it is no result.
void say(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

std::size_t columns() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : std::size_t{80};
}

// Lines no longer than the terminal is wide, so that as many can be taken away as were drawn. A byte counts as a
// column: what is cut is cut too soon rather than too late, and never within a character.
std::string cut(const std::string& text, std::size_t width) {
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
  std::string line =
      fmt::format("match {} of {}, seed {}: {} {}:{} {}", index + 1, view_.course.calendar().matches(), fixture.seed,
                  teams[fixture.home].label, decided->score[0], decided->score[1], teams[fixture.away].label);
  if (decided->failure) {
    const std::size_t loser = decided->failure->side == 0 ? fixture.home : fixture.away;
    line += ", " + report::forfeit_text(teams[loser].label, *decided->failure);
  }
  say(line + '\n');
}

std::string TournamentProgress::rate_text() const {
  const double seconds = std::chrono::duration<double>(Clock::now() - began_).count();
  return fmt::format("{:.2f} matches/s", static_cast<double>(played_) / std::max(seconds, 1e-3));
}

void TournamentProgress::draw() {
  drawn_ = Clock::now();
  const std::uint64_t matches = view_.course.calendar().matches(), done = view_.course.taken();
  std::string text = fmt::format("{}\n{}", report::title(view_), report::standing_text(view_));
  text += fmt::format("{} of {} matches, {}", done, matches, rate_text());
  if (played_ > 0) {
    const double seconds = std::chrono::duration<double>(drawn_ - began_).count();
    text += fmt::format(", at most {} left",
                        duration(static_cast<double>(matches - done) * seconds / static_cast<double>(played_)));
  }
  const std::string block = cut(text + '\n', columns() - 1);
  clear();
  lines_ = static_cast<int>(std::ranges::count(block, '\n'));
  say(block);
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

std::string TournamentProgress::summary() const {
  if (!wanted_) return "";
  const double seconds = std::chrono::duration<double>(Clock::now() - began_).count();
  std::string out = fmt::format("{} matches played in {}", played_, duration(seconds));
  if (played_ > 0) out += fmt::format(", {}", rate_text());
  if (stored_ > 0) out += fmt::format("; {} were played before", stored_);
  return out + '\n';
}

}  // namespace regista::cli
