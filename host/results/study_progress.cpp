// SPDX-License-Identifier: MIT
#include "results/study_progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>

#include <algorithm>

#include "command/end_of_program.hpp"
#include "command/terminal.hpp"

namespace regista::results {
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

StudyProgress::StudyProgress(const report::StudyReport& report, bool wanted)
    : report_(report), wanted_(wanted), rewrite_(wanted && command::can_rewrite()) {}

StudyProgress::~StudyProgress() { clear(); }

void StudyProgress::begin() {
  if (!rewrite_) return;
  show(fmt::format("0 of {} matches, the first is being played\n", report_.study().most_matches()));
}

void StudyProgress::match(const study::Round& round, std::uint64_t index, const campaign::Decided* decided,
                          bool fresh) {
  ++taken_;
  if (decided == nullptr) return;
  ++(fresh ? played_ : stored_);
  if (!wanted_) return;
  if (rewrite_) {
    if (Clock::now() - drawn_ >= between_drawings) draw();
    return;
  }
  if (!fresh) return;
  const std::uint64_t number = round.first_row + index + 1;
  command::say(fmt::format("match {} of {}, {}\n", number, report_.study().most_matches(),
                           report_.match(round, index, *decided)));
  if (number % between_standings == 0) command::say(block());
}

std::string StudyProgress::rate_text() const {
  const double seconds = std::chrono::duration<double>(Clock::now() - began_).count();
  return fmt::format("{:.2f} matches/s", static_cast<double>(played_) / std::max(seconds, 1e-3));
}

std::string StudyProgress::block() const {
  const std::uint64_t matches = report_.study().most_matches(), done = taken_;
  std::string text = report_.standing();
  text += fmt::format("{} of {} matches, {}", done, matches, rate_text());
  if (played_ > 0) {
    const double seconds = std::chrono::duration<double>(Clock::now() - began_).count();
    text += fmt::format(", at most {} left",
                        duration(static_cast<double>(matches - done) * seconds / static_cast<double>(played_)));
  }
  return text + '\n';
}

void StudyProgress::draw() {
  drawn_ = Clock::now();
  show(block());
}

void StudyProgress::show(const std::string& block) {
  const winsize size = terminal();
  const std::string text = cut(block, size.ws_col - std::size_t{1}, std::max<std::size_t>(size.ws_row, 2) - 1);
  clear();
  lines_ = static_cast<int>(std::ranges::count(text, '\n'));
  command::say(text);
}

void StudyProgress::print(std::string_view line) {
  clear();
  command::complain(line);
}

void StudyProgress::note(const std::string& line) {
  if (wanted_) command::say(line + '\n');
}

void StudyProgress::clear() {
  if (lines_ == 0) return;
  command::say(fmt::format("\x1b[{}F\x1b[J", lines_));
  lines_ = 0;
}

void StudyProgress::finish() {
  if (!wanted_) return;
  const double seconds = std::chrono::duration<double>(Clock::now() - began_).count();
  std::string out = fmt::format("{} matches played in {}", played_, duration(seconds));
  if (played_ > 0) out += fmt::format(", {}", rate_text());
  if (stored_ > 0) out += fmt::format("; {} were played before", stored_);
  command::say(out + '\n');
}

void StudyProgress::stopped() {
  if (wanted_ && taken_ > 0) command::say(outline_text(report_.outline()));
}

}  // namespace regista::results
